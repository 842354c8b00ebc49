// What Markdown itself writes in a chapter and the book treats in its own way: first what stands within a sentence, each
// function as in read-mark.mjs; then what is made of a block.
import { sticky } from './read-mark.mjs';

const CPP = /^\{?\.?(c|cc|cpp|c\+\+|cxx|h|hpp)\b/i;
const PICTURE =
  'a picture from outside; pictures of this book are drawn by a script of the chapter: \\figure{name, Title}';

export function comment({ source, report }, at) {
  if (!source.startsWith('<!--', at)) return undefined;
  const end = source.indexOf('-->', at);
  if (end < 0) report('this comment is never closed; put --> after it');
  return { end: end < 0 ? source.length : end + 3, piece: null };
}

export function image({ source, report }, at) {
  const found = sticky(/!\[(?:[^\]\n]*\](?:\([^)\n]*\))?)?|<img\b[^>]*>?/, source, at);
  if (!found) return undefined;
  report(PICTURE);
  return { end: at + found[0].length, piece: null };
}

export function tag({ source, report }, at) {
  const found = sticky(/(?<!\w)<(\/?[A-Za-z][\w-]*)(?=[\s/>])[^<>]*>/, source, at);
  if (!found) return undefined;
  report(`HTML has no looks in this book: <${found[1]}>; write < as \\<, or put code into backticks`);
  return { end: at + found[0].length, piece: null };
}

export function dollars({ source, report }, at) {
  const found = sticky(/\$[^\s$][^$\n]*\$/, source, at);
  if (!found) return undefined;
  report('$ does not open a formula here; write \\f$ ... \\f$, or \\$ for the sign itself');
  return { end: at + found[0].length, piece: null };
}

export function codeSpan({ source, report }, at) {
  if (source[at] !== '`') return undefined;
  const ticks = sticky(/`+/, source, at)[0];
  const span = sticky(/(`+)(?!`)([^]*?[^`])\1(?!`)/, source, at);
  if (!span) {
    if (ticks.length > 2) report(`a fence starts on a line of its own; put ${ticks} on the next`);
    else report(`this code span is never closed; put ${ticks} after it, or write \\\` for a backtick`);
    return { end: at + ticks.length, piece: null };
  }
  const code = span[2].replace(/\s+/g, ' ').replace(/^ (.*`.*) $/, '$1');
  return { end: at + span[0].length, piece: { type: 'inline', name: 'code', code } };
}

// Of each kind of block that is a piece of a page: the piece, from its token, the one behind it and the lines of the page.
export const BLOCK_PIECES = {
  fence({ info, content, markup, map }, next, { lines, report }) {
    const [language] = info.trim().match(/^[^\s`]*/);
    if (map[1] - map[0] < 2 || !/^[\s>]*(`{3,}|~{3,})\s*$/.test(lines[map[1] - 1]))
      report(`this fence is never closed; put a line ${markup} after the code`);
    if (CPP.test(language)) report('C++ typed into the prose; cut it from a compiled file with \\listing{path, tag}');
    return { type: 'block', name: 'fence', language, code: content.replace(/\n$/, '') };
  },
  code_block(token, next, { report }) {
    report('code by indentation; put it between ``` lines, or indent it less if it is no code');
  },
  heading_open({ tag, markup, map }, { content: text }, { lines, report }) {
    if (!markup.startsWith('#')) return underlined(lines[map[1] - 1].trim(), message => report(message, map[1]));
    const outsideCode = text.replace(/`[^`]*`/g, '');
    if (/\\f[$[{]/.test(outsideCode)) report('a formula in a heading: write the heading in words');
    else if (/\\[a-z]/i.test(outsideCode)) report('a mark in a heading: headings are plain text and `code`');
    return { type: 'heading', level: Number(tag[1]), text };
  },
  table_open: () => ({ type: 'tablestart' }),
};

// Markdown's other headings would get no name and no number.
function underlined(line, report) {
  report(`${line} below a line of text makes it a heading; write it as "## Heading", or put an empty line between`);
}
