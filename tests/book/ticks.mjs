// Reads a figure's axes out of its SVG and says which labels stand where their value does not belong.
import * as cheerio from 'cheerio';
import { quantities } from './quantities.mjs';

const NEAR = 0.6;

// axes: { x, y, panels }, each axis with min and max in the data and pixel_min and pixel_max in the drawing. A panel has left,
// right, bottom and top on these axes, and x and y, each a pair: what its own axes begin and end with.
// Returns { labels, faults }: how many labels with a number were read, and what is wrong with them.
export function checkTicks(svg, axes) {
  const $ = cheerio.load(svg, { xml: true });
  const inside = (axes.panels ?? []).map(panel => axesOf(panel, axes));
  const results = (inside.length ? inside : [axes]).flatMap(found =>
    ['x', 'y'].map(name => checkAxis(name, found[name], labelsOf($, name, found), marksOf($, name, found))),
  );
  return { labels: results.reduce((sum, r) => sum + r.labels, 0), faults: results.flatMap(r => r.faults) };
}

function axesOf({ left, right, bottom, top, x, y }, axes) {
  const axis = (whole, [min, max], from, to) => {
    const pixel = value =>
      whole.pixel_min + ((value - whole.min) / (whole.max - whole.min)) * (whole.pixel_max - whole.pixel_min);
    return { min, max, pixel_min: pixel(from), pixel_max: pixel(to) };
  };
  return { x: axis(axes.x, x, left, right), y: axis(axes.y, y, bottom, top), isPanel: true };
}

// Numbers below the horizontal axis, centred, and left of the vertical one, flush right.
function labelsOf($, name, { x, y, isPanel }) {
  const reach = name === 'x' ? 9 : 70; // names of a panel's vertical axis stand left of it
  const near = (left, height) =>
    !isPanel ||
    (left > x.pixel_min - reach && left < x.pixel_max + 9 && height > y.pixel_max - 9 && height < y.pixel_min + 25);
  const labels = [];
  $('text').each((_, text) => {
    const group = $(text).closest('g[transform]');
    const [left, baseline] = group
      .attr('transform')
      .match(/-?[\d.]+/g)
      .map(Number);
    const height = baseline - 0.325 * Number(group.attr('font-size'));
    const written = textOf($, text);
    const anchor = group.attr('text-anchor');
    if (!near(left, height)) return;
    if (name === 'x' && anchor === 'middle' && baseline > y.pixel_min && baseline < y.pixel_min + 45)
      labels.push({ written, at: left });
    if (name === 'y' && anchor === 'end' && left < x.pixel_min) labels.push({ written, at: height });
  });
  return labels.map(label => ({ ...label, values: quantities(label.written) })).filter(label => label.values.length);
}

const textOf = ($, text) =>
  $(text)
    .contents()
    .map((_, part) => {
      const written = $(part).text();
      return Number.parseFloat(part.attribs?.dy) < 0 && written ? `^{${written}}` : written;
    })
    .get()
    .join('')
    .trim();

// Short strokes that start on the axis and stand across it.
function marksOf($, name, { x, y }) {
  const strokes = $('path')
    .map((_, path) => path.attribs.d)
    .get()
    .flatMap(d =>
      [...d.matchAll(/M(-?[\d.]+),(-?[\d.]+) L(-?[\d.]+),(-?[\d.]+)(?=\s*(M|$))/g)].map(found =>
        found.slice(1, 5).map(Number),
      ),
    );
  const on = (a, b) => Math.abs(a - b) < 0.3;
  const short = (a, b) => Math.abs(a - b) > 0.5 && Math.abs(a - b) < 15;
  return strokes.flatMap(([x1, y1, x2, y2]) =>
    name === 'x'
      ? on(x1, x2) && on(y1, y.pixel_min) && short(y1, y2)
        ? [x1]
        : []
      : on(y1, y2) && on(x1, x.pixel_min) && short(x1, x2)
        ? [y1]
        : [],
  );
}

function checkAxis(name, axis, labels, marks) {
  if (!labels.length) return { labels: 0, faults: [] };
  const faults = [];
  for (const label of labels) {
    const mark = marks.find(at => Math.abs(at - label.at) < 1);
    if (mark !== undefined) label.at = mark;
    else if (marks.length) faults.push(`${name} axis: "${label.written}" has no tick mark`);
  }
  const tries = scales(axis).flatMap(scale =>
    unitsOf(labels).map(unit => distances(labels, value => scale(value / unit))),
  );
  const total = distances => distances.reduce((sum, { by }) => sum + by, 0);
  for (const { written, at, right, by } of tries.reduce((a, b) => (total(b) < total(a) ? b : a))) {
    if (by > NEAR)
      faults.push(`${name} axis: "${written}" stands at ${at.toFixed(1)}, its value belongs to ${right.toFixed(1)}`);
  }
  return { labels: labels.length, faults };
}

// gnuplot does not tell whether an axis is logarithmic: all labels have to fit one of the two.
function scales({ min, max, pixel_min, pixel_max }) {
  const place = part => pixel_min + part * (pixel_max - pixel_min);
  const linear = value => place((value - min) / (max - min));
  const logarithmic = value => place(Math.log(value / min) / Math.log(max / min));
  return min > 0 && max > 0 ? [linear, logarithmic] : [linear];
}

// An axis may count in any unit that its labels show: 1 km stands at 1000, or at 1.
const unitsOf = labels => [...new Set([1, ...labels.flatMap(label => label.values.map(value => value.unit))])];

function distances(labels, place) {
  return labels.flatMap(({ written, values, at }) =>
    values.map(({ value }) => {
      const right = place(value);
      return { written, at, right, by: Number.isFinite(right) ? Math.abs(right - at) : Infinity };
    }),
  );
}
