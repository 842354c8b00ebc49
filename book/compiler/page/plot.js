// A plot of a finding: a few lines over two axes, drawn as SVG.
import { element } from './element.js';

const SVG = 'http://www.w3.org/2000/svg';
const [WIDEST, HEIGHT, LEFT, BOTTOM, EDGE] = [560, 300, 64, 40, 12];

function svg(name, attributes, ...content) {
  const made = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...content);
  return made;
}

const roundSteps = [1, 2, 5, 10];

/** Round numbers from the first to the last, about so many. */
function ticksOf([low, high], about) {
  const rough = (high - low) / about;
  const size = 10 ** Math.floor(Math.log10(rough));
  const step = size * roundSteps.find(one => one * size >= rough);
  const first = Math.ceil(low / step - 1e-9);
  return Array.from({ length: Math.floor(high / step + 1e-9) - first + 1 }, (_, i) => (first + i) * step);
}

const powersOf = ([low, high]) =>
  Array.from({ length: Math.floor(high) - Math.ceil(low) + 1 }, (_, i) => Math.ceil(low) + i);

const numberOf = value => String(Number(value.toPrecision(6))).replace('-', '\u2212');

function rangeOf(values) {
  const [low, high] = [Math.min(...values), Math.max(...values)];
  const beyond = (high - low || Math.abs(high) || 1) * 0.04;
  return [low - beyond, high + beyond];
}

// In one unit a path keeps its shape: the narrower of the two is widened.
function inOneUnit(ranges, spans) {
  const size = Math.max(...ranges.map(([low, high], i) => (high - low) / spans[i]));
  return ranges.map(([low, high], i) => {
    const [middle, half] = [(low + high) / 2, (size * spans[i]) / 2];
    return [middle - half, middle + half];
  });
}

/** The points that can be drawn: [[x, y], ...], as logarithms if the axes are. */
const pointsOf = ({ x, y }, logarithmic) =>
  x
    .map((value, i) => [value, y[i]])
    .filter(point => point.every(value => value !== null && (!logarithmic || value > 0)))
    .map(point => (logarithmic ? point.map(Math.log10) : point));

/**
 * @param plot  { title, x, y, sameScale, logarithmic, curves: [{ name, x, y }] }, see words_as_json.h
 * @param room  how wide it may be [px]
 */
export function drawPlot({ title, x, y, sameScale, logarithmic, curves }, room) {
  const width = Math.min(WIDEST, room);
  const lines = curves.map(curve => pointsOf(curve, logarithmic));
  const spans = [width - LEFT - EDGE, HEIGHT - BOTTOM - EDGE];
  const all = [0, 1].map(axis => rangeOf(lines.flat().map(point => point[axis])));
  const [across, up] = sameScale ? inOneUnit(all, spans) : all;
  const atX = value => LEFT + ((value - across[0]) / (across[1] - across[0])) * spans[0];
  const atY = value => HEIGHT - BOTTOM - ((value - up[0]) / (up[1] - up[0])) * spans[1];
  const ticks = range => (logarithmic ? powersOf(range) : ticksOf(range, width < 400 ? 3 : 5));
  const words = value => (logarithmic ? numberOf(10 ** value) : numberOf(value));
  const text = (at, words, more = {}) => svg('text', { x: at[0], y: at[1], ...more }, words);
  const drawn = svg('svg', { 'viewBox': `0 0 ${width} ${HEIGHT}`, 'role': 'img', 'aria-label': title });
  for (const value of ticks(across)) {
    drawn.append(svg('path', { class: 'grid', d: `M${atX(value)} ${EDGE}V${HEIGHT - BOTTOM}` }));
    drawn.append(text([atX(value), HEIGHT - BOTTOM + 15], words(value), { 'text-anchor': 'middle' }));
  }
  for (const value of ticks(up)) {
    drawn.append(svg('path', { class: 'grid', d: `M${LEFT} ${atY(value)}H${width - EDGE}` }));
    drawn.append(text([LEFT - 6, atY(value) + 4], words(value), { 'text-anchor': 'end' }));
  }
  drawn.append(text([LEFT + spans[0] / 2, HEIGHT - 6], x, { 'text-anchor': 'middle' }));
  drawn.append(
    text([0, 0], y, { 'text-anchor': 'middle', 'transform': `translate(13 ${EDGE + spans[1] / 2}) rotate(-90)` }),
  );
  lines.forEach((points, i) => {
    const path = points.map(([px, py], n) => `${n ? 'L' : 'M'}${atX(px).toFixed(1)} ${atY(py).toFixed(1)}`).join('');
    drawn.append(svg('path', { class: `curve curve-${i}`, d: path }));
  });
  const key = element('p', { className: 'key' });
  curves.forEach(({ name }, i) => key.append(element('span', { className: `curve-${i}`, textContent: name }), ' '));
  return element('figure', { className: 'finding' }, element('figcaption', { textContent: title }), drawn, key);
}
