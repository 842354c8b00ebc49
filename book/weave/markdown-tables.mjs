// Tables in Markdown, as a rule of markdown-it. Its own rule takes a bar within code or a formula for a border, and drops a
// cell that is too much without a word.
const SEPARATOR = /^\|?\s*:?-{2,}:?\s*(\|\s*:?-{2,}:?\s*)*\|?$/;

export function tableRule(state, first, last, silent) {
  const row = line => state.src.slice(state.bMarks[line] + state.tShift[line], state.eMarks[line]).trim();
  const isRow = line => line < last && state.sCount[line] >= state.blkIndent && row(line).includes('|');
  const separated = isRow(first + 1) && SEPARATOR.test(row(first + 1));
  if (!isRow(first) || !(row(first).startsWith('|') || separated)) return false;
  if (silent) return true;
  let end = first + 1;
  while (isRow(end)) ++end;
  const rows = Array.from({ length: end - first }, (_, i) => cells(row(first + i)));
  check(rows, separated, (i, message) => state.env.report(first + i + 1, message));
  const sides = rows[1]?.map(side) ?? [];
  open(state, 'table', first, () => {
    open(state, 'thead', first, () => pushRow(state, 'th', rows[0], sides, first));
    open(state, 'tbody', first, () =>
      rows.slice(2).forEach((row, i) => pushRow(state, 'td', row, sides, first + 2 + i)),
    );
  });
  state.line = end;
  return true;
}

function cells(row) {
  const found = [''];
  const inner = row.replace(/^\||(?<!\\)\|$/g, '');
  for (const [part] of inner.matchAll(/\\f\$.*?\\f\$|(`+).+?\1|\\.|[^\\`|]+|./g)) {
    if (part === '|') found.push('');
    else found[found.length - 1] += part;
  }
  return found.map(cell => cell.trim());
}

const side = dashes => (dashes.endsWith(':') ? (dashes.startsWith(':') ? 'center' : 'right') : '');

function check(rows, separated, report) {
  if (!separated) {
    report(0, 'this table has no row of dashes below its head; write |---|---| as its second line');
    return;
  }
  if (rows.length < 3) report(0, 'this table has a head and no rows; write its rows right below the dashes');
  const wanted = rows[0].length;
  rows.forEach((row, i) => {
    if (row.length !== wanted)
      report(
        i,
        `this row has ${row.length} cells and the head of its table ${wanted}; a | that is no border is written \\|`,
      );
  });
}

function open(state, tag, line, fill) {
  state.push(`${tag}_open`, tag, 1).map = [line, line + 1];
  fill();
  state.push(`${tag}_close`, tag, -1);
}

function pushRow(state, tag, row, sides, line) {
  open(state, 'tr', line, () =>
    row.forEach((content, i) => {
      const cell = state.push(`${tag}_open`, tag === 'th' && !content ? 'td' : tag, 1);
      if (cell.tag === 'th') cell.attrSet('scope', 'col');
      if (sides[i]) cell.attrSet('class', sides[i]);
      Object.assign(state.push('inline', '', 0), { content, children: [], map: [line, line + 1] });
      state.push(`${tag}_close`, cell.tag, -1);
    }),
  );
}
