// A student's code moves:   node play.test.mjs SOURCE GRADE BUILD EXERCISES...
// Each exercise's scene is played by its solution, its starter, a wrong way whose mistake is to be seen, and by code that crashes
// or answers NaN. Whatever a scene draws of the student's it draws of the solution's, too, in the same order.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, realpathSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, join } from 'node:path';
import { after, test } from 'node:test';
import { runInNewContext } from 'node:vm';
import { spoilt } from './spoilt.mjs';

const [source, grade, build, ...exercises] = process.argv.slice(2);
const folder = realpathSync(mkdtempSync(join(tmpdir(), 'play-')));
after(() => rmSync(folder, { recursive: true }));

// The wrong way of each that is played.
const wrong = {
  'leftover-time': 'no-slow-motion',
  'throw-to-runner': 'standing-runner',
  'too-long-a-frame': 'debt-kept',
  'two-errors': 'always-order-one',
  'camera-that-lags': 'no-limit',
  'orbit-drift': 'symplectic',
  'steps-you-can-afford': 'error-of-the-coarse',
  'stiffest-leash': 'no-mass',
  'any-table': 'stale-velocity',
  'edge-of-stability': 'a-term-short',
  'midpoint-line': 'half-and-half',
  'racing-car': 'as-it-was',
  'step-by-price': 'middle',
  'blend-of-slopes': 'always-wet',
  'chain-of-beads': 'no-way-back',
  'dragged-crate': 'each-axis',
  'leaf-in-the-wind': 'asks-at-the-start',
  'slow-suspension': 'told-itself',
  'braked-verlet': 'no-drag',
  'pulls-for-a-curtain': 'swapped-prices',
  'rope-link': 'a-rope',
  'two-places': 'bounce-no-restitution',
  'uneven-jumps': 'half-a-cure',
  'five-for-four': 'yoshida',
  'rewind-the-replay': 'step-with-minus-h',
  'sledge-that-grips': 'glides-freely',
  'stars-that-wander': 'position-first',
  'clock-in-a-float': 'whole-milliseconds',
  'dot-on-the-map': 'determinant-only',
  'needle-that-settles': 'held-at-start',
  'shuttle-on-a-budget': 'equal-rk4',
};
// Those whose code is asked anew for each picture: if it crashes, the film stops there.
const asTheyGo = ['chain-of-beads', 'dragged-crate', 'rope-link', 'sledge-that-grips', 'two-places'];

const unescaped = text =>
  text.replace(
    /&(amp|lt|gt|quot|#39);/g,
    (_, name) => ({ 'amp': '&', 'lt': '<', 'gt': '>', 'quot': '"', '#39': "'" })[name],
  );

// The films of a page; the scene's is the first.
function filmsOf(page) {
  return [...page.matchAll(/<iframe [^>]*srcdoc="([^"]*)"/g)].map(([, inner]) => {
    const [script] = unescaped(inner).match(/const view = .*?(?=\nconst colours)/s);
    return { script, ...runInNewContext(`${script}; ({ view, names, pictures })`) };
  });
}

function play(exercise, text) {
  const name = basename(exercise),
    header = join(folder, `${name}.h`),
    file = join(folder, `${name}.html`);
  writeFileSync(header, text);
  rmSync(file, { force: true });
  const { status, stdout, stderr } = spawnSync(grade, ['play', header], { cwd: folder, encoding: 'utf8' });
  assert.ok(existsSync(file), `no page: ${stdout}${stderr}`);
  const page = readFileSync(file, 'utf8');
  return { status, said: stdout + stderr, page, films: filmsOf(page) };
}

// Pairs of numbers that say where a thing of the student's is, and where the solution's; those of a picture in a row.
function pairsOf({ names, pictures }) {
  return pictures.map(([, ...shapes]) => {
    const placed = colour =>
      Object.fromEntries(
        ['circle', 'line', 'trail'].map(kind => [
          kind,
          shapes
            .filter(shape => shape[0] === kind && names[shape[1]] === colour)
            .map(shape => shape.slice(2, kind === 'line' ? 6 : 4)),
        ]),
      );
    const yours = placed('yours'),
      right = placed('true');
    const counts = Object.keys(yours).map(kind => [yours[kind].length, right[kind].length]);
    const zip = kind =>
      yours[kind]
        .flat()
        .slice(0, right[kind].flat().length)
        .map((place, n) => [place, right[kind].flat()[n]]);
    return { counts, pairs: Object.keys(yours).flatMap(zip) };
  });
}

