// A solution that answers NaN: each number that one of its functions answers, in a reference or by return, replaced in turn.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';

function parametersOf(list) {
  let depth = 0;
  const parts = [''];
  for (const c of list.replace(/\s+/g, ' ')) {
    depth += '(<'.includes(c) - '>)'.includes(c);
    if (c === ',' && depth === 0) parts.push('');
    else parts[parts.length - 1] += c;
  }
  return parts.map((part, i) => {
    const [, type, name] = part.trim().match(/^(.*[&\s>])(?!Vec$|double$|int$|Acceleration$)(\w+)$/) ?? [];
    return name ? { type: type.trim(), name } : { type: part.trim(), name: `p${i}` };
  });
}

// What spoils a value; nothing for those that can't hold a NaN.
function spoil(type, name) {
  const [, element] = type.match(/^std::vector<(\w+)>/) ?? [];
  if (element) return `if (!${name}.empty()) { ${spoil(element, `${name}.back()`)} }`;
  if (/^Vec\b/.test(type)) return `${name}.y = NAN;`;
  return /^double\b/.test(type) ? `${name} = NAN;` : '';
}

// The solution with one function's answers spoilt, one after the other.
export function spoilt(exercise, source) {
  const read = name => readFileSync(join(source, 'exercises', exercise, name), 'utf8');
  const whole = read('solution.h');
  const solution = whole.replace(/^#.*$/gm, '');
  const harness = read('harness.h');
  const head = [
    ...whole.match(/^#.*$/gm),
    `namespace right {\n${solution}\n}`,
    ...harness.matchAll(/^using \w+ = .*;$/gm),
    ...[...solution.matchAll(/^(?:struct|using) (\w+)/gm)].map(([, name]) => `using right::${name};`),
  ].join('\n');
  const wanted = [...harness.matchAll(/harness::Wanted<\s*(\S+?)\s*\(([^;]*)\)>\s*wanted\w*\s*=\s*(\w+);/g)];
  return wanted.flatMap(([, result, list, name]) => {
    const others = wanted.filter(other => other[3] !== name).map(other => `using right::${other[3]};`);
    const parameters = parametersOf(list);
    const call = `right::${name}(${parameters.map(one => one.name).join(', ')})`;
    const all = parameters.filter(({ type }) => /&$/.test(type) && !/^const\b/.test(type));
    if (result !== 'void') all.push({ type: result, name: 'answer_' });
    return all
      .map(one => ({ what: `${name}: ${one.name}`, line: spoil(one.type, one.name) }))
      .filter(({ line }) => line)
      .map(({ what, line }) => ({
        what,
        text: `${head}
${others.join('\n')}
inline ${result} ${name}(${parameters.map(one => `${one.type} ${one.name}`).join(', ')}) {
  ${result === 'void' ? call : `${result} answer_ = ${call}`};
  ${line}
  ${result === 'void' ? '' : 'return answer_;'}
}
`,
      }));
  });
}
