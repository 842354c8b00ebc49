// Formulas become HTML at build time.
import katex from 'katex';
import { quantityTex } from './numbers.mjs';

// `problem` is told what is wrong with the TeX.
export function renderTex(tex, display, problem) {
  try {
    return katex.renderToString(tex.trim(), { displayMode: display, output: 'htmlAndMathml', strict: 'error', throwOnError: true });
  } catch (error) {
    problem(`bad TeX: ${error.message.replace(/^KaTeX parse error: /, '').replace(/[\u0332\u0333]/g, '')}`);
    return '';
  }
}

// Puts the values in place of \number{...}; `find` looks one up or reports it.
export const substituteNumbers = (tex, find) =>
  tex.replace(/\\number\s*\{([^{}]*)\}/g, (_, name) => {
    const number = find(name.trim());
    return number ? quantityTex(number) : '0';
  });
