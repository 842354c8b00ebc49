// A page for each student of a round, graded by the stand-in, in the browser:   node pages.test.mjs STAND_IN
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, readdirSync, renameSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { HtmlValidate } from 'html-validate';
import { openChromium } from '../../../book/paper/chromium.mjs';
import { classOf, time, usual } from './course.mjs';

const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
const late = '2020-02-09T12:00:00Z';
const hostile = '<script>alert(1)<~script>';
const course = more =>
  usual({
    name: 'Numerical <b>integration</b>',
    roster: 'roster.csv',
    late: { points_a_day: 3 },
    assignment: [
      {
        name: 'week-1',
        exercises: ['1-first/one', '1-first/two', '2-second/three'],
        due: time('2020-02-08T23:59:00'),
        seed_file: 'seed',
      },
    ],
    ...more,
  });

function graded(more) {
  const room = classOf(course(more), {
    'submissions/ada/1-first/one': ['// score 10\n', late],
    'submissions/ada/1-first/two': '// score 4\n// got 0.25\n// looks like <i>Euler</i>\n// plot',
    'submissions/ada/2-second/three': '</pre><script>alert(1)</script>\n\u202e\u001b[31m ::error:: ' + 'x'.repeat(300),
    'submissions/Bob_4711_assignsubmission_file/one': '// score 10',
    'submissions/cy/one': '// fails',
  });
  mkdirSync(room.path(`submissions/${hostile}`));
  writeFileSync(room.path(`submissions/${hostile}/<img src=x onerror=alert(2)>`), '');
  room.write('submissions/ada/1-first/notes', '');
  room.write('seed', '98765\n');
  const keys = [
    'ada,Ada <b>Lovelace</b>',
    'b@x,Bob',
    'cy,Cy',
    'dee,',
    `${hostile},"<img src=x onerror=alert(1)>"`,
    '../up,Up',
  ];
  room.write('roster.csv', `student,name\n${keys.join('\n')}\n`);
  room.run = room.grade();
  room.page = name => room.read(`week-1/pages/${name}.html`);
  return room;
}
const room = graded({});

let browser;
before(async () => {
  browser = await openChromium();
});
after(() => browser.close());

async function open(name, width, colorScheme) {
  const tab = await (await browser.newContext({ viewport: { width, height: 900 }, colorScheme })).newPage();
  tab.faults = [];
  tab.on('console', message => tab.faults.push(message.text()));
  tab.on('pageerror', error => tab.faults.push(error.message));
  tab.on('dialog', dialog => tab.faults.push(dialog.message()));
  tab.on('request', request => /^(file|data):/.test(request.url()) || tab.faults.push(request.url()));
  await tab.goto(pathToFileURL(room.path(`results/week-1/pages/${name}`)).href.replaceAll('%25', '%25'));
  return tab;
}

for (const [width, colours] of [
  [1280, 'light'],
  [390, 'dark'],
]) {
  test(`a student's page at ${width} pixels, ${colours}: nothing amiss, nothing loaded, no scrolling sideways`, async () => {
    for (const name of readdirSync(room.path('results/week-1/pages'))) {
      const tab = await open(name, width, colours);
      assert.deepEqual(tab.faults, []);
      assert.ok(await tab.evaluate(() => document.documentElement.scrollWidth <= document.documentElement.clientWidth));
      assert.ok(await tab.$$eval('img', all => all.every(one => one.naturalWidth > 0)));
    }
  });
}

test("what tools for accessibility find on a student's page is nothing", async () => {
  for (const colours of ['light', 'dark']) {
    const context = await browser.newContext({
      viewport: { width: 390, height: 900 },
      colorScheme: colours,
      bypassCSP: true,
    });
    const tab = await context.newPage();
    await tab.goto(pathToFileURL(room.path('results/week-1/pages/ada.html')).href);
    await tab.evaluate(axe);
    const { violations } = await tab.evaluate(() => axe.run(document, { preload: false }));
    assert.deepEqual(
      violations.map(v => `${v.id}: ${v.help} ${v.nodes[0].target}`),
      [],
    );
  }
});

test("the HTML of students' pages is valid", async () => {
  const validate = new HtmlValidate({ extends: ['html-validate:recommended'], root: true });
  for (const name of readdirSync(room.path('results/week-1/pages'))) {
    const report = await validate.validateFile(room.path(`results/week-1/pages/${name}`));
    assert.deepEqual(
      report.results.flatMap(result => result.messages).map(m => `${name}:${m.line}: ${m.message}`),
      [],
    );
  }
});

