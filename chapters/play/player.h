// SPDX-License-Identifier: MIT-0
/// @file
/// The page that plays a film, without the film: plain HTML, a canvas and a slider.
#pragma once

namespace play {

inline constexpr char player_head[] = R"html(<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>A film of One Step at a Time</title>
<style>
:root { color-scheme: light dark; font: 15px/1.4 "Book Sans", system-ui, sans-serif }
body { margin: 0 auto; max-width: 64rem }
h1 { font-size: 1.1rem; margin: .8rem .6rem }
.framed h1 { position: absolute; left: -99rem }
canvas { display: block; width: 100% }
form { display: flex; align-items: center; gap: .8rem; padding: .4rem .6rem; line-height: 1.2 }
button { font: inherit; width: 5rem; min-height: 2.2rem; border: 1px solid; border-radius: 6px; background: none; color: inherit }
input { flex: 1; min-width: 0; height: 1.8rem; margin: 0; color: inherit }
p { margin: 0; min-width: 5.5rem; text-align: right; font-variant-numeric: tabular-nums }
small { display: block }
small:empty { display: none }
/* The played part is the strong one, up to the middle of the thumb; where a reader has chosen all colours, it looks as everywhere else. */
@media (forced-colors: none) {
  input {
    --end: calc(.5rem + var(--played) * (100% - 1rem)); appearance: none;
    background: linear-gradient(to right, currentColor var(--end), color-mix(in srgb, currentColor 25%, transparent) 0) center / 100% .3rem no-repeat;
  }
  ::-webkit-slider-thumb { appearance: none; width: 1rem; height: 1rem; border-radius: 50%; background: currentColor }
  ::-moz-range-track { background: none }
  ::-moz-range-thumb { border: 0; width: 1rem; height: 1rem; border-radius: 50%; background: currentColor }
}
@media print { form { display: none } }
</style>
<main>
<h1></h1>
<noscript><p>Scripts draw this film.</p></noscript>
<canvas role="img"></canvas>
<form><button type="button">Play</button><input type="range" aria-label="Time" step="any"><p><output></output><small></small></p></form>
</main>
<script>
)html";

inline constexpr char player_tail[] = R"html(
const colours = {
  light: {
    'Euler': '#ca3e00', 'symplectic Euler': '#0063b2', 'velocity Verlet': '#30613b', 'RK4': '#6e009c',
    'backward Euler': '#622a00', 'predicted Euler': '#622a00', 'midpoint': '#168a9a', 'Störmer–Verlet': '#30613b', 'leapfrog': '#30613b',
    'Yoshida 4': '#748043', 'BDF2': '#6a7adf', 'trapezoid': '#a53065', 'true': '#3a3835', 'yours': '#a08b14',
    'scenery': '#938c81', 'paper': '#fffefb', 'ink': '#22211f',
  },
  dark: {
    'Euler': '#ff5a00', 'symplectic Euler': '#0089d9', 'velocity Verlet': '#00b68a', 'RK4': '#c392f5',
    'backward Euler': '#c5a872', 'predicted Euler': '#c5a872', 'midpoint': '#7adff0', 'Störmer–Verlet': '#00b68a', 'leapfrog': '#00b68a',
    'Yoshida 4': '#c3cc58', 'BDF2': '#7a8db3', 'trapezoid': '#f89fc6', 'true': '#e4e0d8', 'yours': '#fbf04a',
    'scenery': '#77747a', 'paper': '#17171a', 'ink': '#dedad2',
  },
};
const [title, canvas, button, slider, clock, pace] = ['h1', 'canvas', 'button', 'input', 'output', 'small'].map(name => document.querySelector(name));
const pen = canvas.getContext('2d'), [left, bottom, right, top_] = view;
const still = matchMedia('(prefers-reduced-motion: reduce)'), dark = matchMedia('(prefers-color-scheme: dark)');
// The pictures with the time at which each begins, and the points of the trails.
function reelOf({ names, pictures }) {
  const begins = [], trails = [];
  let length = 0;
  pictures.forEach(([seconds, ...shapes], n) => {
    begins.push(length);
    length += seconds;
    shapes.filter(([kind]) => kind === 'trail').forEach(([, , x, y], k) => (trails[k] ??= []).push({ n, x, y }));
  });
  return { names, pictures, begins, trails, length };
}
const reel = reelOf({ names, pictures }), { length } = reel;
// What the film is compared with, faintly behind it; a page that has none does not name it.
const behind = typeof ghost === 'undefined' ? null : reelOf(ghost);
let playing = false, inSight = false, before = 0, next = 0;
title.textContent = document.title;
canvas.setAttribute('aria-label', `${document.title}: a series of drawings`);
document.documentElement.classList.toggle('framed', self !== top);
slider.max = length;
slider.value = still.matches ? length : 0;
const times = n => `${Number(n.toPrecision(2))} times`;
if (speed !== 1) pace.textContent = speed === 0.5 ? 'half as fast' : speed < 1 ? `${times(1 / speed)} slower` : speed === 2 ? 'twice as fast' : `${times(speed)} as fast`;
const ended = () => slider.value > length - 0.001;  // the slider rounds
canvas.style.aspectRatio = (right - left) / (top_ - bottom);

