// Cuts a chapter's Markdown into pieces: plain text, headings, code, formulas and the book's marks.
import { codeSpan, comment, dollars, fence, heading, image, sticky, underline } from './markdown.mjs';
import { MARKS, PASSED_ON, splitArguments } from './marks.mjs';
import { didYouMean } from './problems.mjs';

const FORMULA_END = { '$': '\\f$', '[': '\\f]', '{': '\\f}' };

export function scan(source, file, problems) {
  const pieces = [];
  let at = 0,
    textFrom = 0,
    line = 1,
    textLine = 1;

  const moveTo = end => {
    for (let i = source.indexOf('\n', at); i >= 0 && i < end; i = source.indexOf('\n', i + 1)) ++line;
    at = end;
  };
  const take = (end, piece) => {
    if (at > textFrom) pieces.push({ type: 'text', text: source.slice(textFrom, at), line: textLine });
    if (piece) pieces.push({ ...piece, line, indent: indentAt(source, at) });
    moveTo(end);
    textFrom = end;
    textLine = line;
  };
  const report = message => problems.add(file, line, message);
  const context = { source, report, take };

  while (at < source.length) {
    const lineStart = at === 0 || source[at - 1] === '\n';
    const step =
      (lineStart && (fence(context, at) ?? heading(context, at) ?? underline(context, at))) ||
      comment(context, at) ||
      image(context, at) ||
      dollars(context, at) ||
      codeSpan(context, at) ||
      command(context, at);
    if (!step) moveTo(nextSpecial(source, at));
    else if (step.piece === undefined) moveTo(step.end);
    else take(step.end, step.piece);
  }
  take(at, null);
  return pieces;
}

function nextSpecial(source, at) {
  const special = /[\\`@<!$\n]/g;
  special.lastIndex = at;
  const found = special.exec(source);
  if (!found) return source.length;
  return found[0] === '\n' || found.index === at ? found.index + 1 : found.index;
}

// White space a block's own line must start with to stay inside the list item it stands in.
function indentAt(source, at) {
  const start = source.lastIndexOf('\n', at - 1) + 1;
  const prefix = source.slice(start, at).match(/^[ \t]*(?:(?:[-*+]|\d+\.)[ \t]+)?/)[0];
  return ' '.repeat(prefix.length);
}

function command(context, at) {
  const { source, report } = context;
  if (source[at] === '@') {
    const word = sticky(/@([A-Za-z]+)/, source, at)?.[1];
    if (!word || PASSED_ON.includes(word) || (at > 0 && /[\w.]/.test(source[at - 1]))) return undefined;
    report(`unknown mark @${word}; write \\@${word} if the text itself is meant`);
    return { end: at + 1 };
  }
  if (source[at] !== '\\') return undefined;
  if (source[at + 1] === 'f' && /[$[{\]}]/.test(source[at + 2] ?? '')) return formula(context, at);
  const word = sticky(/\\([A-Za-z]+)/, source, at)?.[1];
  if (!word) return escaped(source[at + 1], at);
  if (PASSED_ON.includes(word)) return { end: at + word.length + 1 };
  return mark(context, at, word);
}

function skipTo(source, closing, at) {
  const end = source.indexOf(closing, at);
  return end < 0 ? at + 3 : end + closing.length;
}

// Carried past Doxygen like a mark, so that what is left standing behind Doxygen was not meant.
function escaped(character, at) {
  return /[!-/:-@[-`{-~]/.test(character ?? '')
    ? { end: at + 2, piece: { type: 'inline', name: 'character', character } }
    : { end: at + 2 };
}

function formula({ source, report }, at) {
  const kind = source[at + 2];
  if (!FORMULA_END[kind]) {
    report(`\\f${kind} closes a formula that was never opened`);
    return { end: at + 3, piece: null };
  }
  const environment = kind === '{' ? sticky(/\\f\{([\w*]+)\}\s*\{/, source, at) : null;
  if (kind === '{' && !environment) {
    report('this formula lacks its second brace; write \\f{align*}{ ... \\f}');
    return { end: skipTo(source, '\\f}', at), piece: null };
  }
  const from = at + (environment?.[0].length ?? 3);
  const end = source.indexOf(FORMULA_END[kind], from);
  const tex = source.slice(from, end);
  if (end < 0 || /\\f[$[{]/.test(tex) || /\n[ \t]*\n/.test(tex)) {
    report(`this formula is never closed; put ${FORMULA_END[kind]} after it`);
    return { end: from, piece: null };
  }
  const display = kind !== '$';
  const wrapped = environment ? `\\begin{${environment[1]}}${tex}\\end{${environment[1]}}` : tex;
  return {
    end: end + 3,
    piece: { type: display ? 'block' : 'inline', name: display ? 'display' : 'math', tex: wrapped },
  };
}

function mark({ source, report }, at, word) {
  const closes = word.startsWith('end') && MARKS[word.slice(3)]?.kind === 'box';
  if (closes) return { end: at + word.length + 1, piece: { type: 'close', name: word.slice(3) } };
  const known = MARKS[word];
  if (!known) {
    const near = didYouMean(word, [...Object.keys(MARKS), ...PASSED_ON]).replace(/"(\w+)"/g, '\\$1');
    report(`unknown mark \\${word}.${near || ` Write \\\\${word} if the text itself is meant.`}`);
    return { end: at + word.length + 1, piece: null };
  }
  const [least] = known.takes;
  const braces = known.takes[1] > 0 && sticky(/\\[A-Za-z]+\{((?:[^{}]|\{[^{}]*\})*)\}/, source, at);
  const args = braces ? splitArguments(braces[1].replace(/\s+/g, ' ').trim(), known).filter(Boolean) : [];
  const end = at + (braces ? braces[0].length : word.length + 1);
  if (args.length < least) {
    report(`\\${word} is incomplete; write ${known.usage}`);
    return { end, piece: known.kind === 'box' ? { type: 'open', name: word, args, incomplete: true } : null };
  }
  return { end, piece: { type: known.kind === 'box' ? 'open' : known.kind, name: word, args } };
}