test('a page says what the feedback says: verdict, reason, tests, findings, picture, grader, seed', async () => {
  assert.equal(room.run.status, 42);
  const tab = await open('ada.html', 1280, 'light');
  const text = (await tab.evaluate(() => document.body.innerText)).replace(/\s+/g, ' ');
  for (const part of [
    'week-1: Ada <b>Lovelace</b>',
    'Numerical <b>integration</b>: 11 of 30 points',
    '1-first/one: 7 of 10',
    'ACCEPTED, 10 of 10 points. Every test held.',
    'Handed in 13 h 1 min after the end: 3 points are taken, for 1 day begun.',
    '1-first/two: 4 of 10',
    'PARTIAL, 4 of 10 points. Some tests held, some did not.',
    'the first test 4 of 4 held',
    'the second test 0 of 6 did not hold',
    'Asked to be right',
    'Got 0.25',
    'Diagnosis <i>Euler</i>',
    '2-second/three: 0 of 10',
    'COMPILE_ERROR, 0 of 10 points. The compiler refused it.',
    '</pre><script>alert(1)</script>',
    'Not looked at: notes.',
    'build/exercises/grade 1-first/two two.h --seed 98765',
    'Graded with seed 98765, by grader one.',
  ])
    assert.ok(text.includes(part), `${part} in ${text}`);
  assert.deepEqual(await tab.$$eval('img', all => all.map(one => one.alt)), ['a <curve>']);
  assert.doesNotMatch(text, /Not looked at: [^.]*(one|two|three)\.h/);
  assert.doesNotMatch(room.page('ada'), /\u001b|\u202e|<script/);
});

test('pages are those of whoever has a folder, by their keys, and none tells of another', () => {
  assert.deepEqual(readdirSync(room.path('results/week-1/pages')).sort(), [
    '%3Cscript%3Ealert%281%29%3C~script%3E.html'.replace('~', '%7E'),
    'ada.html',
    'b@x.html',
    'cy.html',
  ]);
  for (const [name, others] of [
    ['ada', /Bob|Cy\b|b@x/],
    ['b@x', /Ada|Cy\b|0\.25/],
  ])
    assert.doesNotMatch(room.page(name), others);
});

test('names of files and of students are text on a page, and nothing else', () => {
  const page = room.page('%3Cscript%3Ealert%281%29%3C%7Escript%3E');
  assert.match(page, /there is &lt;img src=x onerror=alert\(2\)&gt;/);
  assert.match(page, /<h1>week-1: &lt;img src=x onerror=alert\(1\)&gt;<\/h1>/);
  assert.doesNotMatch(page, /<img|<script/);
});

test('who was not graded reads that it is no grade', () => {
  assert.match(room.page('cy'), /<h2>1-first\/one: no grade<\/h2>\s*<p class="said">The grader failed, not your code/);
  assert.match(room.page('cy'), /no sum, since the grader failed/);
});

test('what is not due and not handed in costs nothing on the page', () => {
  const soon = classOf(
    course({
      assignment: [{ name: 'week-1', exercises: ['1-first/one', '1-first/two'], due: time('2999-01-01T00:00:00') }],
    }),
    { 'submissions/ada/1-first/one': '// score 4' },
  );
  soon.write('roster.csv', 'student\nada\n');
  soon.grade();
  const page = soon.read('week-1/pages/ada.html');
  assert.match(page, /4 of 10 points/);
  assert.match(page, /<h2>1-first\/two: not yet due<\/h2>\s*<p>Nothing was handed in so far\.<\/p>/);
});

test('a seed that is not to be shown stands on no page', () => {
  const silent = graded({ show_seed: false });
  for (const name of ['ada', 'b@x']) assert.doesNotMatch(silent.page(name), /98765|--seed/);
  assert.match(silent.page('ada'), /Graded by grader one\./);
});

test('the archive has a page for each folder, by the name that it came with', () => {
  const out = room.path('unpacked');
  mkdirSync(out);
  execFileSync('cmake', ['-E', 'tar', 'xf', room.path('results/week-1/pages.zip')], { cwd: out });
  assert.deepEqual(readdirSync(out).sort(), [hostile, 'Bob_4711_assignsubmission_file', 'ada', 'cy'].sort());
  assert.equal(readFileSync(`${out}/Bob_4711_assignsubmission_file/feedback.html`, 'utf8'), room.page('b@x'));
  assert.deepEqual(readdirSync(`${out}/ada`), ['feedback.html']);
});

test('a picture that is a link is not on the page, and neither is one from elsewhere', () => {
  const linked = graded({});
  const folder = linked.path('results/week-1/ada/1-first/two');
  const report = readFileSync(`${folder}/report.json`, 'utf8');
  assert.match(report, /"plots\/test-2\.svg"/);
  assert.match(linked.page('ada'), /<img /);
  mkdirSync(`${folder}/plots/test-`);
  linked.write('results/week-1/ada/secret.svg', 'secret');
  writeFileSync(`${folder}/report.json`, report.replace('plots/test-2.svg', 'plots/test-/../../../../secret.svg'));
  linked.grade();
  assert.doesNotMatch(linked.page('ada'), /<img /);
  writeFileSync(`${folder}/report.json`, report);
  renameSync(`${folder}/plots/test-2.svg`, `${folder}/kept.svg`);
  symlinkSync(`${folder}/kept.svg`, `${folder}/plots/test-2.svg`);
  assert.equal(linked.grade().status, 2);
  rmSync(`${folder}/plots/test-2.svg`);
});
