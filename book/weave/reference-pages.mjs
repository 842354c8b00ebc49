// The code reference: a landing page, a page per namespace, a page per struct.
import { renderTex } from './math.mjs';
import { linker } from './api.mjs';
import { highlightLines } from './highlight.mjs';
import { sourceHref } from './source-pages.mjs';
import { escapeHtml } from './text.mjs';
import { createXmlToHtml, plainText } from './xml.mjs';

export function referencePages(book) {
  const { api } = book;
  return [landing(book), ...[...api.compounds.values()].map(compound => (compound.isType ? typePage(book, compound) : namespacePage(book, compound)))];
}

function converter(book, where) {
  const report = message => book.problems.add(where.file, where.line, `in the documentation here: ${message}`);
  return createXmlToHtml({
    opens: () => false, closes: () => false, isBlock: () => false, isTableStart: () => false, stray() {}, block: () => '', box: () => '',
    heading: html => `<p><strong>${html}</strong></p>`,
    code: code => codeSpan(book, code),
    verbatim: code => `<pre><code>${escapeHtml(code)}</code></pre>`,
    formula: tex => renderTex(tex.replace(/^\$|\$$|^\\\[|\\\]$/g, ''), false, report),
    link: (refid, html) => (book.api.hrefs.has(refid) ? `<a href="${book.api.hrefs.get(refid)}"><code>${html}</code></a>` : html),
    fault: report,
  });
}

function codeSpan(book, code) {
  const href = code.includes('::') ? book.api.names.get(code)?.href : null;
  return href ? `<a href="${href}"><code>${escapeHtml(code)}</code></a>` : `<code>${escapeHtml(code)}</code>`;
}

const brief = (book, entry) => converter(book, entry).inline(inlineOf(entry.brief)).trim();
const inlineOf = e => (e?.children ?? []).flatMap(c => (c.name === 'para' ? c.children : []));
const isShown = member => member.documented || member.kind === 'function';

// Doxygen puts parameters and "see also" into the running text; the page shows them apart.
function details(book, entry) {
  const parameters = [], sections = [];
  const prose = (entry.details?.children ?? []).map(para => (para.name === 'para' ? {
    ...para, children: para.children.filter(node => {
      if (node.name === 'parameterlist') parameters.push(node);
      else if (node.name === 'simplesect') sections.push(node);
      return node.name !== 'parameterlist' && node.name !== 'simplesect';
    }),
  } : para));
  const { flow, inline } = converter(book, entry);
  return [flow(prose), ...parameters.map(list => parameterList(list, inline)), ...sections.map(node => remark(node, inline))].filter(Boolean).join('\n');
}

function parameterList(list, inline) {
  const label = { templateparam: 'Template parameters', exception: 'Throws' }[list.attribs.kind] ?? 'Parameters';
  const items = list.children.filter(c => c.name === 'parameteritem').map(item => {
    const names = item.children.filter(c => c.name === 'parameternamelist').map(n => plainText(n).trim());
    const words = inline(inlineOf(item.children.find(c => c.name === 'parameterdescription'))).trim();
    return `<dt><code>${escapeHtml(names.join(', '))}</code></dt><dd>${words}</dd>`;
  });
  return `<h4>${label}</h4>\n<dl class="params">${items.join('')}</dl>`;
}

const SECTIONS = { see: 'See', return: 'Returns', note: 'Note', pre: 'Before', post: 'After', warning: 'Warning', remark: 'Remark' };

function remark(node, inline) {
  return `<p class="also"><strong>${SECTIONS[node.attribs.kind] ?? 'Note'}</strong> ${inline(inlineOf(node)).trim()}</p>`;
}

const where = ({ file, line }) => `<p class="where"><a href="${sourceHref(file)}#L${line}"><code>${escapeHtml(file)}:${line}</code></a></p>`;
const include = ({ file }) => `#include "${file.replace(/^code\//, '')}"`;

function signature(book, code, file) {
  return `<pre class="signature"><code>${highlightLines(code, 'cpp', linker(book.api, file)).join('\n')}</code></pre>`;
}

function templateLine(templates) {
  if (!templates.length) return '';
  return `template <${templates.map(t => [t.type, t.name, t.value && `= ${t.value}`].filter(Boolean).join(' ')).join(', ')}>\n`;
}

const tidyType = type => type.replace(/ ([&*])/g, '$1').replace(/< /g, '<').replace(/ >/g, '>');

function declaration(member) {
  const type = tidyType(member.type);
  if (member.kind === 'typedef') return `using ${member.name} = ${type};`;
  if (member.kind === 'variable') return `${type} ${member.name}${member.initializer && ` ${member.initializer}`};`;
  const parameters = member.parameters.map(p => [tidyType(p.type), p.name, p.value && `= ${p.value}`].filter(Boolean).join(' '));
  const start = `${type} ${member.name}(`.trimStart();
  const end = `)${member.suffix};`;
  const oneLine = start + parameters.join(', ') + end;
  const call = oneLine.length <= 84 ? oneLine : start + parameters.join(`,\n${' '.repeat(Math.min(start.length, 40))}`) + end;
  return templateLine(member.templates) + call;
}

