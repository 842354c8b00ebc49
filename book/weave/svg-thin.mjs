// gnuplot's drawing without what a reader can't see: groups around one thing, attributes that are so anyway, points on a line.
import { pathOfDots, pathOfPolygons, shortPath } from './svg-path.mjs';

// What the drawing starts from, so that most groups need not say it.
const GIVEN = {
  'fill': 'none',
  'stroke': 'currentColor',
  'stroke-width': '1',
  'stroke-linecap': 'round',
  'stroke-linejoin': 'round',
};
const INHERITED = [...Object.keys(GIVEN), 'color', 'font-size', 'text-anchor'];

export function thin($, root) {
  Object.assign(root.attribs, GIVEN);
  for (let before = Infinity; $('*').length < before;) {
    before = $('*').length;
    dropInherited(root, {});
    unwrapGroups($);
    mergeGroups($);
  }
  placeTexts($);
  mergeRuns($, 'use', dotOf, writeDots);
  mergeRuns($, 'polygon', e => (e.attribs['fill-opacity'] ? null : e.attribs.points), writePolygons);
  $('path').each((_, e) => {
    if (!inDefs(e)) e.attribs.d = shortPath(e.attribs.d);
  });
}

const isElement = node => node.type === 'tag';
const elements = e => e.children.filter(isElement);
const inDefs = e => e.parent?.name === 'defs';

function dropInherited(e, around) {
  const here = { ...around };
  for (const name of INHERITED) {
    const value = e.attribs[name];
    if (value === undefined) continue;
    if (value === around[name] && !inDefs(e)) delete e.attribs[name];
    here[name] = value;
  }
  for (const [, name] of (e.attribs.style ?? '').matchAll(/(?:^|;)([\w-]+):/g)) here[name] = null;
  for (const child of elements(e)) dropInherited(child, here);
}

const isPlain = e => e.name === 'g' && !inDefs(e) && Object.keys(e.attribs).length === 0;

function unwrapGroups($) {
  $('g').each((_, e) => {
    if (e.parent && isPlain(e)) $(e).replaceWith($(e).contents());
  });
}

const said = attribs => JSON.stringify(Object.entries(attribs).sort());

function next(e) {
  let node = e.next;
  while (node && !isElement(node)) node = node.next;
  return node;
}

function mergeGroups($) {
  $('g').each((_, e) => {
    if (!e.parent || inDefs(e) || 'transform' in e.attribs) return;
    for (let other = next(e); other?.name === 'g' && said(other.attribs) === said(e.attribs); other = next(e)) {
      $(e).append($(other).contents());
      $(other).remove();
    }
  });
}

// A group that moves one text to its place: the text stands there itself.
function placeTexts($) {
  $('g[transform]').each((_, e) => {
    const [text, ...others] = elements(e);
    const moved = e.attribs.transform.match(/^translate\((-?[\d.]+),(-?[\d.]+)\)$/);
    if (!moved || others.length || text?.name !== 'text' || text.attribs.x || text.attribs.y) return;
    const { transform, ...rest } = e.attribs;
    text.attribs = { ...rest, ...text.attribs, x: moved[1], y: moved[2] };
    $(e).replaceWith(text);
  });
}

// Elements of a name that follow each other and are alike but for what `own` takes from them become one, which `write` makes.
function mergeRuns($, name, own, write) {
  const seen = new Set();
  $(name).each((_, e) => {
    if (seen.has(e) || inDefs(e) || !own(e)) return;
    const run = [e];
    for (let other = next(e); other?.name === name && own(other) && alike(e, other, own); other = next(other))
      run.push(other);
    for (const one of run) seen.add(one);
    write($, run, run.map(own));
  });
}

function alike(a, b, own) {
  const rest = e =>
    said(Object.fromEntries(Object.entries(e.attribs).filter(([name]) => !['points', 'transform'].includes(name))));
  return rest(a) === rest(b) && own(a).size === own(b).size;
}

function replace($, run, attribs) {
  const [first, ...others] = run;
  Object.assign(first, { name: 'path', attribs });
  for (const other of others) $(other).remove();
}

function writePolygons($, run, polygons) {
  const { points, ...rest } = run[0].attribs;
  replace($, run, { ...rest, d: pathOfPolygons(polygons.map(turnedOneWay)) });
}

// Two that lie over each other and run round opposite ways would leave a hole where they do.
function turnedOneWay(text) {
  const points = text
    .trim()
    .split(/\s+/)
    .map(pair => pair.split(',').map(Number));
  const area = points.reduce((sum, [x, y], i) => {
    const [toX, toY] = points[(i + 1) % points.length];
    return sum + x * toY - toX * y;
  }, 0);
  return (area < 0 ? points.reverse() : points).map(pair => pair.join(',')).join(' ');
}

// gnuplot's filled circle: { size, at }, or nothing for what is another symbol.
function dotOf(e) {
  const [, x, y, size] = e.attribs.transform?.match(/^translate\((-?[\d.]+),(-?[\d.]+)\) scale\(([\d.]+)\)$/) ?? [];
  return size && e.attribs.href.endsWith('-gpPt6') ? { size, at: [Number(x), Number(y)] } : null;
}

const EDGE = 0.178; // the width of the line round gnuplot's symbols, at scale 1

function writeDots($, run, dots) {
  const colour = run[0].attribs.style?.match(/(?:^|;)color:([^;]+)/)?.[1] ?? 'currentColor';
  const width = Math.round(Number(dots[0].size) * (2 + EDGE) * 10) / 10;
  replace($, run, { d: pathOfDots(dots.map(dot => dot.at)), style: `stroke:${colour};stroke-width:${width}` });
}
