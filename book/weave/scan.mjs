// Cuts a chapter's Markdown into pieces: plain text, headings, code, formulas and the book's marks.
import { MARKS, PASSED_ON, splitArguments } from './marks.mjs';
import { didYouMean } from './problems.mjs';

const CPP = /^(c|cc|cpp|c\+\+|cxx|h|hpp)$/i;
const FORMULA_END = { '$': '\\f$', '[': '\\f]', '{': '\\f}' };

export function scan(source, file, problems) {
  const pieces = [];
  let at = 0, textFrom = 0, line = 1, textLine = 1;

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
    const step = (lineStart && (fence(context, at) ?? heading(context, at)))
      || comment(context, at) || codeSpan(context, at) || command(context, at);
    if (!step) moveTo(nextSpecial(source, at));
    else if (step.piece === undefined) moveTo(step.end);
    else take(step.end, step.piece);
  }
  take(at, null);
  return pieces;
}

function nextSpecial(source, at) {
  const special = /[\\`@<\n]/g;
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

function sticky(pattern, source, at) {
  const regex = new RegExp(pattern, 'y');
  regex.lastIndex = at;
  return regex.exec(source);
}

function fence({ source, report }, at) {
  const open = sticky(/[ \t]*(`{3,}|~{3,})[ \t]*([^\s`]*)[^\n]*\n/, source, at);
  if (!open) return undefined;
  const [all, ticks, language] = open;
  const from = at + all.length;
  const close = new RegExp(`^[ \\t]*${ticks[0]}{${ticks.length},}[ \\t]*$`, 'm').exec(source.slice(from));
  if (!close) {
    report(`this fence is never closed; put a line ${ticks} after the code`);
    return { end: source.length, piece: null };
  }
  if (CPP.test(language)) report('C++ typed into the prose; cut it from a compiled file with \\listing{path, tag}');
  const indent = all.match(/^[ \t]*/)[0].length;
  const code = source.slice(from, from + close.index).replace(new RegExp(`^ {0,${indent}}`, 'gm'), '').replace(/\n$/, '');
  return { end: from + close.index + close[0].length, piece: { type: 'block', name: 'fence', language, code } };
}

function heading({ source, report }, at) {
  const found = sticky(/(#{1,6})[ \t]+([^\n]*?)[ \t]*#*[ \t]*(?=\n|$)/, source, at);
  if (!found) return undefined;
  const [all, marks, text] = found;
  const outsideCode = text.replace(/`[^`]*`/g, '');
  if (/\\f[$[{]/.test(outsideCode)) report('a formula in a heading: write the heading in words');
  else if (/\\[a-z]/i.test(outsideCode)) report('a mark in a heading: headings are plain text and `code`');
  return { end: at + all.length, piece: { type: 'heading', level: marks.length, text } };
}

function comment({ source, report }, at) {
  if (!source.startsWith('<!--', at)) return undefined;
  const end = source.indexOf('-->', at);
  if (end < 0) report('this comment is never closed; put --> after it');
  return { end: end < 0 ? source.length : end + 3, piece: null };
}

function codeSpan({ source, report }, at) {
  if (source[at] !== '`') return undefined;
  const ticks = sticky(/`+/, source, at)[0];
  const span = sticky(/(`+)(?!`)((?:(?!\n[ \t]*\n)[\s\S])*?[^`])\1(?!`)/, source, at);
  if (!span) {
    report(`this code span is never closed; put ${ticks} after it, or write \\\` for a backtick`);
    return { end: at + ticks.length, piece: null };
  }
  const code = span[2].replace(/\s+/g, ' ').replace(/^ (.*`.*) $/, '$1');
  return { end: at + span[0].length, piece: { type: 'inline', name: 'code', code } };
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
  if (!word) return { end: at + 2 };
  if (PASSED_ON.includes(word)) return { end: at + word.length + 1 };
  return mark(context, at, word);
}

function formula({ source, report }, at) {
  const kind = source[at + 2];
  if (!FORMULA_END[kind]) {
    report(`\\f${kind} closes a formula that was never opened`);
    return { end: at + 3, piece: null };
  }
  const environment = kind === '{' ? sticky(/\\f\{([\w*]+)\}\s*\{/, source, at) : null;
  const from = at + (environment?.[0].length ?? 3);
  const end = source.indexOf(FORMULA_END[kind], from);
  const tex = source.slice(from, end);
  if (end < 0 || /\\f[$[{]/.test(tex) || /\n[ \t]*\n/.test(tex)) {
    report(`this formula is never closed; put ${FORMULA_END[kind]} after it`);
    return { end: from, piece: null };
  }
  const display = kind !== '$';
  const wrapped = environment ? `\\begin{${environment[1]}}${tex}\\end{${environment[1]}}` : tex;
  return { end: end + 3, piece: { type: display ? 'block' : 'inline', name: display ? 'display' : 'math', tex: wrapped } };
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
  const braces = known.takes[1] > 0 && sticky(/\\[A-Za-z]+\{([^{}]*)\}/, source, at);
  const args = braces ? splitArguments(braces[1].replace(/\s+/g, ' ').trim(), known).filter(Boolean) : [];
  const end = at + (braces ? braces[0].length : word.length + 1);
  if (args.length < least) {
    report(`\\${word} is incomplete; write ${known.usage}`);
    return { end, piece: null };
  }
  return { end, piece: { type: known.kind === 'box' ? 'open' : known.kind, name: word, args } };
}
