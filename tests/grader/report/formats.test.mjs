// Reports of every verdict, held against the schema of report.json and the formats of others:
//   node formats.test.mjs WRITE_SAMPLES
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import Ajv from 'ajv/dist/2020.js';
import { openChromium } from '../../../book/paper/chromium.mjs';

const folder = mkdtempSync(join(tmpdir(), 'reports-'));
after(() => rmSync(folder, { recursive: true }));
execFileSync(process.argv[2], [folder]);
const samples = readdirSync(folder);

const json = path => JSON.parse(readFileSync(path, 'utf8'));
const schemaAt = path => json(fileURLToPath(new URL(path, import.meta.url)));
const ajv = new Ajv({ allErrors: true, allowUnionTypes: true });
const isReport = ajv.compile(schemaAt('../../../exercises/grader/report/report.schema.json'));
const isGradescope = ajv.compile(schemaAt('gradescope.schema.json'));

function assertValid(validate, value, name) {
  assert.ok(validate(value), `${name}: ${ajv.errorsText(validate.errors)}`);
}

test('there is a sample of every verdict', () => {
  assert.equal(samples.length, 15);
});

test('report.json is what its schema says', () => {
  for (const name of samples) assertValid(isReport, json(join(folder, name, 'report.json')), name);
});

test('the schema refuses what is no report', () => {
  const spoilt = [
    report => delete report.verdict,
    report => (report.verdict = 'FINE'),
    report => (report.seed = 1),
    report => (report.score = 1.5),
    report => (report.tests[0].points = -1),
    report => (report.extra = 1),
    report => (report.volatile.seconds = 'NaN'),
    report => (report.tests[1].findings[0].plot.file = '../../x.svg'),
  ];
  for (const spoil of spoilt) {
    const report = json(join(folder, 'PARTIAL', 'report.json'));
    spoil(report);
    assert.ok(!isReport(report), `${spoil}`);
  }
});

test('scores of a report add up', () => {
  for (const name of samples.filter(name => name === 'PARTIAL')) {
    const { score, points, tests } = json(join(folder, name, 'report.json'));
    const sum = key => tests.reduce((all, test) => all + test[key], 0);
    assert.deepEqual([score, points], [sum('score'), sum('points')]);
  }
});

test('plots that a report names are there', () => {
  const plots = json(join(folder, 'PARTIAL', 'report.json'))
    .tests.flatMap(test => test.findings)
    .map(f => f.plot.file);
  assert.deepEqual(plots, ['plots/test-2.svg']);
  assert.ok(existsSync(join(folder, 'PARTIAL', plots[0])));
});

test('without a grade there is no score, in any format', () => {
  for (const name of ['GRADER_ERROR', 'provisional']) {
    assert.equal(json(join(folder, name, 'report.json')).score, null);
    assert.ok(!existsSync(join(folder, name, 'results.json')));
    assert.match(readFileSync(join(folder, name, 'feedback.md'), 'utf8'), /GRADER\\?_ERROR, no grade/);
  }
});

test('results.json is what Gradescope reads, in whole points, and shows nothing before the marks', () => {
  for (const name of samples.filter(one => !['GRADER_ERROR', 'provisional'].includes(one))) {
    const results = json(join(folder, name, 'results.json'));
    assertValid(isGradescope, results, name);
    const report = json(join(folder, name, 'report.json'));
    assert.equal(results.score, report.score);
    assert.ok([results, ...results.tests].every(({ score }) => Number.isInteger(score)));
    assert.equal(results.tests.length, report.tests.length);
    assert.ok([results, ...results.tests].every(({ visibility }) => visibility === 'after_published'));
  }
});

test('junit.xml and plots are well-formed, and JUnit counts right', async () => {
  const browser = await openChromium();
  const page = await browser.newPage();
  const parse = text =>
    page.evaluate(source => {
      const all = new DOMParser().parseFromString(source, 'application/xml');
      const count = (root, what) => root.querySelectorAll(what).length;
      const suite = all.querySelector('testsuites > testsuite');
      return {
        error: all.querySelector('parsererror')?.textContent ?? null,
        said: suite && ['tests', 'failures', 'errors', 'skipped'].map(name => Number(suite.getAttribute(name))),
        there: suite && ['testcase', 'failure', 'error', 'skipped'].map(name => count(suite, `:scope ${name}`)),
      };
    }, text);
  const check = async path => {
    const found = await parse(readFileSync(path, 'utf8'));
    assert.equal(found.error, null, path);
    return found;
  };
  assert.ok((await parse('<a><b></a>')).error);
  for (const name of samples) {
    const { said, there } = await check(join(folder, name, 'junit.xml'));
    assert.deepEqual(said, there, name);
    const { tests } = json(join(folder, name, 'report.json'));
    assert.equal(said[0], tests.length + 1);
    assert.equal(said[2], ['ACCEPTED', 'PARTIAL', 'WRONG_ANSWER'].includes(name) ? 0 : 1, name);
  }
  await check(join(folder, 'PARTIAL', 'plots', 'test-2.svg'));
  await browser.close();
});
