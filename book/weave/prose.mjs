// The text that Doxygen gets to see: prose, with each mark, formula and piece of code carried along as a token.

// Characters of Unicode's private area frame the number of a piece; Doxygen takes the whole for a plain word.
export const token = n => `\ue000${n}\ue001`;
export const TOKEN = /\ue000(\d+)\ue001/g;

export const doxygenLabel = page => `weavepage${page.order}`;

// Returns the text and, for each of its lines, the line of the chapter that it came from.
export function forDoxygen(pieces, page, problems) {
  const out = { text: '', map: [] };
  let afterBlock = null;
  for (const piece of pieces) {
    if (piece.type === 'text')
      put(out, afterBlock ? reindent(piece.text, afterBlock.indent) : piece.text, piece.line, 1);
    else if (piece.type === 'heading') put(out, headingLine(piece, page), piece.line, 1);
    else if (piece.type === 'inline') put(out, (afterBlock?.indent ?? '') + token(piece.token), piece.line, 0);
    else {
      put(
        out,
        `${/(^|\n)[ \t]*$/.test(out.text) ? '' : '\n'}\n${piece.indent}${token(piece.token)}\n\n`,
        piece.line,
        0,
      );
      afterBlock = piece;
      continue;
    }
    if (piece.type !== 'text' || piece.text.trim() || piece.text.includes('\n')) afterBlock = null;
  }
  const marked = markTables(out, page, problems);
  const text = emphasise(marked).replace(/\]\(#/g, `](${page.href}#`);
  return { doxygenText: text, lineMap: [...out.map, out.map.at(-1) ?? 1] };
}

function put(out, part, line, step) {
  for (const c of part) {
    if (c !== '\n') continue;
    out.map.push(line);
    line += step;
  }
  out.text += part;
}

const headingLine = (piece, page) =>
  piece.level === 1 ? `# ${page.name} {#${doxygenLabel(page)}}` : `${'#'.repeat(piece.level)} ${token(piece.token)}`;

// Text behind a block starts a line of its own, as deep in its list as the block was.
function reindent(text, indent) {
  const rest = text.replace(/^[ \t]+/, '');
  return rest === '' || rest.startsWith('\n') ? rest : indent + rest;
}

// Doxygen takes `*x*` for emphasis only between certain neighbours (not before a dash, nor behind a token): its HTML tags have no such trap.
function emphasise(text) {
  const inParagraph = '(?:(?!\\n[ \\t]*\\n)[^*])';
  return text
    .replace(
      new RegExp(
        `(?<![\\\\*])\\*\\*(?=[^\\s*])(${inParagraph}+?(?:\\*${inParagraph}+?\\*${inParagraph}*?)*)(?<=[^\\s\\\\])\\*\\*(?!\\*)`,
        'g',
      ),
      '<b>$1</b>',
    )
    .replace(new RegExp(`(?<![\\\\*])\\*(?=[^\\s*])(${inParagraph}+?)(?<=[^\\s\\\\])\\*(?!\\*)`, 'g'), '<em>$1</em>');
}

const SEPARATOR = /^\s*\|?\s*:?-{2,}:?\s*(\|\s*:?-{2,}:?\s*)*\|?\s*$/;
const QUOTED = /^\s*(?:>|[-*+]\s|\d+\.\s)[>\s]*\|/;
const cells = row =>
  row
    .trim()
    .replace(/^\||(?<!\\)\|$/g, '')
    .split(/(?<!\\)\|/).length;

// Checks the rows of every Markdown table, and puts a token into its first cell, so that one that Doxygen
// does not take for a table is found out.
function markTables(out, page, problems) {
  const lines = out.text.split('\n');
  for (let i = 0; i < lines.length; ++i) {
    if (QUOTED.test(lines[i]) && !QUOTED.test(lines[i - 1]))
      problems.add(
        page.file,
        out.map[i] ?? 1,
        'a table cannot start behind a > or in the line of a list mark: Doxygen makes a paragraph of it; put it on lines of its own',
      );
    const starts =
      /^\s*\|/.test(lines[i]) ||
      (lines[i].includes('|') && SEPARATOR.test(lines[i + 1] ?? '') && lines[i + 1].includes('|'));
    if (!starts) continue;
    let end = i;
    while (end < lines.length && lines[end].includes('|')) ++end;
    checkIndent(lines, i, () => out.map[i] ?? 1, page, problems);
    checkRows(lines.slice(i, end), row => out.map[i + row] ?? 1, page, problems);
    const piece = { type: 'tablestart', token: page.pieces.length, line: out.map[i] ?? 1 };
    page.pieces.push(piece);
    lines[i] = lines[i].replace(/^(\s*\|?\s*)/, `$1${token(piece.token)}`);
    i = end;
  }
  return lines.join('\n');
}

// Doxygen ends the list before an indented table that an empty line stands above, and counts the items below from 1 again.
function checkIndent(lines, i, lineOf, page, problems) {
  if (/^\s/.test(lines[i]) && !lines[i - 1]?.trim())
    problems.add(
      page.file,
      lineOf(),
      'this table stands apart from its list item; put it right below the text of the item, without an empty line, or do not indent it',
    );
}

function checkRows(rows, lineOf, page, problems) {
  if (!SEPARATOR.test(rows[1] ?? '')) {
    problems.add(
      page.file,
      lineOf(0),
      'this table has no row of dashes below its head; write |---|---| as its second line',
    );
    return;
  }
  if (rows.length < 3)
    problems.add(page.file, lineOf(0), 'this table has a head and no rows; write its rows right below the dashes');
  const wanted = cells(rows[0]);
  rows.forEach((row, i) => {
    if (cells(row) !== wanted)
      problems.add(
        page.file,
        lineOf(i),
        `this row has ${cells(row)} cells and the head of its table ${wanted}; a | that is no border is written \\|`,
      );
  });
}
