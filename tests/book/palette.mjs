// The colours of the book: what the methods and figure.gp call them, and what book.css makes of them.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { readLooks } from '../../book/weave/method-looks.mjs';

// { methods: [{ name, colour, dash, symbol }], others: { EXACT: { colour, ... } }, value(scheme, name) } of a source tree and its build; a
// colour is the N of the style sheet's --plot-N, a scheme is light or dark.
export function readPalette(source, build) {
  const css = readFileSync(join(source, 'book/theme/book.css'), 'utf8');
  const script = readFileSync(join(source, 'book/theme/figure.gp'), 'utf8');
  const dark = css.indexOf('prefers-color-scheme: dark');
  const schemes = { light: css.slice(0, dark), dark: css.slice(dark) };
  const styles = pattern => [...script.matchAll(pattern)].map(([, name, text]) => ({ name, ...look(text) }));
  return {
    methods: readLooks(join(build, 'cards/register/methods.csv')),
    others: Object.fromEntries(styles(/^eval line_style\("(\w+)", "(.*?)"\)/gm).map(style => [style.name, style])),
    schemes: Object.keys(schemes),
    value: (scheme, name) => schemes[scheme].match(new RegExp(`--${name}: (#[0-9a-f]{6})`))[1],
  };
}

const look = text => ({
  colour: parseInt(text.match(/'#0000([0-9a-f]{2})'/)[1], 16),
  dash: text.match(/dt (\([^)]*\)|\w+)/)?.[1] ?? 'solid',
  symbol: text.match(/pt (\d+)/)?.[1],
});
