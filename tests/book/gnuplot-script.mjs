// What stands in a gnuplot script, as far as a test of the figures must know it.

// The script's strings, { text, line, call }: `call` is the function that the string is handed to, as in col("t"). And its
// code, of the same length, with strings and comments left blank.
export function readScript(script) {
  const strings = [];
  let code = '', open = null;
  for (let i = 0; i < script.length; ++i) {
    const c = script[i];
    if (open) {
      const ends = c === open.quote && script[i - 1] !== '\\';
      if (ends) {
        strings.push({ text: script.slice(open.at + 1, i), line: script.slice(0, i).split('\n').length, call: open.call });
        open = null;
      }
      code += ends || c === '\n' ? c : ' ';
    } else if (c === '#') {
      const end = script.indexOf('\n', i);
      code += ' '.repeat((end < 0 ? script.length : end) - i);
      i = (end < 0 ? script.length : end) - 1;
    } else {
      if (c === '"' || c === "'") open = { quote: c, at: i, call: code.match(/(\w+)\s*\(\s*$/)?.[1] };
      code += c;
    }
  }
  return { strings, code };
}
