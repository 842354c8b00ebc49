// The parts of the code reference: what a comment says, how a thing is declared, an entry, a table of members.
import { linker } from './api.mjs';
import { docTextHtml } from './doc-text.mjs';
import { highlightLines } from './highlight.mjs';
import { renderTex } from './math.mjs';
import { sourceHref } from './source-pages.mjs';
import { escapeHtml } from './text.mjs';
import { createXmlToHtml, plainText } from './xml.mjs';

function converter(book, where) {
  const report = message => book.problems.add(where.file, where.line, `in the documentation here: ${message}`);
  return createXmlToHtml({
    code: code => codeSpan(book, code),
    text: (text, before) => linkNames(book, docTextHtml(text, before), where),
    verbatim: code =>
      `<div class="codebox"><pre><code>${highlightLines(code, 'cpp', linker(book.api, where.file)).join('\n')}</code></pre></div>`,
    formula: tex => renderTex(tex.replace(/^\$|\$$|^\\\[|\\\]$/g, ''), false, report),
    link: (refid, html) =>
      book.api.hrefs.has(refid) ? `<a href="${book.api.hrefs.get(refid)}"><code>${html}</code></a>` : html,
    fault: report,
  });
}

function codeSpan(book, code) {
  const href = code.includes('::') ? book.api.names.get(code)?.href : null;
  return href ? `<a href="${href}"><code>${escapeHtml(code)}</code></a>` : `<code>${escapeHtml(code)}</code>`;
}

// A name with its namespace or with () is linked; so is one like stormer_verlet_start or BandSystem, if it is known.
function linkNames(book, html, { file, name: own }) {
  const link = linker(book.api, file);
  return html.replace(/\b\w+(?:::\w+)+\b|\b\w+\(\)|\b[a-z]\w*_\w+\b|\b(?:[A-Z]\w*){2,}\b/g, name => {
    if (name.includes('::') || name.endsWith('()')) return codeSpan(book, name);
    const href = name === own ? null : link(name);
    return href ? `<a href="${href}"><code>${name}</code></a>` : name;
  });
}

export const brief = (book, entry) => converter(book, entry).inline(inlineOf(entry.brief)).trim();
const inlineOf = e => (e?.children ?? []).flatMap(c => (c.name === 'para' ? c.children : []));

// Doxygen puts parameters and "see also" into the running text; the page shows them apart.
export function details(book, entry) {
  const parameters = [],
    sections = [];
  const prose = (entry.details?.children ?? []).map(para =>
    para.name === 'para'
      ? {
          ...para,
          children: para.children.filter(node => {
            if (node.name === 'parameterlist') parameters.push(node);
            else if (node.name === 'simplesect') sections.push(node);
            return node.name !== 'parameterlist' && node.name !== 'simplesect';
          }),
        }
      : para,
  );
  const { flow, inline } = converter(book, entry);
  return [
    flow(prose),
    ...parameters.map(list => parameterList(list, inline)),
    ...sections.map(node => remark(node, inline)),
  ]
    .filter(Boolean)
    .join('\n');
}

function parameterList(list, inline) {
  const label = { templateparam: 'Template parameters', exception: 'Throws' }[list.attribs.kind] ?? 'Parameters';
  const items = list.children
    .filter(c => c.name === 'parameteritem')
    .map(item => {
      const names = item.children.filter(c => c.name === 'parameternamelist').map(n => plainText(n).trim());
      const words = inline(inlineOf(item.children.find(c => c.name === 'parameterdescription'))).trim();
      return `<dt><code>${escapeHtml(names.join(', '))}</code></dt><dd>${words}</dd>`;
    });
  return `<p class="label">${label}</p>\n<dl class="params">${items.join('')}</dl>`;
}

const SECTIONS = {
  see: 'See',
  return: 'Returns',
  note: 'Note',
  pre: 'Before',
  post: 'After',
  warning: 'Warning',
  remark: 'Remark',
};

