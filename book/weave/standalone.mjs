// Makes a figure of the book stand outside it, with the style sheet's colours inside:
//   node standalone.mjs FIGURE.svg BOOK.css TITLE OUT.svg
import { readFileSync, writeFileSync } from 'node:fs';
import { adoptSvg } from './svg.mjs';

const [figure, styleSheet, title, out] = process.argv.slice(2);
const css = readFileSync(styleSheet, 'utf8');
const dark = css.search(/@media [^{]*prefers-color-scheme: dark/);

const colours = theme => {
  const value = name => theme.match(new RegExp(`--${name}: (#[0-9a-f]+);`))[1];
  const once = new Set(theme.match(/--plot-\d+(?=: )/g)); // for dark, they stand in the style sheet twice
  const plots = [...once].map(name => `${name}: ${value(name.slice(2))};`);
  return `svg { color: ${value('ink')}; font-family: Inter, system-ui, sans-serif; ${plots.join(' ')} }`;
};
const style = `<style>${colours(css.slice(0, dark))} @media (prefers-color-scheme: dark) { ${colours(css.slice(dark))} }</style>`;
const { html: svg } = adoptSvg(readFileSync(figure, 'utf8'), { id: 'figure', title, description: title });
writeFileSync(
  out,
  svg.replace('<svg ', '<svg xmlns="http://www.w3.org/2000/svg" ').replace('<title', `${style}<title`) + '\n',
);
