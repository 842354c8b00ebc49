// Pieces of compiled files, cut between two `// [tag]` lines.
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { didYouMean } from './problems.mjs';

const MARKER = /^\s*\/\/ \[([\w-]+)\]\s*$/;
export const isMark = line => MARKER.test(line);

const DOC = /^\s*\/\/\/(?!<)/;

// Reads `path` once; returns a function that cuts a tag out of it, or several as `one + other`, or says what is wrong with it.
export function createSnippets(source, sources) {
  const files = new Map();
  return (path, tags) => {
    if (!files.has(path)) files.set(path, readTagged(join(source, path)));
    const file = files.get(path);
    if (!file)
      return {
        fault: `there is no file ${path}; paths start at the top of the repository.${didYouMean(path, sources)}`,
      };
    const pieces = tags.split(' + ').map(tag => piece(path, file, tag));
    return pieces.find(({ fault }) => fault) ?? { lines: unindented(pieces.flatMap(({ lines }) => lines)) };
  };
}

function piece(path, file, tag) {
  const at = file.tags.get(tag);
  if (!at) return { fault: `${path} has no tag "${tag}".${didYouMean(tag, file.tags.keys()) || noTag(tag)}` };
  if (at.length !== 2)
    return { fault: `tag "${tag}" stands ${times(at, path)}; it must stand twice, before and after the lines to show` };
  const found = cut(file.lines, at);
  return found.length
    ? { lines: found }
    : {
        fault: `nothing but documentation stands between the two tags of "${tag}" in ${path} (lines ${at.join(' and ')})`,
      };
}

const times = (at, path) =>
  at.length === 1 ? `once in ${path} (line ${at[0]})` : `${at.length} times in ${path} (lines ${at.join(', ')})`;
const noTag = tag => ` Put a line "// [${tag}]" before and after the lines to show.`;

function readTagged(path) {
  if (!existsSync(path)) return null;
  return taggedLines(readFileSync(path, 'utf8'));
}

function taggedLines(text) {
  const lines = text.split('\n');
  const tags = new Map();
  lines.forEach((line, i) => {
    const tag = line.match(MARKER)?.[1];
    if (tag) tags.set(tag, [...(tags.get(tag) ?? []), i + 1]);
  });
  return { lines, tags };
}

/** The lines between the two marks of a tag, from a text that is no file. */
export function cutTag(text, tag) {
  const { lines, tags } = taggedLines(text);
  return unindented(cut(lines, tags.get(tag))).map(line => line.text);
}

function cut(lines, [first, last]) {
  const kept = lines
    .slice(first, last - 1)
    .map((text, i) => ({ text: text.replace(/\s+$/, ''), number: first + 1 + i }))
    .filter(({ text }) => !MARKER.test(text) && !DOC.test(text))
    .map(({ text, number }) => ({ text: text.replace('///<', '//'), number }));
  while (kept.length && !kept[0].text) kept.shift();
  while (kept.length && !kept.at(-1).text) kept.pop();
  return kept;
}

function unindented(lines) {
  const indent = Math.min(...lines.filter(l => l.text).map(l => l.text.match(/^ */)[0].length));
  return lines.map(l => ({ ...l, text: l.text.slice(indent) }));
}
