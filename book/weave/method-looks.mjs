// How figures draw the methods, by the register that a program writes:  node method-looks.mjs methods.csv methods.gp
// A line for each: `eval method("Heun", "HEUN", "lc rgb '#000006' ...")`, and the names of those that run against each other.
import { writeFileSync } from 'node:fs';
import { readRecords } from './csv.mjs';

const DASHES = { solid: '', dashed: ' dt (6,4)', dotted: ' dt (2,3)' };

/** The register's methods that are drawn: [{ name, id, colour, dash, symbol, size, width, contender }]; a colour is the N of --plot-N. */
export const readLooks = path =>
  readRecords(path)
    .filter(row => row.colour !== 'none')
    .map(row => ({ ...row, id: row.function.toUpperCase(), colour: Number(row.colour) }));

/** The N of --plot-N of each other style that figure.gp names: [[name, N], ...]. */
export const otherColours = script =>
  [...script.matchAll(/^eval line_style\("(\w+)", "lc rgb '#0000([0-9a-f]{2})'/gm)].map(([, name, colour]) => [
    name,
    parseInt(colour, 16),
  ]);

/** The stand-in of a colour in a script, which the weaver turns into the style sheet's. */
const standIn = colour => `#0000${colour.toString(16).padStart(2, '0')}`;

const line = ({ name, id, colour, dash, symbol, size, width }) =>
  `eval method("${name}", "${id}", "lc rgb '${standIn(colour)}' lw ${width}${DASHES[dash]} pt ${symbol} ps ${size}")\n`;

export function looksScript(looks) {
  const contenders = looks.filter(look => look.contender === 'yes').map(({ name }) => `'${name}'`);
  return `${looks.map(line).join('')}CONTENDERS = "${contenders.join(' ')}"\n`;
}

if (process.argv[1]?.endsWith('method-looks.mjs')) {
  const [from, to] = process.argv.slice(2);
  writeFileSync(to, looksScript(readLooks(from)));
}