function bounded({ page, films }) {
  assert.ok(page.length < 700e3, `a page of ${page.length} bytes`);
  assert.ok(films[0].pictures.length <= 640, `${films[0].pictures.length} pictures`);
}

// How far things are from where they should be, at most, as a share of the picture.
function furthest(film) {
  const [left, bottom, right, top] = film.view;
  const size = Math.hypot(right - left, top - bottom);
  return Math.max(...pairsOf(film).flatMap(({ pairs }) => pairs.map(([a, b]) => Math.abs(a - b) / size)));
}

for (const exercise of exercises) {
  const name = basename(exercise);
  const home = join(source, 'exercises', exercise);
  const solution = readFileSync(join(home, 'solution.h'), 'utf8');

  test(`${exercise}: the solution moves as it should, to the digits of a picture`, () => {
    const played = play(exercise, solution);
    assert.equal(played.status, 0, played.said);
    assert.match(played.page, /<p>ACCEPTED, (\d+) of \1 points<\/p>/);
    assert.equal(played.films.length, 1);
    bounded(played);
    const pictures = pairsOf(played.films[0]);
    assert.ok(pictures.length > 20);
    assert.ok(pictures.at(-1).pairs.length > 0);
    for (const [n, { counts, pairs }] of pictures.entries()) {
      for (const [yours, right] of counts) assert.equal(yours, right, `in picture ${n}`);
      for (const [yours, right] of pairs)
        assert.ok(Math.abs(yours - right) <= 1e-6 + 1.1e-3 * Math.abs(right), `picture ${n}: ${yours} and ${right}`);
    }
  });

  test(`${exercise}: the starter is played, and is wrong`, () => {
    const played = play(exercise, readFileSync(join(home, 'starter.h'), 'utf8'));
    assert.equal(played.status, 0, played.said);
    assert.match(played.page, /<p>(WRONG_ANSWER|PARTIAL), \d+ of \d+ points<\/p>/);
    assert.match(played.page, /This did not hold/);
    bounded(played);
    assert.ok(furthest(played.films[0]) > 0.01);
  });

  test(`${exercise}: the mistake "${wrong[name]}" is seen`, () => {
    const file = [home, join(build, 'exercises', exercise)]
      .map(place => join(place, 'wrong', `${wrong[name]}.h`))
      .find(existsSync);
    const played = play(exercise, readFileSync(file, 'utf8'));
    assert.equal(played.status, 0, played.said);
    assert.doesNotMatch(played.page, /ACCEPTED/);
    bounded(played);
    assert.ok(furthest(played.films[0]) > 0.01, `${furthest(played.films[0])} of the picture`);
  });

  // The function that harness.h names first, or the clock's.
  const harness = readFileSync(join(home, 'harness.h'), 'utf8');
  const [, first] = harness.match(/wanted\w*[()]*\s*=\s*(?:&\w+::)?(\w+);/);
  const crashing = calls => {
    const body = new RegExp(`\\b${first}\\([^;{]*\\)[^;{]*\\{`);
    assert.match(solution, body);
    return solution.replace(body, `$& static int calls_ = 0; if (++calls_ > ${calls}) __builtin_abort();`);
  };

  test(`${exercise}: a crash leaves a page that says so`, () => {
    const played = play(exercise, crashing(0));
    assert.equal(played.status, 1, played.said);
    assert.match(played.page, /<p>It came no further: .+<\/p>/);
    assert.match(played.page, /<p>RUNTIME_ERROR, /);
  });

  if (asTheyGo.includes(name))
    test(`${exercise}: a crash on the way leaves the film up to there`, () => {
      const played = play(exercise, crashing(100));
      assert.equal(played.status, 1, played.said);
      assert.match(played.page, /<p>It came no further: .+<\/p>/);
      const { pictures } = played.films[0],
        whole = play(exercise, solution).films[0].pictures;
      assert.ok(
        pictures.length > 1 && pictures.length < whole.length,
        `${pictures.length} of ${whole.length} pictures`,
      );
    });

  for (const { what, text } of spoilt(exercise, source))
    test(`${exercise}: NaN is not drawn, ${what}`, () => {
      const played = play(exercise, text);
      assert.equal(played.status, 0, played.said);
      bounded(played);
      for (const { script } of played.films) assert.doesNotMatch(script, /\b(nan|inf|infinity)\b/i);
    });
}
