// Changes that the prose proposes, applied to a program.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { applyChange, readChanges, readQuoted } from '../../book/weave/changes.mjs';
import { withGhost } from '../../book/weave/film-ghost.mjs';

const play = 'int main() {\n  const double h = 1;\n  step(h);\n}\n';
const fence = (kind, text) => `\`\`\`${kind}\n${text}\n\`\`\`\n`;
const change = (...diffs) => ({ diffs });

test('a change is read from its box, and what is quoted stands outside', () => {
  const box = `\\change{Two lines, swapped}\n${fence('diff', '- a\n+ b')}Words.\n\n${fence('prints', '2 m')}\\endchange\n`;
  const prose = `${fence('prints', '1 m')}\n${box}`;
  assert.deepEqual(readChanges(prose), [
    { name: 'two-lines-swapped', title: 'Two lines, swapped', diffs: ['- a\n+ b\n'], prints: ['2 m\n'] },
  ]);
  assert.deepEqual(readQuoted(prose), ['1 m\n']);
});

test('lines go and come, as deep as the program has them', () => {
  const { program, text, edits } = applyChange(
    { other: 'int x;\n', play },
    change('-   step(h);\n+   step(h);\n+     twice();'),
  );
  assert.equal(program, 'play');
  assert.equal(text, 'int main() {\n  const double h = 1;\n  step(h);\n    twice();\n}\n');
  assert.equal(edits[0].line, 3);
});

test('two diffs, the later lines first', () => {
  const { text } = applyChange({ play }, change('-   step(h);\n+   leap(h);', '  int main() {\n+   // new'));
  assert.equal(text, 'int main() {\n  // new\n  const double h = 1;\n  leap(h);\n}\n');
});

test('lines that stand nowhere, or twice', () => {
  assert.match(applyChange({ play }, change('- stop();')).fault, /stand in 0 programs/);
  assert.match(applyChange({ play, copy: play }, change('-   step(h);')).fault, /stand in 2 programs/);
  assert.match(
    applyChange({ play }, change('-   step(h);', '- stop();')).fault,
    /do not stand in play.cpp once:\n- stop/,
  );
});

test('a film gets a ghost, and a page that is none is refused', () => {
  const film = n =>
    `<script>\nconst view = [0, 0, ${n}, 1], speed = 1, names = ['a',], pictures = [[0],\n[${n}]];\nconst colours = {`;
  assert.match(
    withGhost(film(1), film(2)),
    /const ghost = \{ names: \['a',\], pictures: \[\[0\],\n\[2\]\] \};\nconst view = \[0, 0, 1, 1\]/,
  );
  assert.throws(() => withGhost('nothing', film(2)), /no page of a film/);
});
