// Turns the tokens of a page into HTML. A mark within a sentence is left a hole: how it is set depends on what is around it.
import { escapeHtml, hole, smarten } from './text.mjs';

const CROSSES = 'this box ends in another list item or quotation than it starts in; indent both ends alike';

// `host` says what becomes of the pieces: block(piece), box(piece, html), heading(piece), fault(message, piece)
export function proseHtml(tokens, host) {
  const flow = (inner, between = '\n') => nest(parts(inner), between);

  function parts(inner) {
    const found = [];
    for (let i = 0; i < inner.length; ++i) {
      const end = closing(inner, i);
      found.push(...partsOf(inner[i], inner.slice(i + 1, end)));
      i = end;
    }
    return found;
  }

  function partsOf(token, inner) {
    if (token.type === 'paragraph_open') return paragraphs(inner[0].children);
    return [standsAlone(token) ? alone(token.meta) : { html: element(token, inner) }];
  }

  function alone(piece) {
    if (piece.type === 'open') return { open: piece };
    if (piece.type === 'close') return { close: piece };
    return { html: piece.type === 'heading' ? host.heading(piece) : host.block(piece) };
  }

  // What stands alone ends the paragraph that it stands in.
  function paragraphs(tokens) {
    const found = [];
    let from = 0,
      depth = 0;
    const endAt = to => {
      const text = sentence(tokens.slice(from, to));
      if (text) found.push({ html: `<p>${text}</p>`, text });
      from = to + 1;
    };
    tokens.forEach((token, i) => {
      depth += token.nesting;
      if (depth || !standsAlone(token)) return;
      endAt(i);
      found.push(alone(token.meta));
    });
    endAt(tokens.length);
    return found;
  }

  function sentence(tokens) {
    for (const { meta } of tokens.filter(standsAlone))
      host.fault(`${written(meta)} landed inside a paragraph; put an empty line before and after it`, meta);
    return sentenceHtml(tokens);
  }

  function element({ tag, attrs }, inner) {
    if (tag === 'hr') return '<hr>';
    const whole = content => `<${tag}${attributes(attrs)}>${content}</${tag}>`;
    if (tag === 'li') return whole(item(parts(inner)));
    if (tag === 'th' || tag === 'td') return whole(sentence(inner[0].children));
    if (tag === 'table') return `<div class="tablescroll">${whole(flow(inner, ''))}</div>`;
    return whole(SPACED.includes(tag) ? `\n${flow(inner)}\n` : flow(inner, tag === 'tr' ? '' : '\n'));
  }

  // An item that is one paragraph, and at most blocks behind it, needs no <p>.
  function item(found) {
    const [first, ...rest] = found;
    if (first?.text && !rest.some(({ text }) => text)) return [first.text, nest(rest)].filter(Boolean).join('\n');
    return nest(found);
  }

  function nest(found, between = '\n') {
    const stack = [{ html: [] }];
    for (const { open, close, html } of found) {
      if (open) stack.push({ piece: open, html: [] });
      else if (close && stack.length === 1) host.fault(CROSSES, close);
      else if (close) {
        const box = stack.pop();
        stack.at(-1).html.push(host.box(box.piece, box.html.join('\n')));
      } else if (html) stack.at(-1).html.push(html);
    }
    for (const { piece } of stack.slice(1)) host.fault(CROSSES, piece);
    return stack[0].html.join(between);
  }

  return flow(tokens);
}

function closing(tokens, at) {
  if (tokens[at].nesting !== 1) return at;
  let end = at + 1;
  while (tokens[end].nesting !== -1 || tokens[end].level !== tokens[at].level) ++end;
  return end;
}

const SPACED = ['ul', 'ol', 'tbody'];

const written = ({ type, name }) => (name === 'display' ? '\\f[' : `\\${type === 'close' ? 'end' : ''}${name}`);

const standsAlone = ({ meta }) => meta && !['inline', 'tablestart'].includes(meta.type);

const attributes = attrs => (attrs ?? []).map(([name, value]) => ` ${name}="${escapeHtml(value)}"`).join('');

// Quotation marks and units are told by the text around them, marks among it.
function sentenceHtml(tokens) {
  let html = '',
    text = '',
    before = ' ';
  const endText = () => {
    html += escapeHtml(smarten(text.replace(/[ \t\n]+/g, ' '), before)).replace(/&quot;/g, '"');
    before = text.at(-1) ?? before;
    text = '';
  };
  for (const token of tokens) {
    if (token.meta) text += hole(token.meta);
    else if (token.type === 'softbreak') text += ' ';
    else if (token.tag) {
      endText();
      html += token.nesting < 0 ? `</${token.tag}>` : `<${token.tag}${attributes(token.attrs)}>`;
    } else text += token.content;
  }
  endText();
  return html.trim();
}