function remark(node, inline) {
  return `<p class="also"><strong>${SECTIONS[node.attribs.kind] ?? 'Note'}</strong> ${inline(inlineOf(node)).trim()}</p>`;
}

export const where = ({ file, line }) =>
  `<p class="where"><a href="${sourceHref(file)}#L${line}"><code>${escapeHtml(file)}:${line}</code></a></p>`;
export const include = ({ file }) => `#include "${file.replace(/^code\//, '')}"`;

export function signature(book, code, file) {
  return `<div class="signature"><pre><code>${highlightLines(code, 'cpp', linker(book.api, file)).join('\n')}</code></pre></div>`;
}

export function templateLine(templates) {
  if (!templates.length) return '';
  return `template <${templates.map(t => [t.type, t.name, t.value && `= ${t.value}`].filter(Boolean).join(' ')).join(', ')}>\n`;
}

const tidyType = type =>
  type
    .replace(/ ([&*])/g, '$1')
    .replace(/< /g, '<')
    .replace(/ >/g, '>');

function declaration(member) {
  const type = tidyType(member.type);
  if (member.kind === 'typedef') return `using ${member.name} = ${type};`;
  if (member.kind === 'variable') return `${type} ${member.name}${member.initializer && ` ${member.initializer}`};`;
  const parameters = member.parameters.map(p =>
    [tidyType(p.type), p.name, p.value && `= ${p.value}`].filter(Boolean).join(' '),
  );
  const start = `${type} ${member.name}(`.trimStart();
  return (
    templateLine(member.templates) +
    fill(start, [...parameters.slice(0, -1).map(p => `${p}, `), `${parameters.at(-1) ?? ''})${member.suffix};`])
  );
}

// As many parameters to a line as fit, those of the next below those of the first.
function fill(start, parts) {
  const indent = ' '.repeat(Math.min(start.length, 40));
  const lines = [start];
  for (const part of parts) {
    if ((lines.at(-1) + part).length > 84 && lines.at(-1).trim() && lines.at(-1) !== start) lines.push(indent + part);
    else lines[lines.length - 1] += part;
  }
  return lines.map(line => line.trimEnd()).join('\n');
}

// `card` stands right below what the entry does.
export function memberSection(book, member, { level = 3, card = '' } = {}) {
  const text = brief(book, member);
  return `<section class="member">${entryHeading(member, level)}
${signature(book, declaration(member), member.file)}
${[text && `<p class="brief">${text}</p>`, card, details(book, member), where(member)].filter(Boolean).join('\n')}</section>`;
}

export const entryHeading = ({ name, anchor }, level) =>
  `<h${level} id="${anchor}"><code>${escapeHtml(name)}</code> <a class="anchor-link" href="#${anchor}" aria-label="Link to this entry">#</a></h${level}>`;

export const summary = (book, entries) =>
  `<dl class="summary">${entries
    .map(
      e =>
        `<dt><a href="${e.href}"><code>${escapeHtml(e.name)}${e.kind === 'function' ? '()' : ''}</code></a></dt><dd>${brief(book, e)}</dd>`,
    )
    .join('\n')}</dl>`;

export function fields(book, variables) {
  const rows = variables.map(
    v =>
      `<tr id="${v.anchor}"><td><code>${escapeHtml(v.name)}</code></td><td><code>${escapeHtml(tidyType(v.type))}</code></td>` +
      `<td>${initial(v)}</td><td>${brief(book, v) || details(book, v).replace(/<\/?p>/g, '')}</td></tr>`,
  );
  return (
    `<div class="tablescroll"><table><thead><tr><th scope="col">Name</th><th scope="col">Type</th><th scope="col">Default</th><th scope="col">Meaning</th></tr></thead>` +
    `<tbody>\n${rows.join('\n')}\n</tbody></table></div>`
  );
}

function initial({ initializer, file, line }) {
  const value = initializer.replace(/^=\s*/, '');
  return value.length > 32
    ? `<a href="${sourceHref(file)}#L${line}">in the file</a>`
    : value && `<code>${escapeHtml(value)}</code>`;
}
