// An exercise written and judged in the page, from disk: what the judges say, what the compiler says, code that never ends or fails, a
// main of one's own, and what is kept.  node write-exercise.test.mjs BUILD SOURCE
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { gunzipSync } from 'node:zlib';
import { accessibility } from './accessibility.mjs';
import { folder } from './book.mjs';
import { openTab, visit } from './browser.mjs';

const source = process.argv[3];
const NAME = '2-euler/orbit-drift';
const read = file => readFileSync(join(source, 'exercises', NAME, file), 'utf8');
const [solution, starter] = ['solution.h', 'starter.h'].map(read);
const stepOf = lines => solution.replace(/ {2}const Vec a = .*\n {2}x = .*\n {2}v = .*\n/, lines);

const tab = await openTab();
await visit(tab, '2-euler.html');
const section = tab.locator(`.exercise:has([data-exercise="${NAME}"])`);
const status = section.locator('.compiled');
const written = async () => (await section.locator('.cm-line').allTextContents()).join('\n').trim();
const write = async text => {
  await section.locator('.cm-content').click();
  await tab.keyboard.press('Control+A');
  await tab.keyboard.insertText(text);
};
const told = words =>
  tab.waitForFunction(
    ([name, expected]) =>
      new RegExp(expected).test(
        document.querySelector(`.exercise:has([data-exercise="${name}"]) .compiled`)?.textContent ?? '',
      ),
    [NAME, words],
    { timeout: 120_000 }, // other tests run beside it
  );
const press = async (name, words) => {
  await section.getByRole('button', { name, exact: true }).click();
  await told('Compiling|Judging');
  await told(words);
};
const judged = async (text, words) => {
  await write(text);
  await press('Judge', words);
  return section.locator('.report').textContent();
};

test('the starter is judged, and fails in the words of the grader', async () => {
  await section.getByRole('button', { name: 'Write it here: orbit-drift' }).click();
  await section.locator('.cm-line').first().waitFor();
  assert.equal(await written(), starter.trim());
  await press('Judge', '^WRONG_ANSWER, 0 of 10 points$');
  const said = await section.locator('.report').textContent();
  assert.match(said, /It ran to the end, and no test held\./);
  assert.match(said, /Ask once, at \(x, v, t\), before you change any of them\./);
  assert.match(said, /A mark comes from the program grade/);
  assert.deepEqual(tab.faults, []);
  assert.deepEqual(await accessibility(tab), []);
  tab.faults.length = 0;
});

test('a wrong way is recognised, and its plot is drawn', async () => {
  const said = await judged(
    stepOf('  v = v + h * acceleration(x, v, t);\n  x = x + h * v;\n'),
    '^PARTIAL, \\d of 10 points$',
  );
  assert.match(said, /this is symplectic Euler/);
  const curves = await section.locator('.finding .curve').evaluateAll(all => all.map(one => one.getAttribute('d')));
  assert.ok(curves.length >= 2 && curves.every(path => /^M[\d.]+ [\d.]+L/.test(path)), String(curves));
});

test('the solution has full marks, and the page of all exercises has its tick', async () => {
  await judged(solution, '^ACCEPTED, 10 of 10 points$');
  const other = await tab.context().newPage();
  await other.goto(tab.url().replace(/[^/]*$/, 'exercises.html'));
  const id = await section.getAttribute('id');
  const cell = other.locator(`.tick:has([name="${id}"])`);
  assert.equal(await cell.locator('input').isChecked(), true);
  assert.match(await cell.textContent(), /10 of 10/);
  await other.close();
  await tab.bringToFront();
});

