// Tries to have full marks by pasting: every function body and every returned expression of the book's headers, of the
// exercise's chapter, of its own judge, helpers and harness, and calls of the headers, in place of one function of the
// solution, with the other functions right. A function that none of them answers has to be written.
import { spawnSync } from 'node:child_process';
import { readFileSync, readdirSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { graded, verdicts } from './driver.mjs';

const limits = '10,30,1,3';

const bare = text => text.replace(/\/\*[\s\S]*?\*\/|\/\/.*$/gm, '');

// Where the bracket that opens at `at` closes, or, with -1, where the one that closes there opens.
function partner(text, at, step = 1) {
  const pairs = { '(': ')', '{': '}', ')': '(', '}': '{' };
  for (let i = at, depth = 0; i >= 0 && i < text.length; i += step) {
    if (text[i] === text[at]) ++depth;
    if (text[i] === pairs[text[at]] && --depth === 0) return i;
  }
  return -1;
}

function parametersOf(list) {
  let depth = 0;
  const parts = [''];
  for (const c of list) {
    if ('(<[{'.includes(c)) ++depth;
    if (')>]}'.includes(c)) --depth;
    if (c === ',' && depth === 0) parts.push('');
    else parts[parts.length - 1] += c;
  }
  return parts.filter(part => part.trim()).map(part => part.replace(/=.*$/s, '').match(/(\w+)\s*$/)?.[1] ?? '');
}

// The functions and lambdas with a body in this text, and the bodies that each returned expression would make.
export function bodies(text) {
  const found = [];
  const source = bare(text);
  for (const { 0: head, index } of source.matchAll(/\)\s*(?:const|noexcept|mutable|->\s*[\w:<>]+|\s)*\{/g)) {
    const open = partner(source, index, -1);
    const begin = index + head.length - 1;
    const end = partner(source, begin);
    const name = source.slice(0, open).match(/(\w+|\])\s*$/)?.[1];
    if (open < 0 || end < 0 || !name || /^(if|for|while|switch|catch)$/.test(name)) continue;
    found.push({
      name,
      begin,
      end,
      parameters: parametersOf(source.slice(open + 1, index)),
      body: source.slice(begin, end + 1),
    });
  }
  for (const [, expression] of source.matchAll(/\breturn\s+([^;{}]+);/g))
    found.push({ name: 'return', parameters: null, body: `{ return ${expression}; }` });
  return found;
}

function renamed(body, from, to) {
  const names = new Map(from.map((name, i) => [name, to[i]]));
  return body.replace(/\b[A-Za-z_]\w*\b/g, word => names.get(word) ?? word);
}