function memberSection(book, member) {
  const text = brief(book, member);
  return `<section class="member"><h3 id="${member.anchor}"><code>${escapeHtml(member.name)}</code> <a class="anchor-link" href="#${member.anchor}" aria-label="Link to this entry">#</a></h3>
${signature(book, declaration(member), member.file)}
${text && `<p class="brief">${text}</p>`}
${details(book, member)}
${where(member)}</section>`;
}

function namespacePage(book, compound) {
  const title = book.api.namespaces.find(n => n.name === compound.name)?.title ?? compound.name;
  const types = compound.inner.map(name => book.api.compounds.get(name)).filter(Boolean);
  const groups = [
    ['Types', 'types', types.length ? summary(book, types.map(t => ({ ...t, name: t.name.split('::').at(-1) }))) : ''],
    ['Functions', 'functions', compound.members.filter(m => m.kind === 'function').map(m => memberSection(book, m)).join('\n')],
    ['Constants and names', 'constants', compound.members.filter(m => m.kind !== 'function' && m.documented).map(m => memberSection(book, m)).join('\n')],
  ].filter(([, , html]) => html);
  const body = `${details(book, compound)}\n${groups.map(([name, id, html]) => `<h2 id="list-of-${id}">${name}</h2>\n${html}`).join('\n')}`;
  return { href: compound.href, title, kind: 'api', kicker: `namespace ${compound.name}`, body, brief: brief(book, compound), sections: sectionsOf(compound, groups) };
}

const sectionsOf = (compound, groups) => [...groups.map(([title, id]) => ({ id: `list-of-${id}`, title })),
  ...compound.members.filter(isShown).map(m => ({ id: m.anchor, title: m.name }))].slice(0, 40);

const summary = (book, entries) => `<dl class="summary">${entries.map(e =>
  `<dt><a href="${e.href}"><code>${escapeHtml(e.name)}</code></a></dt><dd>${brief(book, e)}</dd>`).join('\n')}</dl>`;

function typePage(book, compound) {
  const name = compound.name.split('::').at(-1);
  const own = kind => compound.members.filter(m => m.kind === kind);
  const variables = own('variable');
  const head = compound.kind === 'concept' ? compound.initializer : `${templateLine(compound.templates)}${compound.kind} ${name};`;
  const groups = [
    ['Parameters', 'parameters', variables.length ? fields(book, variables) : ''],
    ['Functions', 'functions', own('function').map(m => memberSection(book, m)).join('\n')],
    ['Types', 'types', own('typedef').filter(m => m.documented).map(m => memberSection(book, m)).join('\n')],
  ].filter(([, , html]) => html);
  const body = `${signature(book, `${include(compound)}\n\n${head}`, compound.file)}
<p class="brief">${brief(book, compound)}</p>
${details(book, compound)}
${where(compound)}
${groups.map(([title, id, html]) => `<h2 id="list-of-${id}">${title}</h2>\n${html}`).join('\n')}`;
  const space = compound.name.split('::').slice(0, -1).join('::');
  return { href: compound.href, title: name, kind: 'api', kicker: `${compound.kind} in ${space}`, body, brief: brief(book, compound), sections: sectionsOf({ members: own('function') }, groups) };
}

function fields(book, variables) {
  const rows = variables.map(v => `<tr id="${v.anchor}"><td><code>${escapeHtml(v.name)}</code></td><td><code>${escapeHtml(tidyType(v.type))}</code></td>`
    + `<td>${v.initializer && `<code>${escapeHtml(v.initializer.replace(/^=\s*/, ''))}</code>`}</td><td>${brief(book, v) || details(book, v).replace(/<\/?p>/g, '')}</td></tr>`);
  return `<div class="tablescroll"><table><thead><tr><th scope="col">Name</th><th scope="col">Type</th><th scope="col">Default</th><th scope="col">Meaning</th></tr></thead>`
    + `<tbody>\n${rows.join('\n')}\n</tbody></table></div>`;
}

function landing(book) {
  const groups = book.api.namespaces.map(({ name, title, about, compound }) => {
    const entries = [...compound.members.filter(m => m.kind === 'function' && m.documented),
      ...compound.inner.map(inner => book.api.compounds.get(inner)).filter(Boolean).map(t => ({ ...t, name: t.name.split('::').at(-1) }))];
    return `<h2 id="${name}"><a href="${compound.href}">${title}</a></h2>\n<p>${escapeHtml(about)}</p>\n${entries.length ? summary(book, entries) : ''}`;
  });
  return {
    href: 'reference.html', title: 'Code reference', kind: 'api', body: groups.join('\n'),
    sections: book.api.namespaces.map(({ name, title }) => ({ id: name, title })),
  };
}
