// One colour, one meaning, for readers with any eyes: node colours.test.mjs BUILD SOURCE
import assert from 'node:assert/strict';
import { test } from 'node:test';
import {
  differenceCiede2000,
  filterDeficiencyDeuter,
  filterDeficiencyProt,
  filterDeficiencyTrit,
  wcagContrast,
} from 'culori';
import { readPalette } from './palette.mjs';

const { methods, others, schemes, value } = readPalette(process.argv[3], process.argv[2]);

const EYES = {
  'all cones': colour => colour,
  'no red cones': filterDeficiencyProt(1),
  'no green cones': filterDeficiencyDeuter(1),
  'no blue cones': filterDeficiencyTrit(1),
};
const FAR_APART = 8; // CIEDE2000: two such colours are told apart without laying them side by side
const SEEN = 3; // WCAG's contrast for graphics

const THINGS = ['FIRST', 'SECOND', 'THIRD', 'LIMIT'];
const told = [...new Set([...methods, ...THINGS.map(name => others[name])].map(({ colour }) => colour))].filter(
  colour => colour !== others.EXACT.colour,
);

const nameOf = colour => methods.find(m => m.colour === colour)?.name ?? THINGS.find(n => others[n].colour === colour);

for (const scheme of schemes) {
  const shade = colour => value(scheme, `plot-${colour}`);

  for (const [eyes, seen] of Object.entries(EYES)) {
    test(`in ${scheme}, eyes with ${eyes} tell all colours apart`, () => {
      const far = differenceCiede2000();
      const close = told.flatMap((one, i) =>
        told
          .slice(i + 1)
          .map(other => [nameOf(one), nameOf(other), far(seen(shade(one)), seen(shade(other)))])
          .filter(([, , distance]) => distance < FAR_APART),
      );
      assert.deepEqual(close, []);
    });
  }

  test(`in ${scheme}, all colours stand out from the paper`, () => {
    const paper = value(scheme, 'paper');
    for (const colour of told) assert.ok(wcagContrast(shade(colour), paper) >= SEEN, nameOf(colour));
  });
}

test('methods of one colour differ in their dash and in their symbol', () => {
  for (const one of methods)
    for (const other of methods) {
      if (one.name === other.name || one.colour !== other.colour) continue;
      assert.ok(one.dash !== other.dash, `${one.name} and ${other.name} have one dash`);
      assert.ok(one.symbol !== other.symbol, `${one.name} and ${other.name} have one symbol`);
    }
});

test('what is no method has the colour of none', () => {
  for (const name of THINGS)
    for (const method of methods) assert.notEqual(others[name].colour, method.colour, `${name} and ${method.name}`);
});
