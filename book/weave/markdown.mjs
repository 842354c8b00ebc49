// What Markdown itself writes in a chapter and the book treats in its own way: fences, headings, comments, pictures, code.
// Each function takes what starts at `at`: { end, piece }, or undefined if it is something else.
const CPP = /^\{?\.?(c|cc|cpp|c\+\+|cxx|h|hpp)\b/i;

export function sticky(pattern, source, at) {
  const regex = new RegExp(pattern, 'y');
  regex.lastIndex = at;
  return regex.exec(source);
}

export function fence({ source, report }, at) {
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
  const code = source
    .slice(from, from + close.index)
    .replace(new RegExp(`^ {0,${indent}}`, 'gm'), '')
    .replace(/\n$/, '');
  return { end: from + close.index + close[0].length, piece: { type: 'block', name: 'fence', language, code } };
}

export function heading({ source, report }, at) {
  const found = sticky(/(#{1,6})[ \t]+([^\n]*?)[ \t]*#*[ \t]*(?=\n|$)/, source, at);
  if (!found) return undefined;
  const [all, marks, text] = found;
  const outsideCode = text.replace(/`[^`]*`/g, '');
  if (/\\f[$[{]/.test(outsideCode)) report('a formula in a heading: write the heading in words');
  else if (/\\[a-z]/i.test(outsideCode)) report('a mark in a heading: headings are plain text and `code`');
  return { end: at + all.length, piece: { type: 'heading', level: marks.length, text } };
}

// Markdown's other headings, a line of dashes below a line of text, would get no name and no number.
export function underline({ source, report }, at) {
  const found = sticky(/(-{2,}|={2,})[ \t]*(?=\n|$)/, source, at);
  if (!found || /(^|\n)[ \t]*\n$/.test(source.slice(0, at))) return undefined;
  report(`${found[1]} below a line of text makes it a heading; write it as "## Heading", or put an empty line between`);
  return { end: at + found[0].length, piece: null };
}

export function comment({ source, report }, at) {
  if (!source.startsWith('<!--', at)) return undefined;
  const end = source.indexOf('-->', at);
  if (end < 0) report('this comment is never closed; put --> after it');
  return { end: end < 0 ? source.length : end + 3, piece: null };
}

export function image({ source, report }, at) {
  const found = sticky(/!\[|<img\b/, source, at);
  if (!found) return undefined;
  report('a picture from outside; pictures of this book are drawn by a script of the chapter: \\figure{name, Title}');
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
  const span = sticky(/(`+)(?!`)((?:(?!\n[ \t]*\n)[\s\S])*?[^`])\1(?!`)/, source, at);
  if (!span) {
    report(`this code span is never closed; put ${ticks} after it, or write \\\` for a backtick`);
    return { end: at + ticks.length, piece: null };
  }
  if (ticks.length > 2 && span[2].includes('\n'))
    report(
      `a fence starts on a line of its own; put ${ticks} on the next line, indented like the text of its list item`,
    );
  const code = span[2].replace(/\s+/g, ' ').replace(/^ (.*`.*) $/, '$1');
  return { end: at + span[0].length, piece: { type: 'inline', name: 'code', code } };
}