// The book says by #light or #dark which of them its reader chose.
const scheme = () => location.hash.slice(1) || (dark.matches ? 'dark' : 'light');

function draw() {
  const scale = canvas.width / (right - left);
  const { paper, ink } = colours[scheme()];
  Object.assign(document.documentElement.style, { colorScheme: scheme(), background: paper, color: ink });
  pen.setTransform(1, 0, 0, 1, 0, 0);
  pen.clearRect(0, 0, canvas.width, canvas.height);
  pen.lineWidth = 2 * devicePixelRatio;
  pen.lineCap = pen.lineJoin = 'round';
  const place = (x, y) => [(x - left) * scale, (top_ - y) * scale];
  pen.globalAlpha = 0.35;
  if (behind) drawShapes(behind, scale, place);
  pen.globalAlpha = 1;
  const shapes = drawShapes(reel, scale, place);
  pen.fillStyle = ink;
  labels(shapes.filter(([kind]) => kind === 'label'), scale, place);
  tellTime(Number(slider.value));
}

// Draws the picture of this moment, but for its labels, and returns what is in it.
function drawShapes({ names, pictures, begins, trails }, scale, place) {
  const shown = begins.findLastIndex(begin => begin <= slider.value), [, ...shapes] = pictures[shown];
  let trail = 0;
  for (const [kind, number, x, y, ...more] of shapes) {
    const colour = names[number];
    if (!colours.light[colour]) throw Error(`no method has the colour "${colour}"`);
    pen.fillStyle = pen.strokeStyle = colours[scheme()][colour];
    pen.beginPath();
    if (kind === 'circle') pen.arc(...place(x, y), more[0] * scale, 0, 7), pen.fill();
    if (kind === 'line') pen.moveTo(...place(x, y)), pen.lineTo(...place(...more)), pen.stroke();
    if (kind === 'trail') {
      for (const point of trails[trail++]) if (point.n <= shown) pen.lineTo(...place(point.x, point.y));
      pen.stroke();
    }
  }
  return shapes;
}

// A label stands in the middle of its place and within the picture; in a row its words go below each other if there is no room.
function labels(all, scale, place) {
  const line = 17 * devicePixelRatio;
  pen.font = `${14 * devicePixelRatio}px ${getComputedStyle(canvas).fontFamily}`;
  pen.textAlign = 'center';
  pen.textBaseline = 'middle';
  for (const [, , x, y, words] of all) {
    const room = Math.min(...all.filter(other => other[2] !== x && other[3] === y).map(other => Math.abs(other[2] - x))) * scale;
    const lines = pen.measureText(words).width > 0.9 * room ? words.split(' ') : [words], [across, down] = place(x, y);
    const half = Math.max(...lines.map(text => pen.measureText(text).width)) / 2 + line / 4;
    const middle = Math.min(Math.max(across, half), canvas.width - half);
    lines.forEach((text, k) => pen.fillText(text, middle, down + k * line));
  }
}

function tellTime(seconds) {
  const now = seconds.toFixed(length < 3 ? 2 : 1);
  clock.value = `${now} s`;
  slider.setAttribute('aria-valuetext', `${now} seconds of play`);
  slider.style.setProperty('--played', seconds / length);
}

function frame(now) {
  if (!playing || !inSight) return;
  slider.value = Number(slider.value) + (Math.min(now - before, 100) / 1000) * speed;
  before = now;
  if (ended()) play(false);
  draw();
  next = requestAnimationFrame(frame);
}

function goOn() {
  cancelAnimationFrame(next);
  next = requestAnimationFrame(now => frame((before = now)));
}

// `on` is what the reader wants: out of sight the film waits.
function play(on) {
  if (on && ended()) slider.value = 0;
  playing = on;
  button.textContent = on ? 'Stop' : ended() ? 'Again' : 'Play';
}

button.onclick = () => {
  play(!playing);
  inSight = true;
  goOn();
};
slider.oninput = () => (play(false), draw());
dark.onchange = onhashchange = draw;
document.fonts.ready.then(draw);
onresize = () => {
  canvas.width = canvas.clientWidth * devicePixelRatio;
  canvas.height = canvas.width * (top_ - bottom) / (right - left);
  draw();
};
// In a task of its own, since a long film takes a while to be read.
setTimeout(() => {
  onresize();
  if (!still.matches) play(true);
});
// Begins, and begins again, where half of it is in sight, and waits where less than a third is.
new IntersectionObserver(seen => {
  const { intersectionRatio } = seen.at(-1);
  inSight = intersectionRatio >= (inSight ? 0.33 : 0.5);
  goOn();
}, { threshold: [0.33, 0.5] }).observe(canvas);
</script>
</html>
)html";

}  // namespace play
