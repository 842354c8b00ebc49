// A template repository, its workflow's own steps run in a clean clone:   node github.test.mjs GRADE SOURCE
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { after, test } from 'node:test';
import Ajv from 'ajv/dist/2020.js';
import { commit, git } from './repository.mjs';

const [grade, source] = process.argv.slice(2);
const build = dirname(dirname(grade));
const exercises = ['2-euler/orbit-drift', '2-euler/stiffest-leash'];
const folder = mkdtempSync(join(tmpdir(), 'github-'));
after(() => rmSync(folder, { recursive: true, force: true }));
const at = (...names) => join(folder, ...names);
const make = (...words) =>
  spawnSync(join(source, 'exercises/hosts/github/make.sh'), ['--build', build, ...words], {
    encoding: 'utf8',
    cwd: folder,
  });

// By what the reporter reads, and what its graders write.
const isResult = new Ajv({ allErrors: true, allowUnionTypes: true }).compile({
  type: 'object',
  additionalProperties: false,
  required: ['version', 'status', 'max_score', 'tests'],
  properties: {
    version: { const: 1 },
    status: { enum: ['pass', 'fail', 'error'] },
    max_score: { type: 'number', minimum: 0 },
    tests: {
      type: 'array',
      minItems: 1,
      items: {
        type: 'object',
        additionalProperties: false,
        required: ['name', 'status', 'score', 'message', 'test_code', 'filename', 'line_no'],
        properties: {
          name: { type: 'string' },
          status: { enum: ['pass', 'fail', 'error'] },
          score: { type: 'number', minimum: 0 },
          message: { type: ['string', 'null'] },
          test_code: { type: 'string' },
          filename: { type: 'string' },
          line_no: { type: 'integer', minimum: 0 },
          duration: { type: 'number', minimum: 0 },
        },
      },
    },
  },
});

// The `run` of each step, as the workflow has it: a block behind `run: |`, until a line that is further left.
function steps(workflow) {
  return workflow.split('\n      - ').flatMap(step => {
    const block = step.split('        run: |\n')[1];
    return block
      ? [
          block
            .split('\n')
            .map(line => line.slice(10))
            .join('\n'),
        ]
      : [];
  });
}

mkdirSync(at('bin'));
writeFileSync(at('bin/sudo'), `#!/bin/sh\necho "$@" >>${at('sudo')}\n`, { mode: 0o755 });

// Runs the steps in a clean clone with these headers in it.
function workflow(headers) {
  commit(at('template'), headers, '2020-02-08T20:00:00Z');
  for (const name of ['clone', 'temp', 'out', 'summary']) rmSync(at(name), { recursive: true, force: true });
  git(folder, ['clone', '--quiet', 'template', 'clone']);
  mkdirSync(at('temp'));
  const env = {
    PATH: `${at('bin')}:${process.env.PATH}`,
    HOME: at('temp'),
    RUNNER_TEMP: at('temp'),
    GITHUB_OUTPUT: at('out'),
    GITHUB_STEP_SUMMARY: at('summary'),
  };
  const text = readFileSync(at('clone/.github/workflows/classroom.yml'), 'utf8');
  const codes = steps(text).map((run, i) => {
    writeFileSync(at(`step-${i}`), run);
    return spawnSync('bash', ['-e', at(`step-${i}`)], { cwd: at('clone'), env, encoding: 'utf8' });
  });
  const out = existsSync(at('out'))
    ? Object.fromEntries(
        readFileSync(at('out'), 'utf8')
          .trim()
          .split('\n')
          .map(line => line.split(/=(.*)/s)),
      )
    : {};
  const result = out.result && JSON.parse(Buffer.from(out.result, 'base64').toString());
  return { codes, out, result };
}

const answer = name => readFileSync(join(source, 'exercises', name, 'solution.h'), 'utf8');
const headers = Object.fromEntries(exercises.map(name => [`${name.split('/')[1]}.h`, answer(name)]));

test('a template has starters, a workflow and the grader, and nothing of the solutions', () => {
  const made = make(...exercises.flatMap(name => ['--exercise', name]), '--out', 'template');
  assert.deepEqual([made.status, made.stderr.replace(/^-- .*\n/gm, '')], [0, '']);
  const files = readdirSync(at('template'), { recursive: true }).map(String);
  assert.ok(files.includes('.grader/licences/README.md') && files.includes('orbit-drift.h'));
  assert.ok(!files.some(name => /solution|judge|seed|right|wrong/.test(name)), files.join('\n'));
  for (const [says, ...words] of [
    [/name at least one --exercise/, '--out', 'x'],
    [/there is no exercise/, '--exercise', 'x/y', '--out', 'x'],
    [/name a folder that is not there yet/, '--exercise', exercises[0]],
    [/'template' is there already/, '--exercise', exercises[0], '--out', 'template'],
  ]) {
    const { status, stderr } = make(...words);
    assert.match(stderr, says);
    assert.equal(status, 2);
  }
});

test('right answers get all points, in the form that the reporter reads', () => {
  const { codes, out, result } = workflow(headers);
  assert.deepEqual(
    codes.map(one => one.status),
    [0, 0],
    codes.map(one => one.stderr).join('\n'),
  );
  assert.match(readFileSync(at('sudo'), 'utf8'), /install -y --no-install-recommends g\+\+ bubblewrap/);
  assert.equal(out.all, 'yes');
  assert.ok(isResult(result), JSON.stringify(isResult.errors));
  assert.equal(result.status, 'pass');
  assert.equal(result.max_score, 20);
  assert.equal(
    result.tests.reduce((sum, one) => sum + one.score, 0),
    20,
  );
  assert.match(readFileSync(at('summary'), 'utf8'), /orbit-drift/);
  assert.equal(git(at('clone'), ['status', '--porcelain']), '', 'what the grader makes is nothing to commit');
});

test('a header that is missing costs its points and no other, and the run goes on', () => {
  rmSync(at('template/stiffest-leash.h'));
  const { codes, out, result } = workflow({ 'orbit-drift.h': answer(exercises[0]) });
  assert.deepEqual(
    codes.map(one => one.status),
    [0, 0],
  );
  assert.equal(out.all, 'no');
  assert.ok(isResult(result), JSON.stringify(isResult.errors));
  assert.deepEqual([result.status, result.max_score], ['fail', 20]);
  assert.equal(
    result.tests.reduce((sum, one) => sum + one.score, 0),
    10,
  );
  assert.ok(out.result.length < 128 * 1024);
});
