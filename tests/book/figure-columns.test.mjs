// A figure is the same wherever its columns stand, and is not drawn where it asks for what isn't there.
//   node tests/book/figure-columns.test.mjs build SOURCE [others]
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { after, test } from 'node:test';
import { readScript } from './gnuplot-script.mjs';

const chapters = resolve(process.argv[2] ?? 'build', 'chapters');
const source = resolve(process.argv[3] ?? '.');
const scratch = mkdtempSync(join(tmpdir(), 'figures-'));
after(() => rmSync(scratch, { recursive: true }));

// As chapters/CMakeLists.txt draws it.
function draw(script, data, out, { name, size: [width, height, narrow] }) {
  const set = {
    GNUPLOT: 'gnuplot',
    NAME: name,
    DATA: data,
    METHODS: join(chapters, 'methods.gp'),
    OUT: out,
    WIDTH: width,
    HEIGHT: height,
    NARROW: narrow,
    SCRIPT: script,
    STYLE: join(source, 'book/theme/figure.gp'),
    AXES: join(source, 'book/theme/axes.gp'),
  };
  const { status, stderr } = spawnSync(
    'cmake',
    [...Object.entries(set).map(([key, value]) => `-D${key}=${value}`), '-P', join(source, 'chapters/draw.cmake')],
    { encoding: 'utf8' },
  );
  return { drawn: status === 0, said: stderr };
}
const SIZES = { '': [720, 430, 0], '-narrow': [400, 340, 1] };

