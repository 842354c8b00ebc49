// NaN is never right:   node nan.test.mjs SOURCE GRADE EXERCISES...
// Each number that a function of a solution answers, in a reference or by return, is replaced by NaN.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { graded, verdicts } from './driver.mjs';
import { spoilt } from './spoilt.mjs';

const [source, grade, ...exercises] = process.argv.slice(2);
const limits = '20,60,3,10';

// All of an exercise in one driver, once the first of them is asked for.
function answersTo(exercise, texts) {
  let found;
  return i => (found ??= verdicts(exercise, texts, { source, grade, limits }))[i];
}

let tried = 0;
for (const exercise of exercises) {
  const ones = spoilt(exercise, source);
  const texts = ones.map(({ text }) => text);
  const answerTo = answersTo(exercise, texts);
  for (const [i, { what }] of ones.entries()) {
    const isFirst = tried++ === 0;
    test(`${exercise} takes no NaN, ${what}`, () => {
      const { verdict, full } = answerTo(i);
      assert.match(verdict, /^(WRONG_ANSWER|PARTIAL)$/);
      assert.ok(!full);
      if (!isFirst) return; // one goes the way of a submission
      const { status, stdout, stderr } = graded(exercise, texts[i], { grade, limits });
      assert.equal(status, 1, stdout + stderr);
      assert.match(stdout, /WRONG_ANSWER|PARTIAL/);
    });
  }
}
assert.ok(tried > exercises.length);
