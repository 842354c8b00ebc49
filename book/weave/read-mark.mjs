// How a mark of the book and a formula are written. Each function takes what starts at `at` of a text and returns
// { end, piece }: no piece if it stays text, null if nothing comes of it, undefined if it is something else.
import { MARKS, splitArguments } from './marks.mjs';
import { didYouMean } from './problems.mjs';

const FORMULA_END = { '$': '\\f$', '[': '\\f]', '{': '\\f}' };

export function sticky(pattern, source, at) {
  const regex = new RegExp(pattern, 'y');
  regex.lastIndex = at;
  return regex.exec(source);
}

export function readMark(context, at) {
  const { source } = context;
  if (source[at] === '@') return atSign(context, at);
  if (source[at] !== '\\') return undefined;
  if (source[at + 1] === 'f' && /[$[{\]}]/.test(source[at + 2] ?? '')) return formula(context, at);
  const word = sticky(/\\([A-Za-z]+)/, source, at)?.[1];
  if (!word) return undefined;
  return word === 'ref' ? reference(context, at) : mark(context, at, word);
}

function atSign(context, at) {
  const { source, report } = context;
  const word = sticky(/@([A-Za-z]+)/, source, at)?.[1];
  if (!word || (at > 0 && /[\w.]/.test(source[at - 1]))) return undefined;
  if (word === 'ref') return reference(context, at);
  report(`unknown mark @${word}; write \\@${word} if the text itself is meant`);
  return { end: at + 1 };
}

// Written as in the comments of the code, without braces.
function reference({ source, report }, at) {
  const found = sticky(/.ref\s+(\w+(?:::\w+)*)/, source, at);
  if (found) return { end: at + found[0].length, piece: { type: 'inline', name: 'ref', args: [found[1]] } };
  report(`\\ref is incomplete; write ${MARKS.ref.usage}`);
  return { end: at + 4, piece: null };
}

function skipTo(source, closing, at) {
  const end = source.indexOf(closing, at);
  return end < 0 ? at + 3 : end + closing.length;
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
    const near = didYouMean(word, Object.keys(MARKS)).replace(/"(\w+)"/g, '\\$1');
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
