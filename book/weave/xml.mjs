// Turns the XML of a Doxygen comment or page into HTML. Tokens stay in the text, except for those of blocks and boxes.
import { readFileSync } from 'node:fs';
import * as cheerio from 'cheerio';
import { TOKEN } from './prose.mjs';
import { escapeHtml, smarten } from './text.mjs';

// Doxygen takes ' and '' within backticks for quotation marks. So the comments of the code go through it with another character in
// their place, which is changed back here.
export const APOSTROPHE = '\ue002';
export const loadXml = path => cheerio.load(readFileSync(path, 'utf8').replaceAll(APOSTROPHE, "'"), { xml: true });

const INLINE = { emphasis: 'em', bold: 'strong', subscript: 'sub', superscript: 'sup', strike: 's', small: 'small' };
const BLOCKS = new Set([
  'para',
  'itemizedlist',
  'orderedlist',
  'table',
  'blockquote',
  'heading',
  'verbatim',
  'programlisting',
  'preformatted',
  'sect1',
  'sect2',
  'sect3',
  'hruler',
  'parameterlist',
  'simplesect',
  'variablelist',
]);
const CHARACTERS = {
  ndash: '–',
  mdash: '—',
  nonbreakablespace: '\u00a0',
  lsquo: '‘',
  rsquo: '’',
  ldquo: '“',
  rdquo: '”',
  hellip: '…',
  minus: '−',
  times: '×',
  deg: '°',
  middot: '·',
  copy: '©',
  zwj: '',
  anchor: '',
  linebreak: '<br>',
};

// `host` says how tokens, boxes, formulas and links come out, and is told what could not be turned:
//   block(n), box(n, html), isBlock(n), opens(n), closes(n), link(refid, html), formula(tex), fault(message, n, excerpt)
// and, where text is more than prose, how it comes out: text(text, before)
export function createXmlToHtml(host) {
  const inline = (nodes, state = { before: ' ' }) => nodes.map(node => inlineNode(node, state)).join('');

  function inlineNode(node, state) {
    if (node.type === 'text') {
      const text = node.data.replace(/\s+/g, ' ');
      const html = (host.text ?? proseHtml)(text, state.before);
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
        host.fault(
          `what Doxygen calls <${node.name}> has no looks in this book; write it in another way`,
          undefined,
          plainText(node),
        ) ?? inline(node.children, state)
      );
    return `<${tag}>${inline(node.children, state)}</${tag}>`;
  }

  // Runs of inline nodes become paragraphs, tokens of boxes open and close them.
  function blocks(nodes, { tight = false } = {}) {
    const parts = [];
    let run = [];
    const endRun = () => {
      const html = inline(run).trim();
      run = [];
      if (html) parts.push(paragraph(html));
    };
    for (const node of nodes) {
      if (!BLOCKS.has(node.name)) {
        run.push(node);
        continue;
      }
      endRun();
      if (node.name === 'para') parts.push(...blockParts(node.children));
      else parts.push({ html: blockNode(node) });
    }
    endRun();
    return { parts, tight };
  }

  const blockParts = nodes => blocks(nodes).parts;

  function paragraph(html) {
    const alone = html.match(/^\ue000(\d+)\ue001$/)?.[1];
    if (alone !== undefined && host.opens(alone)) return { open: alone };
    if (alone !== undefined && host.closes(alone)) return { close: alone };
    if (alone !== undefined && host.isBlock(alone)) return { html: host.block(alone) };
    for (const [, n] of html.matchAll(TOKEN)) host.stray(n);
    return { html: `<p>${html}</p>`, text: html };
  }

  function nest(parts) {
    const stack = [{ html: [] }];
    for (const part of parts) {
      if (part.open !== undefined) stack.push({ n: part.open, html: [] });
      else if (part.close !== undefined && stack.length > 1) {
        const box = stack.pop();
        stack.at(-1).html.push(host.box(box.n, box.html.join('\n')));
      } else if (part.close !== undefined)
        host.fault(
          'this box ends in another list item or quotation than it starts in; indent both ends alike',
          part.close,
        );
      else stack.at(-1).html.push(part.html);
    }
    for (const box of stack.slice(1))
      host.fault('this box ends in another list item or quotation than it starts in; indent both ends alike', box.n);
    return stack[0].html.join('\n');
  }

  const flow = nodes => nest(blockParts(nodes));

  function item(node) {
    const parts = blockParts(node.children);
    if (parts.filter(part => part.text).length === 1 && parts[0].text)
      return [parts[0].text, nest(parts.slice(1))].join('\n').trim();
    return nest(parts);
  }

  function blockNode(node) {
    const items = name => node.children.filter(child => child.name === name);
    switch (node.name) {
      case 'itemizedlist':
        return list('ul', items('listitem'));
      case 'orderedlist':
        return list('ol', items('listitem'));
      case 'table':
        return table(items('row'));
      case 'blockquote':
        return `<blockquote>${flow(node.children)}</blockquote>`;
      case 'hruler':
        return '<hr>';
      case 'heading':
        return host.heading(inline(node.children).trim());
      case 'programlisting':
        return host.verbatim(items('codeline').map(codeText).join('\n'));
      case 'verbatim':
      case 'preformatted':
        return host.verbatim(plainText(node));
      default:
        return flow(node.children.filter(child => child.name !== 'title'));
    }
  }

  const list = (tag, entries) => `<${tag}>\n${entries.map(entry => `<li>${item(entry)}</li>`).join('\n')}\n</${tag}>`;

  function table(rows) {
    const line = row =>
      `<tr>${row.children
        .filter(c => c.name === 'entry')
        .map(cell)
        .join('')}</tr>`;
    const isHead = row => row.children.some(c => c.attribs?.thead === 'yes');
    const head = rows.filter(isHead),
      body = rows.filter(row => !isHead(row));
    return `<div class="tablescroll"><table><thead>${head.map(line).join('')}</thead><tbody>\n${body.map(line).join('\n')}\n</tbody></table></div>`;
  }

  function cell(entry) {
    const { thead, align } = entry.attribs;
    const html = inline(entry.children.flatMap(c => (c.name === 'para' ? c.children : [c])))
      .trim()
      .replace(TOKEN, (all, n) => (host.isTableStart(n) ? '' : all));
    const side = ['right', 'center'].includes(align) ? ` class="${align}"` : '';
    return thead === 'yes' && html ? `<th scope="col"${side}>${html}</th>` : `<td${side}>${html}</td>`;
  }

  return { flow, inline };
}

const proseHtml = (text, before) => escapeHtml(smarten(text, before)).replace(/&quot;/g, '"');

const codeText = node =>
  node.name === 'sp' ? ' ' : node.type === 'text' ? node.data : (node.children ?? []).map(codeText).join('');

export const plainText = node => (node.type === 'text' ? node.data : (node.children ?? []).map(plainText).join(''));
