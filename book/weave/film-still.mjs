// A film's last picture as an SVG: for paper, and for readers without scripts.
import { runInNewContext } from 'node:vm';
import { withoutUnseen } from './svg-path.mjs';
import { escapeHtml } from './text.mjs';

const WIDTH = 480;
const LETTER = 10; // how wide one is at most, on a phone
const PLAIN = 0.4; // how far a trail may be from where it should be

/** What a film's page shows: { view: [left, bottom, right, top], names: [colour, ...], pictures: [[seconds, [kind, number of its colour, x, y, ...], ...], ...] }. */
export const readPictures = page =>
  runInNewContext(`(() => { ${page.match(/const view = [^]*?\]\];/)[0]} return { view, names, pictures }; })()`);

/** `colours` has the N of --plot-N for the names that programs call colours by. */
export function stillHtml({ view: [left, bottom, right, top], names, pictures }, colours, words) {
  const scale = WIDTH / (right - left);
  const place = (x, y) => [(x - left) * scale, (top - y) * scale];
  const shapes = pictures.at(-1).slice(1);
  const trails = trailsOf(pictures, place);
  const drawn = {
    circle: (at, radius) => `<circle cx="${short(at[0])}" cy="${short(at[1])}" r="${short(radius * scale)}"/>`,
    line: (at, ...to) => `<path d="M${at.map(short)}L${place(...to).map(short)}"/>`,
    trail: () => `<path d="${trails.shift()}"/>`,
  };
  const strokes = shapes
    .filter(([kind]) => kind !== 'label')
    .map(([kind, number, x, y, ...more]) => [colours.get(names[number]), drawn[kind](place(x, y), ...more)]);
  const labels = shapes.filter(([kind]) => kind === 'label').map(([, , x, y, text]) => ({ at: place(x, y), text }));
  return (
    `<svg class="still" viewBox="0 0 ${WIDTH} ${short((top - bottom) * scale)}" role="img" aria-label="${words}">` +
    `${inRuns(strokes)}${labels.map(label => labelSvg(label, labels)).join('')}</svg>`
  );
}

const short = number => Number(number.toFixed(1));

// What follows each other in one colour, in a group.
function inRuns(strokes) {
  const runs = [];
  for (const [colour, svg] of strokes) {
    if (runs.at(-1)?.colour !== colour) runs.push({ colour, svgs: [] });
    runs.at(-1).svgs.push(svg);
  }
  return runs.map(({ colour, svgs }) => `<g style="color:var(--plot-${colour})">${svgs.join('')}</g>`).join('');
}

// As the player does it, for the width at which there is least room.
function labelSvg({ at: [x, y], text }, labels) {
  const wide = words => words.length * LETTER;
  const beside = labels.filter(({ at }) => at[0] !== x && at[1] === y).map(({ at }) => Math.abs(at[0] - x));
  const lines = wide(text) > Math.min(...beside) ? text.split(' ') : [text];
  const half = Math.max(...lines.map(wide)) / 2;
  const middle = short(Math.min(Math.max(x, half), WIDTH - half));
  const [first, ...more] = lines.map(escapeHtml);
  const below = more.map(words => `<tspan x="${middle}" dy="1.2em">${words}</tspan>`).join('');
  return `<text x="${middle}" y="${short(y)}">${first}${below}</text>`;
}

// The path of each trail to its end.
function trailsOf(pictures, place) {
  const trails = [];
  for (const [, ...shapes] of pictures)
    shapes
      .filter(([kind]) => kind === 'trail')
      .forEach(([, , x, y], k) => (trails[k] ??= []).push(place(x, y).map(short)));
  return trails.map(points =>
    withoutRepeats(points)
      .map(part => path(withoutUnseen(part, PLAIN)))
      .join(''),
  );
}

const path = points =>
  `M${points[0]}l${points
    .slice(1)
    .map((to, i) => to.map((x, k) => short(x - points[i][k])))
    .join(' ')}`;

// In parts, without the steps that it has made before: a circle is drawn once, however often it is gone round.
function withoutRepeats(points) {
  const made = new Set();
  const parts = [[points[0]]];
  points.slice(1).forEach((to, i) => {
    const step = `${points[i]} ${to}`;
    if (made.has(step)) parts.push([to]);
    else parts.at(-1).push(to);
    made.add(step);
  });
  return parts.filter(part => part.length > 1);
}