const fields = line => [...line.matchAll(/(?:^|,)("(?:[^"]|"")*"|[^,]*)/g)].map(([, field]) => field);
// Each column one further to the right, the last first: none stays where it was.
const turned = text =>
  text.replace(/^.+$/gm, line => [...fields(line).slice(-1), ...fields(line).slice(0, -1)].join(','));

function turnTables(from, to) {
  mkdirSync(to, { recursive: true });
  for (const file of readdirSync(from)) {
    const text = readFileSync(join(from, file), 'utf8');
    writeFileSync(join(to, file), /^(numbers|tables)\./.test(file) ? text : turned(text));
  }
}

// Of each chapter the figure that names the most columns; the tier `thorough` has the others, in one size.
const others = process.argv.includes('others');
const sizes = Object.entries(SIZES).slice(0, others ? 1 : undefined);
function askedOf(chapter) {
  const folder = join(source, 'chapters', chapter);
  const scripts = readdirSync(folder).filter(file => file.endsWith('.gp'));
  const columns = script => readFileSync(join(folder, script), 'utf8').match(/\b(?:col|val|txt)\(/g)?.length ?? 0;
  const richest = scripts.reduce((most, script) => (columns(script) > columns(most) ? script : most));
  return scripts.filter(script => (script === richest) !== others);
}

test('turned columns keep their names, and commas in quotes', () => {
  assert.equal(turned('t,"rope, gentle",x\n0,1,2\n'), 'x,t,"rope, gentle"\n2,0,1\n');
});

for (const chapter of readdirSync(chapters).filter(name => existsSync(join(chapters, name, 'figures')))) {
  const data = join(scratch, chapter, 'data'),
    out = join(scratch, chapter);
  test(`chapter ${chapter}: its figures are the same with their columns elsewhere`, () => {
    turnTables(join(chapters, chapter, 'data'), data);
    for (const script of askedOf(chapter))
      for (const [suffix, size] of sizes) {
        const name = script.slice(0, -3) + suffix;
        const { drawn, said } = draw(join(source, 'chapters', chapter, script), data, out, { name, size });
        assert.ok(drawn, said);
        const [was, is] = [join(chapters, chapter, 'figures'), out].map(folder =>
          readFileSync(join(folder, `${name}.svg`), 'utf8'),
        );
        assert.ok(
          was === is,
          `${script} reaches a column by its place: ${name}.svg is another one when the columns of its tables trade places`,
        );
      }
  });
}

// gnuplot looks a name up when it comes to it, and may not come to each today. And txt() ends at a comma, quoted or not.
for (const chapter of readdirSync(chapters).filter(name => existsSync(join(chapters, name, 'figures')))) {
  const cells = new Map();
  const folder = join(chapters, chapter, 'data');
  for (const file of readdirSync(folder).filter(name => /^(?!numbers|tables).*\.csv$/.test(name))) {
    const [header, ...rows] = readFileSync(join(folder, file), 'utf8').split('\n').map(fields);
    header.forEach((name, i) =>
      cells.set(name.replace(/^"|"$/g, ''), [...(cells.get(name) ?? []), ...rows.map(row => row[i] ?? '')]),
    );
  }
  test(`chapter ${chapter}: each column that a script names is there, and one that it reads as text has no commas`, () => {
    for (const script of readdirSync(join(source, 'chapters', chapter)).filter(file => file.endsWith('.gp'))) {
      for (const { text, call, alone, line } of readScript(
        readFileSync(join(source, 'chapters', chapter, script), 'utf8'),
      ).strings) {
        if (!['col', 'val', 'txt'].includes(call) || !alone) continue;
        assert.ok(cells.has(text), `${script}:${line}: no table of the chapter has a column "${text}"`);
        const cut = call === 'txt' && cells.get(text).find(cell => cell.includes(','));
        assert.ok(!cut, `${script}:${line}: txt("${text}") would end ${cut} at its comma`);
      }
    }
  });
}

// What gnuplot would take for points to leave out.
const WRONG = {
  'a column': 'plot file("orbit") using col("t"):col("X") with lines',
  'a value': 'plot file("orbit") using col("t"):(2*val("X")) with lines',
  'a hover text': 'plot file("orbit") using col("t"):col("x"):(sprintf("%g", val("X"))) with labels hypertext point',
  'a colour': 'plot file("orbit") using col("t"):col("x"):(val("X")) with lines lc variable',
  'a branch': 'plot file("orbit") using col("t"):(val("t") > 0 ? val("X") : 1) with lines',
  'error bars': 'plot file("orbit") using col("t"):col("x"):(val("X")) with yerrorbars',
  'an area': 'plot file("orbit") using col("t"):col("x"):(val("X")) with filledcurves',
  'a name at the axis': 'plot file("orbit") using col("t"):col("x"):ytic(txt("X")) with lines',
  'statistics': 'stats file("orbit") using (val("X")) nooutput',
  'a cell': 'x = cell("orbit", 1, "X"); plot x',
  'a comparison': 'plot file("orbit") using (txt("X") eq "a" ? 1 : 2):col("t") with lines',
};
const drawLine = line => {
  writeFileSync(join(scratch, 'orbit.csv'), 't,x\n0,1\n1,2\n2,4\n');
  writeFileSync(join(scratch, 'numbers.txt'), 'apex\t1.27\t1.27 m\n');
  writeFileSync(join(scratch, 'sketch.gp'), `${line}\n`);
  return draw(join(scratch, 'sketch.gp'), scratch, scratch, { name: 'sketch', size: SIZES[''] });
};
for (const [what, line] of Object.entries(WRONG)) {
  test(`${what} by a wrong name is refused, with the names of table, column, figure and script`, () => {
    const { drawn, said } = drawLine(line);
    assert.ok(!drawn && !existsSync(join(scratch, 'sketch.svg')));
    for (const word of ['sketch', 'orbit.csv', '"X"', 'sketch.gp']) assert.ok(said.includes(word), said);
  });
}

test('a method without a style, a number that nobody recorded, an absent table and a warning are refused', () => {
  const faults = {
    'set label 1 "a" at 0,0 tc ls style("Eler"); plot 1': 'no style for "Eler"',
    'set label 1 number("apx") at 0,0; plot 1': 'no number "apx"',
    'plot exact("apx")': 'no number "apx"',
    'x = cell("orbit", 4, "x"); plot x': 'orbit.csv has no row 4',
    'plot file("orbits") using col("t"):col("x")': 'orbits.csv',
    'plot file("orbit") using col("t"):(val("x") > 9 ? 1 : NaN) with lines': 'no valid points',
  };
  for (const [line, word] of Object.entries(faults)) {
    const { drawn, said } = drawLine(line);
    assert.ok(!drawn && said.includes(word), `${line}: ${said}`);
  }
});

test('a good one is drawn, with the number as the prose prints it', () => {
  const { drawn, said } = drawLine(
    'set label 1 number("apex") at 1,1; plot file("orbit") using col("t"):col("x") with lines ls style("Störmer–Verlet"), exact("apex") + cell("orbit", 3, "x")',
  );
  assert.ok(drawn, said);
  assert.match(readFileSync(join(scratch, 'sketch.svg'), 'utf8'), />1\.27 m</);
});
