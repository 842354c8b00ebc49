// What Doxygen knows about code/: namespaces, structs and their members, with an address in the book for each.
import { existsSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { fromSource } from './claims.mjs';
import { headerPage, titleOf } from './namespaces.mjs';
import { slug } from './text.mjs';
import { loadXml, plainText } from './xml.mjs';

const TYPES = ['struct', 'class', 'concept'];

export function readApi(xml, source) {
  const api = Object.fromEntries(
    ['compounds', 'headers', 'hrefs', 'names', 'anchors', 'linkers'].map(name => [name, new Map()]),
  );
  for (const file of existsSync(xml) ? readdirSync(xml).sort() : []) {
    if (!/^(namespace|struct|class|concept).*\.xml$|_8h\.xml$/.test(file)) continue;
    const $ = loadXml(join(xml, file));
    $('doxygen > compounddef').each((_, e) =>
      e.attribs.kind === 'file' ? addHeader(api, e, source) : addCompound(api, $, e, source),
    );
  }
  api.namespaces = [...api.compounds.values()]
    .filter(c => c.kind === 'namespace' && !c.name.includes('::'))
    .map(compound => ({ name: compound.name, title: titleOf(compound.name), compound }))
    .sort((a, b) => a.title.localeCompare(b.title, 'en'));
  for (const header of api.headers.values()) fillHeader(api, header);
  return api;
}

const child = (e, name) => e.children.find(c => c.name === name);
const children = (e, name) => e.children.filter(c => c.name === name);
const textOf = e => (e ? plainText(e).replace(/\s+/g, ' ').trim() : '');

function addHeader(api, e, source) {
  const about = description(e, source);
  const href = headerPage(about.file);
  if (href) api.headers.set(about.file, { name: textOf(child(e, 'compoundname')), href, ...about, line: 1 });
}

function fillHeader(api, header) {
  const within = [...api.compounds.values()]
    .filter(c => c.isType && c.file === header.file)
    .map(c => ({ ...c, name: c.name.split('::').at(-1) }));
  const members = api.namespaces.flatMap(({ compound }) => compound.members).filter(m => m.file === header.file);
  Object.assign(header, {
    types: within,
    functions: members.filter(m => m.kind === 'function'),
    constants: members.filter(m => m.kind !== 'function' && m.documented),
  });
}

function addCompound(api, $, e, source) {
  const name = textOf(child(e, 'compoundname'));
  const { kind, id, prot } = e.attribs;
  if (prot === 'private' || /\bdetail\b|@|^std\b/.test(name) || (kind !== 'namespace' && !name.includes('::'))) return;
  const about = description(e, source);
  const compound = {
    kind,
    name,
    ...address(api, name, kind, about.file),
    ...about,
    templates: templates(e),
    members: [],
    inner: children(e, 'innerclass').map(textOf),
    innerNamespaces: children(e, 'innernamespace').map(textOf),
  };
  compound.isType = TYPES.includes(kind);
  compound.initializer = textOf(child(e, 'initializer'));
  api.compounds.set(name, compound);
  api.hrefs.set(id, compound.href);
  api.names.set(name, { href: compound.href, isType: compound.isType });
  for (const member of $(e).find('> sectiondef > memberdef').get()) addMember(api, compound, member, source);
}

const dashed = name => slug(name.replace(/([a-z])([A-Z])/g, '$1-$2'));

// A type has a page of its own, or stands on the page of its header.
function address(api, name, kind, file) {
  const header = kind === 'namespace' ? null : headerPage(file);
  const parts = name.replace(/<.*/, '').split('::').map(dashed);
  if (!header) return { page: `${parts.join('-')}.html`, href: `${parts.join('-')}.html`, anchor: '' };
  const anchor = unused(api, header, parts.at(-1));
  return { page: header, href: `${header}#${anchor}`, anchor };
}

function unused(api, page, base) {
  const times = (api.anchors.get(`${page}#${base}`) ?? 0) + 1;
  api.anchors.set(`${page}#${base}`, times);
  return times > 1 ? `${base}-${times}` : base;
}

function addMember(api, compound, e, source) {
  if (e.attribs.prot === 'private' || e.attribs.kind === 'friend') return;
  const name = textOf(child(e, 'name'));
  const about = description(e, source);
  const page = headerPage(about.file) ?? compound.page;
  const anchor = unused(
    api,
    page,
    [compound.anchor, slug(name.replace('operator()', 'call')) || 'operator'].filter(Boolean).join('-'),
  );
  const member = {
    kind: e.attribs.kind,
    name,
    anchor,
    href: `${page}#${anchor}`,
    ...about,
    templates: templates(e),
    type: textOf(child(e, 'type')),
    initializer: textOf(child(e, 'initializer')),
    parameters: children(e, 'param').map(parameter),
    suffix: textOf(child(e, 'argsstring')).replace(/^\(.*\)/, ''),
    documented: false,
  };
  member.documented = Boolean(textOf(member.brief) || textOf(member.details));
  if (checksTypes(member)) return;
  compound.members.push(member);
  api.hrefs.set(e.attribs.id, member.href);
  const qualified = `${compound.name}::${name}`;
  if (!api.names.has(qualified)) api.names.set(qualified, { href: member.href, isType: false, file: member.file });
}

// A template without parameters and without a comment for readers is asked by its own header alone, whether types will do.
const checksTypes = ({ kind, templates: types, parameters, documented }) =>
  kind === 'function' && types.length > 0 && parameters.length === 0 && !documented;

function description(e, source) {
  const location = child(e, 'location')?.attribs ?? {};
  return {
    brief: child(e, 'briefdescription'),
    details: child(e, 'detaileddescription'),
    file: fromSource(source, location.file ?? ''),
    line: Number(location.line ?? 0),
  };
}

const parameter = e => ({
  type: textOf(child(e, 'type')),
  name: textOf(child(e, 'declname')),
  value: textOf(child(e, 'defval')),
});

const templates = e => children(child(e, 'templateparamlist') ?? { children: [] }, 'param').map(parameter);

// How code refers to the API: a full name always, a bare name if it is a type's, or if the file itself declares it.
export function linker(api, file = '') {
  if (!api.linkers.has(file)) api.linkers.set(file, linkerOf(api, file));
  return api.linkers.get(file);
}

function linkerOf(api, file) {
  const bare = new Map();
  for (const [name, target] of api.names) {
    const own = name.split('::').at(-1);
    if (target.isType) bare.set(own, bare.has(own) ? null : target.href);
  }
  for (const [name, target] of api.names) {
    if (file && target.file === file && name.split('::').length === 2) bare.set(name.split('::')[1], target.href);
  }
  return name => (name.includes('::') ? api.names.get(name)?.href : bare.get(name)) ?? null;
}
