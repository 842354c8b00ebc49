// One colour, one meaning, for readers with any eyes: node colours.test.mjs BUILD SOURCE
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import {
  differenceCiede2000,
  filterDeficiencyDeuter,
  filterDeficiencyProt,
  filterDeficiencyTrit,
  wcagContrast,
} from 'culori';

const source = process.argv[3];
const css = readFileSync(join(source, 'book/theme/book.css'), 'utf8');
const script = readFileSync(join(source, 'book/theme/figure.gp'), 'utf8');

const EYES = {
  'all cones': colour => colour,
  'no red cones': filterDeficiencyProt(1),
  'no green cones': filterDeficiencyDeuter(1),
  'no blue cones': filterDeficiencyTrit(1),
};
const FAR_APART = 8; // CIEDE2000: two such colours are told apart without laying them side by side
const SEEN = 3; // WCAG's contrast for graphics

const look = text => ({
  colour: parseInt(text.match(/'#0000([0-9a-f]{2})'/)[1], 16),
  dash: text.match(/dt (\([^)]*\)|\w+)/)?.[1] ?? 'solid',
  symbol: text.match(/pt (\d+)/)?.[1],
});
const methods = [...script.matchAll(/^eval method\("([^"]*)", "\w+", "(.*)"\)/gm)].map(([, name, text]) => ({
  name,
  ...look(text),
}));
const others = Object.fromEntries(
  [...script.matchAll(/^eval line_style\("(\w+)", "(.*?)"\)/gm)].map(([, name, text]) => [name, look(text)]),
);
const THINGS = ['FIRST', 'SECOND', 'THIRD', 'LIMIT'];
const told = [...new Set([...methods, ...THINGS.map(name => others[name])].map(({ colour }) => colour))].filter(
  colour => colour !== others.EXACT.colour,
);

const dark = css.indexOf('prefers-color-scheme: dark');
const schemes = { light: css.slice(0, dark), dark: css.slice(dark) };
const valueOf = (text, name) => text.match(new RegExp(`--${name}: (#[0-9a-f]{6})`))[1];
const nameOf = colour => methods.find(m => m.colour === colour)?.name ?? THINGS.find(n => others[n].colour === colour);

for (const [scheme, text] of Object.entries(schemes)) {
  const value = colour => valueOf(text, `plot-${colour}`);

  for (const [eyes, seen] of Object.entries(EYES)) {
    test(`in ${scheme}, eyes with ${eyes} tell all colours apart`, () => {
      const far = differenceCiede2000();
      const close = told.flatMap((one, i) =>
        told
          .slice(i + 1)
          .map(other => [nameOf(one), nameOf(other), far(seen(value(one)), seen(value(other)))])
          .filter(([, , distance]) => distance < FAR_APART),
      );
      assert.deepEqual(close, []);
    });
  }

  test(`in ${scheme}, all colours stand out from the paper`, () => {
    const paper = valueOf(text, 'paper');
    for (const colour of told) assert.ok(wcagContrast(value(colour), paper) >= SEEN, nameOf(colour));
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
