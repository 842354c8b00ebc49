// NaN is never right:   node nan.test.mjs SOURCE GRADE EXERCISES...
// Each number that a function of a solution answers, in a reference or by return, is replaced by NaN.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { graded, verdicts } from './driver.mjs';

const [source, grade, ...exercises] = process.argv.slice(2);
const limits = '20,60,3,10';

function parametersOf(list) {
  let depth = 0;
  const parts = [''];
  for (const c of list.replace(/\s+/g, ' ')) {
    depth += '(<'.includes(c) - '>)'.includes(c);
    if (c === ',' && depth === 0) parts.push('');
    else parts[parts.length - 1] += c;
  }
  return parts.map((part, i) => {
    const [, type, name] = part.trim().match(/^(.*[&\s>])(?!Vec$|double$|int$|Acceleration$)(\w+)$/) ?? [];
    return name ? { type: type.trim(), name } : { type: part.trim(), name: `p${i}` };
  });
}

// What spoils a value; nothing for those that can't hold a NaN.
function spoil(type, name) {
  const [, element] = type.match(/^std::vector<(\w+)>/) ?? [];
  if (element) return `if (!${name}.empty()) { ${spoil(element, `${name}.back()`)} }`;
  if (/^Vec\b/.test(type)) return `${name}.y = NAN;`;
  return /^double\b/.test(type) ? `${name} = NAN;` : '';
}

// The solution with one function's answers spoilt, one after the other.
function spoilt(exercise) {
  const read = name => readFileSync(join(source, 'exercises', exercise, name), 'utf8');
  const whole = read('solution.h');
  const solution = whole.replace(/^#.*$/gm, '');
  const harness = read('harness.h');
  const head = [
    ...whole.match(/^#.*$/gm),
    `namespace right {\n${solution}\n}`,
    ...harness.matchAll(/^using \w+ = .*;$/gm),
    ...[...solution.matchAll(/^(?:struct|using) (\w+)/gm)].map(([, name]) => `using right::${name};`),
  ].join('\n');
  const wanted = [...harness.matchAll(/harness::Wanted<\s*(\S+?)\s*\(([^;]*)\)>\s*wanted\w*\s*=\s*(\w+);/g)];
  return wanted.flatMap(([, result, list, name]) => {
    const others = wanted.filter(other => other[3] !== name).map(other => `using right::${other[3]};`);
    const parameters = parametersOf(list);
    const call = `right::${name}(${parameters.map(one => one.name).join(', ')})`;
    const all = parameters.filter(({ type }) => /&$/.test(type) && !/^const\b/.test(type));
    if (result !== 'void') all.push({ type: result, name: 'answer_' });
    return all
      .map(one => ({ what: `${name}: ${one.name}`, line: spoil(one.type, one.name) }))
      .filter(({ line }) => line)
      .map(({ what, line }) => ({
        what,
        text: `${head}
${others.join('\n')}
inline ${result} ${name}(${parameters.map(one => `${one.type} ${one.name}`).join(', ')}) {
  ${result === 'void' ? call : `${result} answer_ = ${call}`};
  ${line}
  ${result === 'void' ? '' : 'return answer_;'}
}
`,
      }));
  });
}

// All of an exercise in one driver, once the first of them is asked for.
function answersTo(exercise, texts) {
  let found;
  return i => (found ??= verdicts(exercise, texts, { source, grade, limits }))[i];
}

let tried = 0;
for (const exercise of exercises) {
  const ones = spoilt(exercise);
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
