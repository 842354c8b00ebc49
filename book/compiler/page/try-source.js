// The examples over a header, as a program to be tried.

/** The texts between @code and @endcode of a header. */
export function examplesOf(header) {
  const blocks = [...header.matchAll(/^\/\/\/ @code\n((?:\/\/\/.*\n)*?)\/\/\/ @endcode$/gm)];
  return blocks.map(([, text]) => text.replace(/^\/\/\/ ?/gm, ''));
}

// "// Now x is 0.81." is printed, and so is what a method has moved.
const printed = code =>
  code.replace(
    /^( *)\/\/ Now (.+) is (-?[\d.]+(?:e-?\d+)?)\.$/gm,
    (_, indent, expression) =>
      `${indent}std::printf("%s is %.9g\\n", ${JSON.stringify(expression)}, double(${expression}));`,
  );
const STATE = 'std::printf("x is %g, v is %g\\n", x, v);\n';

const indented = code => code.replace(/^(?=.)/gm, '  ');

/**
 * @param folder  "integrate", whose examples go on with each other's variables, or "shelf", where each stands by itself
 * @returns the text of a program, as a reader would write it around the examples
 */
export function programOf(folder, name, examples) {
  const included = examples.join('').match(/^#include .*$/gm) ?? [];
  const bodies = examples
    .map(code => code.replace(/^#include .*\n/gm, '').trim())
    .map(code => (folder === 'shelf' ? `{\n${indented(printed(code))}\n}\n` : `${code}\n${STATE}`));
  const includes = [...new Set([`#include "${name}"`, ...included, '#include <cstdio>'])];
  return `${includes.join('\n')}\n\nint main() {\n${indented(bodies.join('\n'))}}\n`;
}
