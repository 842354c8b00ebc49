// The program of a film, changed and run in the page, from disk: its prints and its film, messages in the right tab, programs that never
// end or fail; and back.  node edit-film.test.mjs BUILD
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { accessibility } from './accessibility.mjs';
import { folder, parse } from './book.mjs';
import { openTab, visit } from './browser.mjs';

const PAGE = '2-euler.html';
const tab = await openTab('light', { reducedMotion: 'no-preference' });
await visit(tab, PAGE);
await tab.evaluate(() => {
  for (const fold of document.querySelectorAll('details')) fold.open = true;
});
const figure = tab.locator('figure:has(iframe[data-source="chapters/2-euler/play.cpp"])');
const status = async words =>
  tab.waitForFunction(
    expected => new RegExp(expected).test(document.querySelector('.program .compiled')?.textContent),
    words,
    { timeout: 300_000 }, // other tests run beside it
  );
const write = async text => {
  await figure.locator('.cm-content:visible').click();
  await tab.keyboard.press('Control+A');
  await tab.keyboard.insertText(text);
};
const run = async words => {
  await figure.getByRole('button', { name: 'Run' }).click();
  await tab.waitForFunction(() => /Compiling/.test(document.querySelector('.program .compiled').textContent));
  await status(words);
};
const source = () => tab.evaluate(() => globalThis.Compiled.sources['chapters/2-euler/play.cpp']);
const quoted = parse(PAGE)('[data-printed-by="play"] code').text();

test('the program opens with its headers, and prints what the chapter quotes', async () => {
  await figure.locator('.sources .edit').click();
  await status('Compiled and run');
  assert.equal((await figure.locator('.printed').textContent()).trim(), quoted.trim());
  assert.deepEqual(await figure.locator('.tabs button').allTextContents(), [
    'play.cpp',
    'drone.h',
    'play.h',
    'euler.h',
  ]);
  const film = readFileSync(join(folder, 'films/2-euler-play.html'), 'utf8').match(/const view = [^]*?\]\];/)[0];
  const shown = await (await (await figure.locator('iframe').elementHandle()).contentFrame()).content();
  assert.ok(shown.includes(film), 'its film is not the book’s');
  assert.deepEqual(tab.faults, []);
  assert.deepEqual(await accessibility(tab), []);
  tab.faults.length = 0;
});

test('with two lines swapped it prints what "Change it" says, and the book’s film is its ghost', async () => {
  const text = (await source())
    .replace('drone.step(h);', 'integrate::symplectic_euler(drone.x, drone.v, 0.0, h, Drone::pull);')
    .replace('#include "../play/drone.h"', '#include "../play/drone.h"\n#include "integrate/symplectic_euler.h"');
  await write(text);
  await run('Compiled and run');
  const expected = parse(PAGE)('#change-two-lines-swapped .codebox:not(.diff) code').text();
  assert.equal((await figure.locator('.printed').textContent()).trim(), expected.trim());
  const frame = await (await figure.locator('iframe').elementHandle()).contentFrame();
  assert.ok(await frame.evaluate('behind.pictures.length > 1'));
});

test('a mistake in a header stands in its tab, under its line', async () => {
  await figure.getByRole('button', { name: 'drone.h', exact: true }).click();
  await write(
    (await tab.evaluate(() => globalThis.Compiled.sources['chapters/play/drone.h'])).replace(
      'struct Drone {',
      'struct Drone { nothing x;',
    ),
  );
  await run('Your last version goes on');
  await figure.locator('.said', { hasText: 'unknown type name' }).waitFor();
  assert.match(await figure.locator('.tabs .wrong').textContent(), /drone\.h/);
});

for (const [what, code, words] of [
  [
    'a program that never ends',
    'int main() {\n  for (volatile int n = 0;; n = n + 1) {}\n}\n',
    'stopped after two seconds',
  ],
  ['a program that fails', 'int main() {\n  return 3;\n}\n', 'It ended with 3'],
  [
    'a program that throws',
    '#include <vector>\nint main() {\n  return std::vector<int>{1}.at(1);\n}\n',
    'It was stopped',
  ],
  [
    'a program that prints for ever',
    '#include <iostream>\nint main() {\n  for (;;) std::cout << "all work and no play\\n";\n}\n',
    'stopped',
  ],
  [
    'a program that takes all memory',
    '#include <vector>\nint main() {\n  std::vector<double> x;\n  for (;;) x.resize(x.size() * 2 + 1000);\n}\n',
    'stopped',
  ],
])
  test(`${what} hurts nobody`, async () => {
    await figure.getByRole('button', { name: 'play.cpp', exact: true }).click();
    await write(code);
    await figure.getByRole('button', { name: 'drone.h', exact: true }).click();
    await write(await tab.evaluate(() => globalThis.Compiled.sources['chapters/play/drone.h']));
    await run(words);
  });

test('a link brings the program, and it runs once Edit is pressed', async () => {
  await figure.getByRole('button', { name: 'play.cpp', exact: true }).click();
  await write('#include "../play.h"\nint main() {\n  std::cout << "from afar\\n";\n}\n');
  await figure.getByRole('button', { name: 'Link to this program' }).click();
  await status('Link copied|in the address bar');
  const address = await tab.evaluate(() => location.href);
  assert.ok(address.length < 400, `${address.length} letters`);
  for (const [there, printed] of [
    [address, 'from afar'],
    [address.slice(0, -9), quoted.trim()], // cut short on its way
  ]) {
    const other = await openTab();
    await other.goto(there);
    const film = other.locator('figure:has(iframe[data-source="chapters/2-euler/play.cpp"])');
    await film.locator('.sources', { hasText: 'This link brings a program of its own' }).waitFor();
    await film.locator('.sources .edit').click();
    await other.waitForFunction(
      expected => document.querySelector('.printed')?.textContent.trim() === expected,
      printed,
      { timeout: 120_000 },
    );
    assert.deepEqual(other.faults, []);
    await other.close();
  }
});

test('what draws the film may be changed, too', async () => {
  await figure.getByRole('button', { name: 'play.cpp', exact: true }).click();
  await write('#include "../play.h"\nint main() {\n  std::cout << play::length({3, 4}) << "\\n";\n}\n');
  await run('It wrote no film');
  assert.equal((await figure.locator('.printed').textContent()).trim(), '5');
  await figure.getByRole('button', { name: 'play.h', exact: true }).click();
  const drawing = await tab.evaluate(() => globalThis.Compiled.sources['chapters/play.h']);
  await write(drawing.replace('return std::sqrt(', 'return 2 * std::sqrt('));
  await run('It wrote no film');
  assert.equal((await figure.locator('.printed').textContent()).trim(), '10');
});

test('one press is back at the book’s', async () => {
  await figure.getByRole('button', { name: 'Back to the book’s' }).click();
  assert.match(await figure.locator('iframe').getAttribute('src'), /^films\/2-euler-play\.html/);
  await figure.getByRole('button', { name: 'Run' }).click();
  await status('Compiled and run');
  assert.equal((await figure.locator('.printed').textContent()).trim(), quoted.trim());
  assert.deepEqual(tab.faults, []);
});
