// The values that gnuplot shows under the mouse ('with labels hypertext'): taken out of the drawing, which keeps the symbols.
import { smarten } from './text.mjs';

// [{ at: [x, y], says }], in the order of the drawing.
export function takePoints($) {
  const points = [];
  $('[onmousemove]').each((_, e) => {
    const tip = e.attribs.onmousemove.match(/showHypertext\(evt,\s*'([\s\S]*)'\)/)?.[1];
    const symbol = $(e).children('use');
    const at = symbol.attr('transform')?.match(/translate\(\s*(-?[\d.]+)\s*,\s*(-?[\d.]+)\s*\)/);
    if (tip && at) points.push({ at: [at[1], at[2]].map(Number), says: tidy(tip.replace(/\\'/g, "'")) });
    $(e).replaceWith(symbol);
  });
  return points;
}

// C's printf knows a minus zero, and no minus but the hyphen.
const tidy = tip =>
  smarten(tip)
    .replace(/(?<![\w.])-(0(?:\.0+)?)(?![\d.])/g, '$1')
    .replace(/(?<![\w.])-(?=\d)/g, '\u2212');

// What the page's script reads: for each of the two sizes where the points are, and what they say, where the sizes differ twice.
export function valuesHtml({ wide, narrow }) {
  if (!wide.length && !narrow.length) return '';
  const says = points => points.map(point => point.says);
  const at = points => points.flatMap(point => point.at.map(number => Math.round(number * 10) / 10));
  const values = { says: says(wide), wide: at(wide), narrow: at(narrow) };
  if (says(wide).join('\n') !== says(narrow).join('\n')) values.narrowSays = says(narrow);
  return `<script type="application/json" class="values">${JSON.stringify(values).replace(/</g, '\\u003c')}</script>\n`;
}
