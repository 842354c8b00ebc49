// Turns the XML of a Doxygen comment into HTML.
import { readFileSync } from 'node:fs';
import * as cheerio from 'cheerio';
import { escapeHtml } from './text.mjs';

// Doxygen takes ' and '' within backticks for quotation marks. So the comments of the code go through it with another character in
// their place, which is changed back here.
export const APOSTROPHE = '\ue002';
export const loadXml = path => cheerio.load(readFileSync(path, 'utf8').replaceAll(APOSTROPHE, "'"), { xml: true });

// What the comments of the code use; of anything else the author is told.
const INLINE = { emphasis: 'em', bold: 'strong', subscript: 'sub', superscript: 'sup' };
const CHARACTERS = { ndash: '–', mdash: '—', nonbreakablespace: '\u00a0', zwj: '' };
const BLOCKS = ['para', 'itemizedlist', 'orderedlist', 'programlisting', 'verbatim', 'parameterlist', 'simplesect'];

// `host` says how text, code, formulas and links come out, and is told what could not be turned:
//   text(text, before), code(code), verbatim(code), formula(tex), link(refid, html), fault(message)
export function createXmlToHtml(host) {
  const inline = (nodes, state = { before: ' ' }) => nodes.map(node => inlineNode(node, state)).join('');

  function inlineNode(node, state) {
    if (node.type === 'text') {
      const text = node.data.replace(/\s+/g, ' ');
      const html = host.text(text, state.before);
      state.before = text.at(-1) ?? state.before;
      return html;
    }
    if (node.type !== 'tag') return '';
    if (node.name === 'ulink') return `<a href="${escapeHtml(node.attribs.url)}">${inline(node.children, state)}</a>`;
    if (node.name === 'ref') return host.link(node.attribs.refid, escapeHtml(cheerio.load(node, { xml: true }).text()));
    if (node.name === 'computeroutput') return host.code(plainText(node));
    if (node.name === 'formula') return host.formula(plainText(node));
    if (node.name in CHARACTERS) return CHARACTERS[node.name];
    const tag = INLINE[node.name];
    if (!tag)
      return (
        host.fault(`what Doxygen calls <${node.name}> has no looks in this book; write it in another way`) ??
        inline(node.children, state)
      );
    return `<${tag}>${inline(node.children, state)}</${tag}>`;
  }

  // Runs of inline nodes become paragraphs.
  function blocks(nodes) {
    const parts = [];
    let run = [];
    const endRun = () => {
      const text = inline(run).trim();
      run = [];
      if (text) parts.push({ html: `<p>${text}</p>`, text });
    };
    for (const node of nodes) {
      if (!BLOCKS.includes(node.name)) {
        run.push(node);
        continue;
      }
      endRun();
      if (node.name === 'para') parts.push(...blocks(node.children));
      else parts.push({ html: blockNode(node) });
    }
    endRun();
    return parts;
  }

  const flow = nodes => join(blocks(nodes));

  function item(node) {
    const [first, ...rest] = blocks(node.children);
    if (first?.text && !rest.some(({ text }) => text)) return join([{ html: first.text }, ...rest]);
    return join([first, ...rest].filter(Boolean));
  }

  function blockNode(node) {
    const items = name => node.children.filter(child => child.name === name);
    switch (node.name) {
      case 'itemizedlist':
        return list('ul', items('listitem'));
      case 'orderedlist':
        return list('ol', items('listitem'));
      case 'programlisting':
        return host.verbatim(items('codeline').map(codeText).join('\n'));
      case 'verbatim':
        return host.verbatim(plainText(node));
      default:
        return flow(node.children);
    }
  }

  const list = (tag, entries) => `<${tag}>\n${entries.map(entry => `<li>${item(entry)}</li>`).join('\n')}\n</${tag}>`;

  return { flow, inline };
}

const join = parts => parts.map(({ html }) => html).join('\n');

const codeText = node =>
  node.name === 'sp' ? ' ' : node.type === 'text' ? node.data : (node.children ?? []).map(codeText).join('');

export const plainText = node => (node.type === 'text' ? node.data : (node.children ?? []).map(plainText).join(''));
