// SPDX-License-Identifier: MIT-0
/// @file
/// The page that plays a film, without the film: plain HTML, a canvas and a slider.
#pragma once

namespace play {

inline constexpr char player_head[] = R"html(<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>Film</title>
<style>
:root { color-scheme: light dark; font: 15px/1.4 system-ui, sans-serif }
body { margin: 0 auto; max-width: 64rem }
canvas { display: block; width: 100% }
form { display: flex; align-items: center; gap: .8rem; padding: .4rem .6rem }
button { font: inherit; width: 5rem; min-height: 2.2rem; border: 1px solid; border-radius: 6px; background: none; color: inherit }
input { flex: 1; min-width: 0; min-height: 1.8rem; accent-color: currentColor }
output { min-width: 4rem; text-align: right; font-variant-numeric: tabular-nums }
</style>
<canvas role="img" aria-label="A film, as a series of drawings"></canvas>
<form><button type="button">Play</button><input type="range" aria-label="Time" step="any"><output></output></form>
<script>
)html";

inline constexpr char player_tail[] = R"html(
const colours = {
  light: {
    'Euler': '#ca3e00', 'symplectic Euler': '#0063b2', 'velocity Verlet': '#30613b', 'RK4': '#6e009c',
    'backward Euler': '#622a00', 'midpoint': '#168a9a', 'Störmer–Verlet': '#30613b', 'leapfrog': '#30613b',
    'Yoshida 4': '#748043', 'BDF2': '#6a7adf', 'trapezoid': '#a53065', 'true': '#3a3835',
    'scenery': '#938c81', 'paper': '#fffefb', 'ink': '#22211f',
  },
  dark: {
    'Euler': '#ff5a00', 'symplectic Euler': '#0089d9', 'velocity Verlet': '#00b68a', 'RK4': '#c392f5',
    'backward Euler': '#c5a872', 'midpoint': '#7adff0', 'Störmer–Verlet': '#00b68a', 'leapfrog': '#00b68a',
    'Yoshida 4': '#c3cc58', 'BDF2': '#7a8db3', 'trapezoid': '#f89fc6', 'true': '#e4e0d8',
    'scenery': '#77747a', 'paper': '#17171a', 'ink': '#dedad2',
  },
};
const [canvas, button, slider, clock] = ['canvas', 'button', 'input', 'output'].map(name => document.querySelector(name));
const pen = canvas.getContext('2d'), [left, bottom, right, top_] = view;
const still = matchMedia('(prefers-reduced-motion: reduce)'), dark = matchMedia('(prefers-color-scheme: dark)');
const begins = [], trails = [];
let length = 0, playing = false, before = 0;
pictures.forEach(([seconds, ...shapes], n) => {
  begins.push(length);
  length += seconds;
  shapes.filter(([kind]) => kind === 'trail').forEach(([, , x, y], k) => (trails[k] ??= []).push({ n, x, y }));
});
slider.max = length;
slider.value = still.matches ? length : 0;
const ended = () => slider.value > length - 0.001;  // the slider rounds
canvas.style.aspectRatio = (right - left) / (top_ - bottom);

// The book says by #light or #dark which of them its reader chose.
const scheme = () => location.hash.slice(1) || (dark.matches ? 'dark' : 'light');

function draw() {
  const shown = begins.findLastIndex(begin => begin <= slider.value), scale = canvas.width / (right - left);
  const { paper, ink } = colours[scheme()];
  Object.assign(document.documentElement.style, { colorScheme: scheme(), background: paper, color: ink });
  pen.setTransform(1, 0, 0, 1, 0, 0);
  pen.clearRect(0, 0, canvas.width, canvas.height);
  const place = (x, y) => [(x - left) * scale, (top_ - y) * scale];
  let trail = 0;
  for (const [kind, colour, x, y, ...more] of pictures[shown].slice(1)) {
    if (!colours.light[colour]) throw Error(`no method has the colour "${colour}"`);
    pen.fillStyle = pen.strokeStyle = kind === 'label' ? ink : colours[scheme()][colour];
    pen.lineWidth = 2 * devicePixelRatio;
    pen.lineCap = pen.lineJoin = 'round';
    pen.font = `${14 * devicePixelRatio}px system-ui, sans-serif`;
    pen.beginPath();
    if (kind === 'circle') pen.arc(...place(x, y), more[0] * scale, 0, 7), pen.fill();
    if (kind === 'line') pen.moveTo(...place(x, y)), pen.lineTo(...place(...more)), pen.stroke();
    if (kind === 'label') pen.fillText(more[0], ...place(x, y));
    if (kind === 'trail') {
      for (const point of trails[trail++]) if (point.n <= shown) pen.lineTo(...place(point.x, point.y));
      pen.stroke();
    }
  }
  clock.value = `${Number(slider.value).toFixed(1)} s`;
}

function frame(now) {
  if (!playing) return;
  slider.value = Number(slider.value) + Math.min(now - before, 100) / 1000;
  before = now;
  if (ended()) play(false);
  draw();
  requestAnimationFrame(frame);
}

function play(on) {
  if (on && ended()) slider.value = 0;
  button.textContent = on ? 'Stop' : 'Play';
  if (on && !playing) requestAnimationFrame(now => frame((before = now)));
  playing = on;
}

button.onclick = () => play(!playing);
slider.oninput = () => (play(false), draw());
dark.onchange = onhashchange = draw;
onresize = () => {
  canvas.width = canvas.clientWidth * devicePixelRatio;
  canvas.height = canvas.width * (top_ - bottom) / (right - left);
  draw();
};
if (!still.matches)
  new IntersectionObserver(([{ isIntersecting }], seen) => isIntersecting && (play(true), seen.disconnect()), { threshold: 0.6 }).observe(canvas);
onresize();
</script>
</html>
)html";

}  // namespace play
