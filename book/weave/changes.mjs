// "Change it": the programs of a chapter with the changes that its prose proposes.
import { slug } from './text.mjs';

const fences = (text, kind) =>
  [...text.matchAll(new RegExp(`^\`\`\`${kind}\\n([^]*?)^\`\`\``, 'gm'))].map(([, code]) => code);

const BOX = /^\\change\{(.*)\}\n([^]*?)^\\endchange/gm;

/** The changes of a chapter's prose: [{ name, title, diffs: [text, ...], prints: [text, ...] }]. */
export const readChanges = prose =>
  [...prose.matchAll(BOX)].map(([, title, text]) => ({
    name: slug(title),
    title,
    diffs: fences(text, 'diff'),
    prints: fences(text, 'prints'),
  }));

/** What the chapter quotes of the programs as they are. */
export const readQuoted = prose => fences(prose.replace(BOX, ''), 'prints');

// Where the lines that a diff finds stand in a text, and the diff's rows as deep as these; null if they don't stand there just once.
function placeOf(text, diff) {
  const rows = diff
    .trimEnd()
    .split('\n')
    .map(row => ({ sign: row[0], code: row.slice(1) }));
  const found = rows.filter(({ sign }) => sign !== '+');
  const lines = text.split('\n');
  const at = lines.flatMap((_, i) => (found.every(({ code }, k) => lines[i + k]?.trim() === code.trim()) ? [i] : []));
  if (at.length !== 1) return null;
  const deeper = indentOf(found[0].code) - indentOf(lines[at[0]]);
  return {
    line: at[0] + 1,
    rows: rows.map(({ sign, code }) => ({ sign, code: code.slice(Math.min(deeper, indentOf(code))) })),
  };
}

const indentOf = line => line.match(/^ */)[0].length;

/**
 * The one program that a change fits, and what becomes of it.
 * @param programs { name: text }
 * @returns { program, text, edits: [{ line, rows: [{ sign, code }, ...] }, ...] }, by lines of the program as it is, with the signs of a diff;
 *   or { fault }
 */
export function applyChange(programs, { diffs }) {
  const fits = Object.keys(programs).filter(name => placeOf(programs[name], diffs[0]));
  if (fits.length !== 1) return { fault: `its lines stand in ${fits.length} programs, where they should stand in one` };
  const [program] = fits;
  const edits = diffs.map(diff => placeOf(programs[program], diff));
  const lost = edits.indexOf(null);
  if (lost >= 0) return { fault: `these lines do not stand in ${program}.cpp once:\n${diffs[lost]}` };
  edits.sort((a, b) => a.line - b.line);
  const lines = programs[program].split('\n');
  for (const { line, rows } of [...edits].reverse()) {
    const without = sign => rows.filter(row => row.sign !== sign);
    lines.splice(line - 1, without('+').length, ...without('-').map(({ code }) => code));
  }
  return { program, text: lines.join('\n'), edits };
}
