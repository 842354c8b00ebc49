// Formulas become HTML at build time.
import katex from 'katex';
import { quantityTex } from './numbers.mjs';
import { linesBefore } from './text.mjs';

// `problem` is told what is wrong with the TeX, and in which of its lines (0: the first).
export function renderTex(tex, display, problem) {
  try {
    return katex.renderToString(tex.trim(), {
      displayMode: display,
      output: 'htmlAndMathml',
      strict: 'error',
      throwOnError: true,
    });
  } catch (error) {
    const at = tex.length - tex.trimStart().length + (error.position ?? 0);
    problem(`bad TeX: ${faultText(error.message)}`, linesBefore(tex, at));
    return '';
  }
}

// KaTeX underlines the place with combining characters.
const faultText = message =>
  message
    .replace(/[\u0332\u0333]/g, '')
    .replace(/^KaTeX parse error: /, '')
    .replace(/^LaTeX-incompatible.*?'error': /, '')
    .replace(/ \[\w+\](?= at )/, '')
    .replace(/ at (?:position \d+|end of input): ([\s\S]*)$/, ', in "$1"')
    .replace(/\s+/g, ' ');

// Puts the values in place of \number{...}; `find` looks one up, or reports that there is none in this line of the formula.
export const substituteNumbers = (tex, find) =>
  tex.replace(/\\number\s*\{([^{}]*)\}/g, (_, name, at) => {
    const number = find(name.trim(), linesBefore(tex, at));
    return number ? quantityTex(number) : '0';
  });