// A header of the book with those that it includes, as one would paste it above one's own function.
function whole(root, path, seen = new Set()) {
  if (seen.has(path)) return '';
  seen.add(path);
  const own = bare(readFileSync(join(root, path), 'utf8'));
  return own.replace(/^#pragma once$/gm, '').replace(/^#include "(.*)"$/gm, (_, other) => whole(root, other, seen));
}

// Calls of the functions that a header has, with the starter's parameters in their order.
function callsOf(root, path, parameters) {
  const text = bare(readFileSync(join(root, path), 'utf8'));
  const space = text.match(/^namespace (\w+)/m)?.[1];
  if (!space) return [];
  const names = new Set(
    bodies(text)
      .map(one => one.name)
      .filter(name => /^[a-z]\w*$/.test(name) && name !== 'return'),
  );
  return [...names].flatMap(name => {
    const call = `${space}::${name}(${parameters.join(', ')});`;
    return [`{ ${call} }`, `{ return ${call} }`].map(body => ({ from: `code/${path}`, above: [path], body }));
  });
}

// What might stand in place of a function with these parameters.
function candidatesFor(parameters, sources) {
  const all = new Map();
  for (const { from, text } of sources) {
    for (const { parameters: theirs, body } of bodies(text)) {
      const ways = [body];
      if (theirs?.length === parameters.length) ways.push(renamed(body, theirs, parameters));
      for (const way of ways) {
        const key = way.replace(/\s+/g, '');
        if (key !== '{}' && !all.has(key)) all.set(key, { from, body: way });
      }
    }
  }
  return [...all.values()];
}

// clang++ says which compile. g++ looks a millisecond long for what each unknown name was meant to be, and after thousands of
// errors it stops, so that what comes behind would seem to compile.
const compiler = 'clang++-19';
const flags = ['-ferror-limit=0', '-fno-spell-checking', '-fno-caret-diagnostics'];

// All in one go, each in a file of its own name, so that each error tells whose it is.
function notRefused(candidates, { source, headers }) {
  const parts = candidates.map(({ text }, i) => {
    const only = text.replace(/^#.*$/gm, '');
    return `namespace c${i} {\n#line 1 "c${i}"\n${only}\n}`;
  });
  const included = headers.map(path => `#include "${path}"`).join('\n');
  const folders = ['exercises/grader/harness', 'code'].map(path => `-I${join(source, path)}`);
  const common = ['-std=c++20', '-fsyntax-only', '-w', '-fdiagnostics-color=never', '-DGRADING', ...folders];
  const { status, stderr } = spawnSync(compiler, [...common, ...flags, '-xc++', '-'], {
    input: `#include "given.h"\n#include <complex>\n${included}\n${parts.join('\n')}\n`,
    encoding: 'utf8',
    maxBuffer: 1 << 28,
    timeout: 120000,
  });
  if (status === null) throw new Error(`nothing can be tried: ${compiler} does not come to its end`);
  const ours = stderr.match(/^(?!c\d+:)\S+:\d+:\d+: fatal error.*$/m);
  if (ours) throw new Error(`nothing can be tried: ${ours[0]}`);
  const bad = new Set([...stderr.matchAll(/^c(\d+):\d+:\d+: (?:fatal )?error/gm)].map(([, i]) => Number(i)));
  return candidates.filter((_, i) => !bad.has(i));
}

// The solution goes with them: if that is refused, so would be what is right.
function thatCompile(solution, candidates, context) {
  const own = { text: solution };
  const good = notRefused([own, ...candidates], context);
  if (good[0] !== own) throw new Error('nothing can be tried: the solution does not compile');
  return good.slice(1);
}

function filesFor(exercise, source) {
  const chapter = dirname(exercise);
  const list = (at, pattern) =>
    readdirSync(join(source, at))
      .filter(name => pattern.test(name))
      .map(name => join(at, name));
  return [
    ...['code/integrate', 'code/shelf', 'code/scenes'].flatMap(at => list(at, /\.h$/)),
    ...list(`chapters/${chapter}`, /\.(h|cpp)$/),
    ...[`exercises/${chapter}`, `exercises/${exercise}`, 'exercises/grader/judge']
      .flatMap(at => list(at, /\.(h|cpp)$/))
      .filter(name => !/(solution|starter)\.h$/.test(name)),
  ];
}

// Of each function that an exercise asks for, where the texts lie that answer it when they are pasted.
export function pasted(exercise, { source, grade }) {
  const read = path => readFileSync(join(source, path), 'utf8');
  const code = join(source, 'code');
  const sources = filesFor(exercise, source).map(from => ({ from, text: read(from) }));
  const headers = sources
    .filter(({ text }) => !/#include <Eigen/.test(text)) // which a submission has not
    .map(({ from }) => from.match(/^code\/((?:integrate|shelf)\/.*)/)?.[1])
    .filter(Boolean);
  const solution = bare(read(`exercises/${exercise}/solution.h`));
  const names = [...read(`exercises/${exercise}/harness.h`).matchAll(/\bwanted\w*\s*=\s*(\w+)/g)].map(
    ([, name]) => name,
  );
  // What would stand in a submission, beside the other functions, in place of the one of this name.
  const inPlaceOf = name => {
    const own = bodies(solution).findLast(one => one.name === name);
    const candidates = [
      ...candidatesFor(own.parameters, sources),
      ...headers.flatMap(path => callsOf(code, path, own.parameters)),
    ];
    return candidates.map(({ from, above = [], body }) => {
      const text = solution.slice(0, own.begin) + body + solution.slice(own.end + 1);
      return { name, from, above, text };
    });
  };
  const good = thatCompile(solution, names.flatMap(inPlaceOf), { source, headers });
  const texts = good.map(({ text, above }) => [...above.map(path => whole(code, path)), text].join('\n'));
  const found = verdicts(exercise, texts, { source, grade, limits });
  const isRight = text => graded(exercise, text, { grade, limits }).status === 0;
  const answers = good.filter((_, i) => found[i].full && isRight(texts[i]));
  return names.map(name => ({
    name,
    tried: good.filter(one => one.name === name).length,
    from: [...new Set(answers.filter(one => one.name === name).map(({ from }) => from))],
  }));
}
