// A small picture of a table: its first column lies across, each other column is a line, and the last of them is as it should be.
import { withoutUnseen } from './svg-path.mjs';
import { tableColumns } from './tables.mjs';
import { escapeHtml, smarten } from './text.mjs';

const WIDTH = 340;
const HEIGHT = 132;
const LEFT = 46;
const BOTTOM = 18;
const TOP = 8;
const RIGHT = 4;
const WILD = 1e4; // a line with so much between its ends has exploded, and leaves the picture
const BEYOND = 1; // of the mended line's range is shown on either side of it then
const TINY = 1e-6; // of the range is nothing, and printed so
const FINE = 0.06; // how far a point may lie beside the line that leaves it out

export function sketchHtml(_context, piece) {
  const [, caption] = piece.args;
  const columns = tableColumns(piece.table);
  const names = Object.keys(columns);
  const [across, ...lines] = Object.values(columns);
  const { low, high } = range(lines);
  const x = value => LEFT + ((WIDTH - LEFT - RIGHT) * (value - across[0])) / (across.at(-1) - across[0]);
  const y = value => HEIGHT - BOTTOM - ((HEIGHT - BOTTOM - TOP) * (value - low)) / (high - low);
  const drawn = lines.map((line, i) => `<path class="${kind(i, lines)}" d="${pathOf(across.map(x), line.map(y))}"/>`);
  const unit = piece.table.columns.find(({ column }) => column === names[1]).unit;
  const legend = names
    .slice(1)
    .map((name, i) => `<span class="key ${kind(i, lines)}">${escapeHtml(smarten(name))}</span>`);
  const id = `clip-${piece.table.name}`;
  return (
    `<figure class="sketch" id="sketch-${piece.table.name}"><svg viewBox="0 0 ${WIDTH} ${HEIGHT}" role="img" aria-label="${escapeHtml(smarten(caption))}">` +
    `<clipPath id="${id}"><rect x="${LEFT}" y="${TOP}" width="${WIDTH - LEFT - RIGHT}" height="${HEIGHT - TOP - BOTTOM}"/></clipPath>` +
    `<path class="frame" d="M${LEFT} ${TOP}V${HEIGHT - BOTTOM}H${WIDTH - RIGHT}"/>` +
    (low < 0 && high > 0 ? `<path class="zero" d="M${LEFT} ${round(y(0))}H${WIDTH - RIGHT}"/>` : '') +
    `<g clip-path="url(#${id})">${drawn.join('')}</g>` +
    `<text x="${LEFT - 5}" y="${TOP + 9}" class="end">${short(high)}</text><text x="${LEFT - 5}" y="${TOP + 22}" class="end">${escapeHtml(unit.split(' ')[0])}</text>` +
    `<text x="${LEFT - 5}" y="${HEIGHT - BOTTOM}" class="end">${short(low)}</text>` +
    `<text x="${LEFT}" y="${HEIGHT - 4}">${short(across[0])}</text>` +
    `<text x="${WIDTH - RIGHT}" y="${HEIGHT - 4}" class="end">${escapeHtml(names[0])} ${short(across.at(-1))}</text></svg>` +
    `<figcaption><p>${escapeHtml(smarten(caption))}</p><p class="keys">${legend.join(' ')}</p></figcaption></figure>`
  );
}

const kind = (i, lines) => (i === lines.length - 1 ? 'mended' : i === 0 ? 'ill' : 'ill second');

// From the least to the most of all lines; of one that explodes, what is near the mended one.
function range(lines) {
  const ends = values => [Math.min(...values), Math.max(...values)];
  const [least, most] = ends(lines.at(-1));
  const room = BEYOND * (most - least);
  let [low, high] = [least, most];
  for (const line of lines) {
    const [from, to] = ends(line.filter(Number.isFinite));
    const wild = to - from > WILD;
    low = Math.min(low, wild ? least - room : from);
    high = Math.max(high, wild ? most + room : to);
  }
  const nought = end => (Math.abs(end) < TINY * (high - low) ? 0 : end);
  return high > low ? { low: nought(low), high: nought(high) } : { low, high: low + 1 };
}

const round = number => Math.round(number * 10) / 10;
const short = number =>
  String(Number(number.toPrecision(2)))
    .replace('-', '−')
    .replace(/e\+?/, 'e');

function pathOf(xs, ys) {
  const kept = xs.map((x, i) => [x, Math.max(-HEIGHT, Math.min(2 * HEIGHT, ys[i]))]);
  return `M${withoutUnseen(kept, FINE)
    .map(point => point.map(round).join(' '))
    .join('L')}`;
}
