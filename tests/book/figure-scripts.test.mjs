// What the scripts of the figures may not do: count columns, and type what a program should write.
//   node tests/book/figure-scripts.test.mjs build SOURCE
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { columnsByNumber, numbersInLabels, readScript } from './gnuplot-script.mjs';

const source = process.argv[3] ?? '.';
const scripts = readdirSync(join(source, 'chapters'), { withFileTypes: true })
  .filter(entry => entry.isDirectory())
  .flatMap(({ name }) =>
    readdirSync(join(source, 'chapters', name))
      .filter(file => file.endsWith('.gp'))
      .map(file => `chapters/${name}/${file}`),
  );
const read = file => readFileSync(join(source, file), 'utf8');

for (const script of scripts) {
  test(`${script} names its columns`, () => assert.deepEqual(columnsByNumber(read(script)), []));
  test(`${script} types no number that a program should write`, () =>
    assert.deepEqual(numbersInLabels(read(script)), []));
}

test('a column by its number is found', () => {
  const faults = {
    'plot file("a") using 1:2 with lines': ['using 1', 'using 2'],
    'plot file("a") using col("t"):3 with lines': ['using 3'],
    'plot file("a") using col("t"):i with lines': ['using i'],
    'plot file("a") using (-$3):col("t")': ['$3'],
    'plot file("a") using col("t"): \\\n (column(4))': ['column(4)'],
    'plot file("a") using col("t"):(0):ytic(1)': ['using ytic(1)', 'ytic(1)'],
    'name(i) = strcol(i)': ['strcol(i)'],
    'plot for [i=1:2] file("a") every ::i using ($0 + column(0)):col("t"):(sprintf("$%.2f", val("t"))) ls i': [],
    '# using 1:2\nset label "using 1:2"': [],
  };
  for (const [script, found] of Object.entries(faults)) assert.deepEqual(columnsByNumber(script), found, script);
});

test('a number typed into a label is found', () => {
  const faults = [
    'set label 1 "21.2 ms" at 0,0',
    'set label 1 "ledge, 1 m"',
    "set label '60 Hz'",
    'tip = "20 steps a second: %.2f m"',
    'rates = "15 240"',
    'set label 2 "1.5"',
  ];
  for (const script of faults) assert.equal(numbersInLabels(script).length, 1, script);
  const good = [
    'set label 1 number("door-limit")',
    'set xtics ("1 mm" 0.001, "548" 547)',
    'set label 1 "RK4" font "Book Sans,12"',
    'x = val("Euler at 120 Hz")',
    'tip = "%.2f m"',
    'set label "slope −1"',
    'set arrow lc rgb "#000001"',
  ];
  for (const script of good) assert.deepEqual(numbersInLabels(script), [], script);
});

test('a string with a quote of the other kind in it is one string', () => {
  assert.deepEqual(
    readScript(`a = "it's"; b = 'x'`).strings.map(({ text }) => text),
    ["it's", 'x'],
  );
});
