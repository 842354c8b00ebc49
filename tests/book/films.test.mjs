// The films: node films.test.mjs BUILD SOURCE. Each plays, stops, and can be moved by hand; says the game's time; and has names
// beside its things and a still for paper. And their colours are the book's.
import assert from 'node:assert/strict';
import { readdirSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { load } from 'cheerio';
import { accessibility } from './accessibility.mjs';
import { chapters, folder, read } from './book.mjs';
import { addressOf, frames, openTab, visit } from './browser.mjs';
import { readPalette } from './palette.mjs';

const [, , build, source] = process.argv;
const films = readdirSync(join(folder, 'films'));
const tab = await openTab('light', { reducedMotion: 'no-preference' });
const time = tab => tab.locator('input').inputValue().then(Number);
const come = page => (tab.url() === addressOf(page) ? null : tab.goto(addressOf(page)));
const picture = tab => tab.locator('canvas').evaluate(canvas => canvas.toDataURL());
const button = tab => tab.locator('button').textContent();
const put = (tab, part) =>
  tab.locator('input').evaluate((slider, share) => {
    slider.value = slider.max * share;
    slider.oninput();
  }, part);

// How many seconds of the game a film shows, how fast, and the names in it.
const SHOWN = {
  '1-test-case-play': [1.1, '4 times slower', '20 Hz, 30 Hz, 60 Hz, 144 Hz'],
  '1-test-case-play_first': [1.1, '4 times slower', '20 Hz, 30 Hz, 60 Hz, 144 Hz'],
  '2-euler-play': [80, '8 times as fast', ''],
  '2-euler-play_camera': [8, '', 'lerp at 60 Hz, lerp at 20 Hz, exact at 60 Hz, exact at 20 Hz'],
  '3-runge-kutta-play': [16, 'twice as fast', 'Euler, midpoint, RK4'],
  '3-runge-kutta-play_index': [24, '6 times as fast', 'RK4, one wrong index'],
  '4-implicit-play': [0.517, '7 times slower', 'Euler, symplectic Euler, RK4, backward Euler, true'],
  '4-implicit-play_rope': [2, 'half as fast', 'symplectic Euler, predicted Euler, backward Euler'],
  '5-verlet-play': [7, '', ''],
  '6-symplectic-play': [30, '3 times as fast', 'Euler, symplectic Euler'],
  '6-symplectic-play_crate': [5, '', 'naive, Bullet, rotations'],
  '7-which-to-use-play': [8, '', 'exact, RK4, exact, Störmer–Verlet, velocity Verlet, rotations'],
};

const namesIn = film => SHOWN[film.slice(0, -5)][2].split(', ');

const paceOf = words => {
  const times = { twice: 2, half: 0.5 }[words.split(' ')[0]] ?? Number(words.split(' ')[0] || 1);
  return words.endsWith('slower') ? 1 / times : times;
};

test('there is a film for each chapter', () =>
  assert.deepEqual(
    films,
    Object.keys(SHOWN).map(name => `${name}.html`),
  ));

for (const film of films) {
  const [seconds, pace] = SHOWN[film.slice(0, -5)];

  test(`${film} plays, stops, goes where the slider is put, and plays again`, async () => {
    await visit(tab, `films/${film}`);
    const end = Number(await tab.locator('input').getAttribute('max'));
    assert.ok((await time(tab)) < 0.4 * end, 'it starts in the middle');
    await put(tab, 0); // which stops it
    const start = await picture(tab);
    assert.equal(await button(tab), 'Play');
    await tab.locator('button').click();
    const rate = await tab.evaluate(rateOfPlay);
    assert.ok(Math.abs(rate / paceOf(pace) - 1) < 0.1, `it plays ${rate} seconds in one`);
    assert.ok((await picture(tab)) !== start, 'nothing moves');
    await tab.locator('button').click();
    const at = await time(tab);
    await frames(tab, 6);
    assert.equal(await time(tab), at, 'it goes on after Stop');
    await put(tab, 0);
    assert.ok((await picture(tab)) === start, 'the slider at its start shows another picture');
    await put(tab, 0.98);
    await tab.locator('button').click();
    await tab.waitForFunction(() => document.querySelector('button').textContent === 'Again');
    await tab.locator('button').click();
    assert.ok((await time(tab)) < end / 2, 'it does not start over');
    assert.equal(await button(tab), 'Stop');
    assert.deepEqual(tab.faults, []);
  });

  test(`${film} tells the time of the game, and how fast it plays`, async () => {
    await put(tab, 1);
    const told = await tab.locator('output').textContent();
    assert.match(told, /^\d+\.\d+ s$/);
    assert.ok(Math.abs(parseFloat(told) / seconds - 1) < 0.01, `${told}, and not ${seconds} s`);
    assert.equal(await tab.locator('input').getAttribute('aria-valuetext'), told.replace(/s$/, 'seconds of play'));
    assert.equal(await tab.locator('small').textContent(), pace);
  });

  test(`${film} has names beside its things, which lie on nothing, on a phone too`, async () => {
    assert.deepEqual(await tab.evaluate(lettersThere), ['Book Sans']);
    for (const width of [352, 720]) {
      await tab.setViewportSize({ width, height: 900 });
      await frames(tab, 2);
      for (let part = 0; part <= 1; part += 0.125) {
        const { words, faults } = await tab.evaluate(write, part);
        assert.deepEqual(faults, [], `${width} px wide, at ${part} of the film`);
        for (const name of namesIn(film)) assert.ok(words.includes(name), `no "${name}" in "${words}"`);
      }
    }
    await tab.setViewportSize({ width: 1280, height: 900 });
  });
}

// Within the page: the fonts that it has loaded.
const lettersThere = () =>
  document.fonts.ready.then(fonts =>
    [...fonts].filter(({ status }) => status === 'loaded').map(({ family }) => family.replaceAll('"', '')),
  );

// Within the page: how many seconds of the film go by in one.
async function rateOfPlay() {
  const tick = () => new Promise(requestAnimationFrame);
  const slider = document.querySelector('input');
  await tick();
  let before = await tick();
  const from = slider.value;
  let passed = 0;
  for (let n = 0; n < 12; ++n) {
    const now = await tick();
    passed += Math.min(now - before, 100) / 1000;
    before = now;
  }
  return (slider.value - from) / passed;
}

// Within the page: what a picture says, and whatever of it is not within the picture, or not on empty paper. The page's script
// calls its pen `pen`, and draws with `draw`.
function write(part) {
  const words = [];
  const faults = [];
  pen.fillText = (text, x, y) => {
    const box = pen.measureText(text);
    const [left, top] = [x - box.actualBoundingBoxLeft, y - box.actualBoundingBoxAscent];
    const [width, height] = [box.actualBoundingBoxLeft + box.actualBoundingBoxRight, 11 * devicePixelRatio];
    if (left < 0 || top < 0 || left + width > canvas.width || top + height > canvas.height)
      faults.push(`"${text}" is cut off`);
    if (pen.getImageData(left, top, width, height).data.some(Boolean)) faults.push(`"${text}" lies on something`);
    words.push(text);
    CanvasRenderingContext2D.prototype.fillText.call(pen, text, x, y);
  };
  slider.value = slider.max * part;
  draw();
  delete pen.fillText;
  return { words: words.join(' '), faults };
}

// What a chapter has of a film.
const embedded = chapters.flatMap(page =>
  read(page)
    .match(/<div class="film"[^]*?<\/svg><\/div>/g)
    .map(html => {
      const $ = load(html);
      const { src, title } = $('iframe').attr();
      return { film: src.slice('films/'.length), title, still: $('svg.still') };
    }),
);

test('a film by itself has the title of its figure, and nothing that axe finds', async () => {
  await come(`films/${films.at(-1)}`);
  await put(tab, 0);
  const { title } = embedded.find(({ film }) => film === films.at(-1));
  assert.equal(await tab.title(), title);
  assert.equal(await tab.locator('h1').textContent(), title);
  assert.ok(await tab.locator('h1').isVisible());
  assert.deepEqual(await accessibility(tab), []);
});

test('a film waits while it is out of sight, goes on in sight, and not if it was stopped', async () => {
  tab.faults.length = 0;
  await come('3-runge-kutta.html'); // where it is not in the first screen
  const film = await tab.locator('.film iframe').first().elementHandle();
  const inside = await film.contentFrame();
  // A fifth of it stays in sight: a browser may stop what is wholly out of it by itself.
  const away = () =>
    film.evaluate(frame => {
      const { top, height } = frame.getBoundingClientRect();
      scrollBy(0, top + height / 5 - innerHeight);
    });
  const at = () => inside.locator('input').inputValue().then(Number);
  // The browser tells a film that it has gone out of sight some frames later.
  const stands = async () => {
    for (let before = await at(), tries = 0; tries < 20; ++tries) {
      await tab.waitForTimeout(200);
      const now = await at();
      if (now === before) return now;
      before = now;
    }
    return assert.fail('it goes on');
  };
  const goesOn = before => inside.waitForFunction(from => document.querySelector('input').value > from + 0.1, before);
  await away();
  assert.equal(await stands(), 0, 'it has begun before it was seen');
  await film.scrollIntoViewIfNeeded();
  await goesOn(0);
  await away();
  const left = await stands();
  assert.equal(await button(inside), 'Stop');
  await film.scrollIntoViewIfNeeded();
  await goesOn(left);
  await inside.locator('button').click();
  await away();
  const stopped = await stands();
  await film.scrollIntoViewIfNeeded();
  assert.equal(await stands(), stopped);
  assert.deepEqual(tab.faults, []);
});

const withoutSpaces = words => words.replace(/ /g, '');

test('each film has a still, of its last picture', () => {
  assert.deepEqual(embedded.map(({ film }) => film).sort(), films);
  for (const { film, title, still } of embedded) {
    const words = withoutSpaces(still.text());
    for (const name of namesIn(film)) assert.ok(words.includes(withoutSpaces(name)), `${film}: no "${name}"`);
    assert.ok(still.find('path').length > 1, film);
    assert.equal(still.attr('aria-label'), title);
    assert.ok(String(still).length < 8000, `${film}: ${String(still).length} bytes`);
  }
});

test('on paper, and where no scripts run, the still stands for the film', async () => {
  const plain = await openTab('dark', { javaScriptEnabled: false });
  const seen = reader => reader.locator('.film > :visible').evaluateAll(parts => parts.map(({ tagName }) => tagName));
  await come('5-verlet.html');
  const inFront = await tab
    .locator('.film iframe')
    .first()
    .evaluate(film => {
      film.scrollIntoView({ block: 'center' });
      const { left, top, width, height } = film.getBoundingClientRect();
      return document.elementFromPoint(left + width / 2, top + height / 2) === film;
    });
  assert.ok(inFront, 'the still lies before the film');
  await tab.emulateMedia({ media: 'print' });
  assert.deepEqual(await seen(tab), ['svg']);
  await tab.emulateMedia({ media: null });
  await plain.goto(addressOf('5-verlet.html'));
  assert.deepEqual(await seen(plain), ['svg']);
  await plain.context().close();
});

test('who wants no motion sees the last picture, and may play it', async () => {
  const still = await openTab('dark');
  await visit(still, `films/${films[0]}`);
  const at = await time(still);
  assert.ok(at > 0.999 * Number(await still.locator('input').getAttribute('max')));
  await still.waitForTimeout(300);
  assert.equal(await time(still), at);
  assert.equal(await button(still), 'Play');
  await still.locator('button').click();
  await still.waitForFunction(end => document.querySelector('input').value < end, at);
  assert.deepEqual(still.faults, []);
  await still.context().close();
});

test('the played part of the slider is the strong one', async () => {
  for (const colorScheme of ['light', 'dark']) {
    await tab.emulateMedia({ colorScheme });
    await visit(tab, `films/${films[0]}`);
    await put(tab, 0.5);
    const { x, y, width, height } = await tab.locator('input').boundingBox();
    const brightness = async (across, down) => {
      const clip = { x: x + across * width, y: y + down * height, width: 1, height: 1 };
      return tab.evaluate(grey, (await tab.screenshot({ clip })).toString('base64'));
    };
    const paper = await brightness(0.5, -0.05);
    const [played, rest] = await Promise.all([0.25, 0.75].map(across => brightness(across, 0.5)));
    assert.ok(Math.abs(played - paper) > 2 * Math.abs(rest - paper), `${colorScheme}: ${played}, ${rest} on ${paper}`);
    assert.ok(Math.abs(rest - paper) > 20, `${colorScheme}: the rest is not to be seen`);
  }
});

// Within the page: how bright the first pixel of a PNG is.
async function grey(png) {
  const image = new Image();
  image.src = `data:image/png;base64,${png}`;
  await image.decode();
  const pen = new OffscreenCanvas(1, 1).getContext('2d');
  pen.drawImage(image, 0, 0);
  return pen.getImageData(0, 0, 1, 1).data[1];
}
test('a film has the colours that the book has', async () => {
  const { methods, others, value } = readPalette(source, build);
  const names = Object.fromEntries([
    ...[
      ...methods,
      { ...others.EXACT, name: 'true' },
      { ...others.SECOND, name: 'yours' },
      { ...others.CONTEXT, name: 'scenery' },
    ].map(style => [style.name, `plot-${style.colour}`]),
    ['paper', 'paper'],
    ['ink', 'ink'],
  ]);
  const tab = await openTab();
  await visit(tab, `films/${films[0]}`);
  const colours = await tab.evaluate('colours');
  for (const [scheme, table] of Object.entries(colours))
    for (const [name, shade] of Object.entries(table))
      assert.equal(shade, value(scheme, names[name]), `${scheme}: ${name}`);
  await tab.context().close();
});
