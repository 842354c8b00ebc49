// What the grader lists, beside the chapters:   node list.test.mjs SOURCE GRADE
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';

const [source, grade] = process.argv.slice(2);
const chapters = readdirSync(join(source, 'chapters')).filter(name => /^\d/.test(name));
const tasks = chapters.flatMap(chapter =>
  [...readFileSync(join(source, 'chapters', chapter, 'chapter.md'), 'utf8').matchAll(/^\\task\{(.*)\}/gm)].map(
    ([, name]) => `${chapter}/${name}`,
  ),
);
const { stdout } = spawnSync(grade, ['--list'], { encoding: 'utf8' });

test("exercises are listed in the book's order, which the build reads when it is configured", () => {
  assert.ok(tasks.length > 0);
  assert.deepEqual(stdout.match(/\d-[a-z-]+\/[a-z-]+/g), tasks);
});

test('each exercise is listed with its level and its minutes', () => {
  for (const line of stdout.trimEnd().split('\n')) assert.match(line, / level [123] +\d+ min  \S/);
});
