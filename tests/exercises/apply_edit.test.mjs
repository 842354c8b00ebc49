// An edit makes the one mistake that it describes, or is refused in one line.   node apply_edit.test.mjs
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

const program = fileURLToPath(new URL('../../exercises/apply_edit.mjs', import.meta.url));
const folder = mkdtempSync(join(tmpdir(), 'edit-'));
const at = name => join(folder, name);
writeFileSync(
  at('spring.h'),
  `// a spring
inline double pull(double x) {
  return -4 * x;
}

inline double step(double x) {
  x += pull(x);
  return x;
}
`,
);

function apply(edit) {
  writeFileSync(at('edit.txt'), edit);
  const { status, stderr } = spawnSync('node', [program, at('spring.h'), at('edit.txt'), at('out/spring.h')], {
    encoding: 'utf8',
  });
  return status === 0 ? readFileSync(at('out/spring.h'), 'utf8') : stderr;
}

test('lines are put in the place of others, and the head becomes a comment', () => {
  assert.equal(
    apply(
      'Fails: it swings\nSays: the wrong way\nPushes.\n\n- -4 * x\n+ 4 * x\n\n-   x += pull(x);\n-   return x;\n+   return x + pull(x);\n',
    ),
    `// Fails: it swings
// Says: the wrong way
// Pushes.
// a spring
inline double pull(double x) {
  return 4 * x;
}

inline double step(double x) {
  return x + pull(x);
}
`,
  );
});

test('a function may be named where the lines alone are not clear', () => {
  const out = apply('Fails: it swings\nIn: step\n\n- return x\n+ return 0\n');
  assert.match(out, /x \+= pull\(x\);\n  return 0;/);
  assert.match(
    apply('Fails: it swings\nIn: fly\n\n- x\n+ y\n'),
    /^[^\n]*edit\.txt: there is no fly in [^\n]*spring\.h\n$/,
  );
});

for (const [what, edit, says] of [
  [
    'that is not in the file',
    '- return -5 *\n-   x;\n+ return 0;',
    /^[^\n]*edit\.txt: [^\n]*spring\.h does not hold "return -5 \* x;"\n$/,
  ],
  [
    'that is in the file twice',
    '- pull(\n+ push(',
    /^[^\n]*edit\.txt: [^\n]*spring\.h holds "pull\(" more than once\n$/,
  ],
  ['of nothing', '+ return 0;', /does not hold ""/],
]) {
  test(`an edit ${what} is refused in one line`, () => assert.match(apply(`Fails: it swings\n\n${edit}\n`), says));
}

test('an edit names the test that must see it', () => {
  assert.match(
    apply('Says: something\n\n- x\n+ y\n'),
    /edit\.txt: needs "Fails: TEST" as its first line and at least one change\n$/,
  );
  assert.match(apply('Fails: it swings\n'), /at least one change/);
});
