// What stands in a gnuplot script, as far as a test of the figures must know it.

// The script's strings, { text, line, call, alone, ticks }: `call` is the function that the string is handed to, as in
// col("t"), `alone` whether it is all that is handed over, and `ticks` whether it labels an axis. And the code, of the same length, with strings and comments left blank.
export function readScript(script) {
  const strings = [];
  let code = '',
    open = null;
  for (let i = 0; i < script.length; ++i) {
    const c = script[i];
    if (open) {
      const ends = c === open.quote && script[i - 1] !== '\\';
      if (ends) {
        strings.push({
          ...open,
          text: script.slice(open.at + 1, i),
          alone: /^\s*\)/.test(script.slice(i + 1)),
          line: script.slice(0, i).split('\n').length,
        });
        open = null;
      }
      code += ends || c === '\n' ? c : ' ';
    } else if (c === '#') {
      const end = script.indexOf('\n', i) < 0 ? script.length : script.indexOf('\n', i);
      code += ' '.repeat(end - i);
      i = end - 1;
    } else {
      if (c === '"' || c === "'")
        open = { quote: c, at: i, call: code.match(/(\w+)\s*\(\s*$/)?.[1], ticks: /\bset [xy]tics[^;\n]*$/.test(code) };
      code += c;
    }
  }
  return { strings, code: code.replace(/\\\n/g, '  ') };
}

// Every place where a script reaches a column by its number. column(0), the number of the row, is none.
export function columnsByNumber(script) {
  const { code } = readScript(script);
  const found = [];
  for (const use of code.matchAll(/\busing\s+/g)) {
    const entries = entriesOf(code.slice(use.index + use[0].length));
    found.push(
      ...entries
        .filter(entry => !/^(\(|col\(|[xyz]tic\((txt\(|[a-z]\w*\)))/.test(entry) && entry !== '0')
        .map(entry => `using ${entry}`),
    );
  }
  for (const [text] of code.matchAll(
    /\$[1-9]\d*|\b(?:column|strcol|stringcolumn)\(\s*(?!0\s*\))[^)]*\)|\b[xyz]tic\(\s*\d+\s*\)/g,
  ))
    found.push(text);
  return found;
}

// The entries of `using`: up to the first blank outside of brackets, parted by colons outside of them.
function entriesOf(text) {
  const entries = [''];
  let depth = 0;
  for (const c of text) {
    if (depth === 0 && /\s/.test(c) && entries.at(-1).trim()) break;
    if (c === '(' || c === '[') ++depth;
    if (c === ')' || c === ']') --depth;
    if (depth < 0) break;
    if (c === ':' && depth === 0) entries.push('');
    else entries[entries.length - 1] += c;
  }
  return entries.map(entry => entry.trim()).filter(Boolean);
}

const UNITS = [
  'pm',
  'nm',
  'µm',
  'mm',
  'cm',
  'm',
  'km',
  'AU',
  'ns',
  'µs',
  'ms',
  's',
  'min',
  'h',
  'Hz',
  'kHz',
  'm/s',
  'rad',
  'rad/s',
  '°',
  '%',
  'per cent',
  'seconds?',
  'minutes?',
  'years?',
  'metres?',
  'steps?',
  'turns?',
  'links?',
  'iterations?',
  'frames?',
  'evaluations?',
  'substeps?',
  'particles?',
  'times',
];
const MEASURED = new RegExp(`\\d{3}|\\d\\.\\d|\\d\\s?(?:${UNITS.join('|')})(?![\\wµ])`);
const LOOKED_UP = ['col', 'val', 'txt', 'file', 'style', 'number', 'exact', 'cell', 'canvas'];

// Every string with a number in it that the chapter's program should write: three digits, a decimal point, or a unit. What is
// looked up by its name may bear one, and so may a command for eval, and what stands at an axis, whose place ticks.test.mjs tests.
export function numbersInLabels(script) {
  return readScript(script)
    .strings.filter(
      ({ text, call, ticks }) =>
        !ticks && !LOOKED_UP.includes(call) && !/^(#[0-9a-f]{6}$|(un)?set |(left|right|center) offset )/.test(text),
    )
    .filter(({ text }) =>
      MEASURED.test(text.replace(/%[-+ 0#]*[\d.]*l*[a-zA-Z]/g, '').replace(/^Book Sans,\d+$|^,\d+$/, '')),
    )
    .map(({ text, line }) => ({ text, line }));
}
