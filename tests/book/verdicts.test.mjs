// One verdict for each thing of the level, wherever the book gives it: in the live chart, in the table of the level, on the
// answers of `choose`, in the table for the wall, and among the headers that the chapters' ends hand out.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { build } from './book.mjs';
import { openTab } from './browser.mjs';
import { figures, open } from './live.mjs';

const NAME = 'speed-against-accuracy';
const figure = figures.find(({ name }) => name === NAME);
const tab = await openTab();

// Rows of a table without quotes, as objects.
function rows(table) {
  const text = readFileSync(join(build, `chapters/7-which-to-use/data/${table}.csv`), 'utf8');
  const [names, ...lines] = text.trim().replace(/"[^"]*"/g, 'quoted').split('\n').map(line => line.split(',')); // prettier-ignore
  return lines.map(cells => Object.fromEntries(names.map((name, i) => [name, cells[i]])));
}

// The headers that the chart says to take, the exact step's first.
async function advice(thing) {
  const live = await open(tab, figure, `thing=${thing}&tolerance=0.01`);
  const said = live.stage.locator('.advice');
  return {
    takes: await said.locator('a[download]').evaluateAll(links => links.map(link => link.textContent)),
    question: await said.locator('code').textContent(),
    tried: Object.values((await live.now()).tried),
  };
}

function choose(question) {
  const [program, ...words] = question.split(' ');
  const path = join(build, program.replace('build/', ''));
  return JSON.parse(execFileSync(path, [...words, '--format', 'json'], { encoding: 'utf8' }));
}

// The headers that the boxes "To take home" name.
function takenHome() {
  const pages = readdirSync(join(build, 'book')).filter(file => /^\d-.*\.html$/.test(file));
  const boxes = pages.flatMap(
    page => readFileSync(join(build, 'book', page), 'utf8').match(/<div class="takehome"[^]*?<\/div>/g) ?? [],
  );
  assert.equal(boxes.length, pages.length);
  return boxes.flatMap(box => box.match(/\w+\.h\b/g) ?? []);
}

test("chart, table, choose, the table for the wall and the chapters' ends give one verdict for each thing", async () => {
  const wall = rows('wall').map(({ header }) => header);
  const handed = takenHome();
  const solved = rows('solved');
  assert.equal(solved.length, 6);
  for (const { thing, take, header } of solved) {
    const { takes, question, tried } = await advice(thing);
    const all = choose(question);
    const isExact = ({ header: of }) => ['spring_exact.h', 'constant_acceleration.h'].includes(of);
    const methods = all.filter(one => !isExact(one) && one.good && one.steps_per_frame);
    const inChart = methods.filter(one => one.function in figure.methods && tried.includes(one.steps_per_frame));
    const quickest = inChart.reduce((best, one) =>
      one.microseconds_per_frame_for_1000 < best.microseconds_per_frame_for_1000 ? one : best,
    );
    const exact = take === 'exact step';
    assert.ok(wall.includes(header), `${thing}: the wall has nothing about ${header}`);
    assert.ok(handed.includes(header), `${thing}: no chapter's end hands out ${header}`);
    assert.equal((exact ? all[0] : methods[0]).header, header, `${thing}: choose differs from the table`);
    assert.deepEqual(takes, exact ? [header, quickest.header] : [quickest.header], `${thing}: the chart`);
  }
});