for (const [what, text, words, more] of [
  ['a mistake of the language', stepOf('  x = x + h * w;\n'), "^Line 7: use of undeclared identifier 'w'", /^$/],
  ['a main in the open', `${solution}\nint main() { return 0; }\n`, 'put it between #ifndef GRADING and #endif', /^$/],
  [
    'a function without its body',
    `${solution.replace('inline int steps_per_turn', 'int other(int);\ninline int steps_per_turn').replace('return steps;', 'return other(steps);')}`,
    'other\\(int\\) is declared, but never defined',
    /^$/,
  ],
  [
    'an index past the end',
    stepOf('  std::vector<double> all(2);\n  x.x = all[static_cast<int>(h) + 2];\n'),
    '^RUNTIME_ERROR, 0 of',
    /an index past the end/,
  ],
  [
    'a call without end',
    `${solution.replace('inline void step', 'inline double deep(double d) {\n  return d > 0 ? 1 + deep(d + 1) : d;\n}\ninline void step').replace('  const Vec a', '  x.x = deep(1);\n  const Vec a')}`,
    '^RUNTIME_ERROR, 0 of',
    /called itself without end/,
  ],
  ['a throw', stepOf('  throw 1;\n'), '^RUNTIME_ERROR, 0 of', /threw an exception/],
  ['no number', stepOf('  x = x * NAN;\n'), '^(WRONG_ANSWER|PARTIAL)', /NaN|nan/],
  [
    'memory without end',
    stepOf('  static std::vector<std::vector<double>> all;\n  for (;;) all.emplace_back(1 << 20);\n'),
    '^(MEMORY_LIMIT|RUNTIME_ERROR)',
    /more memory/,
  ],
  [
    'a loop without end',
    stepOf('  for (volatile unsigned n = 0;; n = n + 1) {}\n'),
    '^TIME_LIMIT, 0 of',
    /did not come back within ten seconds/,
  ],
])
  test(`${what} is said, and hurts nobody`, async () => {
    assert.match(await judged(text, words), more);
    assert.deepEqual(tab.faults, []);
  });

test('a slash is a slash, and no search', async () => {
  await write('// one\n');
  await tab.keyboard.press('Control+End');
  await tab.keyboard.type('a / b');
  assert.equal(await written(), '// one\na / b');
});

test('a main of one’s own is made, run, and what it prints is shown', async () => {
  await write(solution);
  await press('Run', 'A main was added at the end');
  assert.match(await section.locator('.printed').textContent(), /This is printed by main/);
  const text = await written();
  await write(
    text
      .replace(/\n\n/g, '\n')
      .replace(
        'std::puts("This is printed by main, at the end of the file.")',
        'std::printf("%d\\n", steps_per_turn(1))',
      ),
  );
  await press('Run', '^It ran\\.$');
  assert.match(await section.locator('.printed').textContent(), /^\d+\n$/);
  await press('Judge', '^ACCEPTED'); // that main is between #ifndef GRADING and #endif
});

test('what was written is there again, is downloaded, and goes back to the starter', async () => {
  await visit(tab, '2-euler.html');
  assert.match(await section.locator('.write-here').textContent(), /10 of 10 points/);
  await section.getByRole('button', { name: 'Go on writing: orbit-drift' }).click();
  await section.locator('.cm-content').waitFor();
  assert.match(await written(), /steps_per_turn\(1\)/);
  const [file] = await Promise.all([
    tab.waitForEvent('download'),
    section.getByRole('button', { name: 'Download' }).click(),
  ]);
  assert.equal(file.suggestedFilename(), 'orbit-drift.h');
  assert.match(readFileSync(await file.path(), 'utf8'), /steps_per_turn\(1\)/);
  await section.getByRole('button', { name: 'Back to the starter' }).click();
  assert.equal(await written(), starter.trim());
});

test('the page holds no line of a solution', () => {
  const exercises = readFileSync(join(folder, 'compiler/exercises.js'), 'utf8');
  const packed = readFileSync(join(folder, 'compiler/judging.js'), 'utf8').match(/"judges":"([^"]*)"/)[1];
  const judges = gunzipSync(Buffer.from(packed, 'base64')).toString('latin1');
  const { tasks } = JSON.parse(exercises.match(/\{ exercises: (.*) \}\);$/m)[1]);
  assert.equal(Object.keys(tasks).length, 31);
  for (const [name, task] of Object.entries(tasks)) {
    const [own, begun, harness] = ['solution.h', 'starter.h', 'harness.h'].map(file =>
      readFileSync(join(source, 'exercises', name, file), 'utf8'),
    );
    assert.deepEqual(task, { starter: begun, harness });
    const lines = own.split('\n').map(line => line.trim());
    for (const line of lines.filter(one => one.length > 24)) assert.ok(!judges.includes(line), `${name}: ${line}`);
  }
});
