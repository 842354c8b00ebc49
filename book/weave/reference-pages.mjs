// The code reference: a landing page, a page per namespace, a page per struct or per header that stands alone.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { headerList, headerPages } from './header-pages.mjs';
import { headerPage } from './namespaces.mjs';
import {
  brief,
  details,
  fields,
  include,
  memberSection,
  signature,
  summary,
  templateLine,
  where,
} from './reference-entries.mjs';
import { escapeHtml } from './text.mjs';

export function referencePages(book) {
  const { api } = book;
  checkNamespaces(book);
  const own = [...api.compounds.values()].filter(compound => !compound.isType || !headerPage(compound.file));
  return [
    landing(book),
    ...headerPages(book),
    ...own.map(compound => (compound.isType ? typePage(book, compound) : namespacePage(book, compound))),
  ];
}

function checkNamespaces(book) {
  const known = new Set([...book.api.compounds.values()].map(ownName));
  for (const path of [...book.sources].filter(path => /^code\/.*\.h$/.test(path))) {
    const lines = readFileSync(join(book.config.source, path), 'utf8').split('\n');
    lines.forEach((line, i) => {
      const name = line.match(/^namespace (\w+)/)?.[1];
      if (name && !known.has(name))
        book.problems.add(
          path,
          i + 1,
          `the code reference lacks the namespace ${name}; describe it in a /// comment above it, in one of its headers`,
        );
    });
  }
}

const byName = (a, b) => a.name.localeCompare(b.name, 'en');
const ownName = ({ name }) => name.split('::').at(-1);
const scopeOf = ({ name }) => name.split('::').slice(0, -1).join('::');
const inner = (book, names) =>
  names
    .map(name => book.api.compounds.get(name))
    .filter(Boolean)
    .map(c => ({ ...c, name: ownName(c) }))
    .sort(byName);

// What a reader comes for stands first: the headers to take.
function landing(book) {
  const namespaces = [...book.api.namespaces].sort((a, b) => hasHeaders(book, b) - hasHeaders(book, a));
  const groups = namespaces.map(
    ({ name, title, compound }) =>
      `<h2 id="${name}"><a href="${compound.href}">${escapeHtml(title)}</a></h2>\n<p>${brief(book, compound)}</p>\n` +
      (hasHeaders(book, { compound }) ? headers(book, compound) : summary(book, mainEntries(book, compound))),
  );
  return {
    href: 'reference.html',
    title: 'Code reference',
    kind: 'api',
    body: groups.join('\n'),
    sections: namespaces.map(({ name, title }) => ({ id: name, title })),
  };
}

const headers = (book, compound) =>
  `<p>Side by side, with what was measured of each: <a href="snippets.html">Snippets</a>.</p>\n${headerList(book, headersOf(book, compound))}`;

const headersOf = (book, { name }) =>
  [...book.api.headers.values()].filter(({ file }) => file.startsWith(`code/${name}/`));
const hasHeaders = (book, { compound }) => headersOf(book, compound).length > 0;

// A struct in the file of another thing, such as the columns of a table in record.h, is a detail of that thing.
function mainEntries(book, compound) {
  const types = inner(book, compound.inner);
  const entries = [...once(compound.members.filter(m => m.documented)), ...types];
  const namesake = ({ file }) => file.replace(/.*\/|\.\w+$/g, '').replace(/_/g, '');
  const isMain = entry => entry.name.toLowerCase() === namesake(entry);
  const taken = new Set(entries.filter(isMain).map(entry => entry.file));
  return entries.filter(entry => !entry.isType || isMain(entry) || !taken.has(entry.file)).sort(byName);
}

const once = members => members.filter((m, i) => members.findIndex(other => other.name === m.name) === i);

const intro = (book, compound) =>
  [`<p class="brief">${brief(book, compound)}</p>`, details(book, compound)].filter(Boolean).join('\n');

const section = ([title, id, html]) => `<h2 id="list-of-${id}">${title}</h2>\n${html}`;
const entries = (book, members) => members.map(m => memberSection(book, m)).join('\n');

function page(compound, groups, about) {
  const shown = groups.filter(([, , html]) => html);
  const sections = shown.flatMap(([title, id, , members = []]) => [
    { id: `list-of-${id}`, title },
    ...members.map(m => ({ id: m.anchor, title: m.name, within: true })),
  ]);
  return {
    href: compound.href,
    kind: 'api',
    ...about,
    body: `${about.body}\n${shown.map(section).join('\n')}`,
    sections,
  };
}

function namespacePage(book, compound) {
  const title = book.api.namespaces.find(n => n.name === compound.name)?.title ?? ownName(compound);
  const headers = headersOf(book, compound);
  if (headers.length)
    return page(compound, [], {
      title,
      kicker: `namespace ${compound.name}`,
      body: intro(book, compound) + headerList(book, headers),
    });
  const functions = compound.members.filter(m => m.kind === 'function').sort(byName);
  const constants = compound.members.filter(m => m.kind !== 'function' && m.documented).sort(byName);
  const list = names => (names.length ? summary(book, names) : '');
  return page(
    compound,
    [
      ['Types', 'types', list(inner(book, compound.inner))],
      ['Functions', 'functions', entries(book, functions), functions],
      ['Constants and names', 'constants', entries(book, constants), constants],
      ['Details', 'details', list(inner(book, compound.innerNamespaces))],
    ],
    { title, kicker: `namespace ${compound.name}`, body: intro(book, compound) },
  );
}

function typePage(book, compound) {
  const own = kind => compound.members.filter(m => m.kind === kind);
  const variables = own('variable'),
    functions = own('function'),
    types = own('typedef').filter(m => m.documented);
  const name = ownName(compound);
  const head =
    compound.kind === 'concept' ? compound.initializer : `${templateLine(compound.templates)}${compound.kind} ${name};`;
  return page(
    compound,
    [
      ['Members', 'members', variables.length ? fields(book, variables) : ''],
      ['Functions', 'functions', entries(book, functions), functions],
      ['Types', 'types', entries(book, types), types],
    ],
    {
      title: name,
      kicker: `${compound.kind} in ${scopeOf(compound)}`,
      body: `${signature(book, `${include(compound)}\n\n${head}`, compound.file)}\n${intro(book, compound)}\n${where(compound)}`,
    },
  );
}
