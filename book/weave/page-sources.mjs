// What the compiler in the page is given of the book's sources.
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { pathsOf } from '../compiler/page/program-source.js';
import { isMark } from './snippets.mjs';

// Marks are for the weaver alone.
const withoutMarks = text =>
  text
    .split('\n')
    .filter(line => !isMark(line))
    .join('\n');

/** The text of a source as the page has it. */
export const sourceForPage = (source, path) => withoutMarks(readFileSync(join(source, path), 'utf8'));

// The programs of the films, and the headers that a reader's may include, for the compiler in the page.
function sourcesFor({ config: { source }, programs }) {
  const headers = ['code/integrate', 'code/shelf', 'code/scenes', 'chapters/play'].flatMap(folder =>
    readdirSync(join(source, folder))
      .filter(file => file.endsWith('.h'))
      .map(file => `${folder}/${file}`),
  );
  const films = [...programs.values()].flatMap(({ films }) => [...films.values()].map(film => film.source));
  const paths = ['chapters/play.h', ...headers, ...films].filter(path => existsSync(join(source, path)));
  return Object.fromEntries(paths.map(path => [path, sourceForPage(source, path)]));
}

const read = new WeakMap(); // of a book, once
function sourcesOf(book) {
  if (!read.has(book)) read.set(book, sourcesFor(book));
  return read.get(book);
}

/** Whether the compiler in the page has all that a program includes: it has no Eigen. */
export function isCompiledInPage(book, path) {
  const texts = sourcesOf(book);
  return pathsOf(texts, path).every(one => !texts[one].includes('#include <Eigen/'));
}

/** Of code behind which theme/edit.js puts "Try it"; none where the page can't compile the header. */
export const tryAttribute = (book, { file }) =>
  book.config.compiler && isCompiledInPage(book, file) ? ` data-try="${file}"` : '';

export const sourcesScript = book =>
  `Object.assign((globalThis.Compiled ??= {}), { sources: ${JSON.stringify(sourcesOf(book))} });\n`;

/** What all exercises are given: { file: text }. */
export function givenIn(source) {
  const harness = join(source, 'exercises/grader/harness');
  const headers = readdirSync(harness).filter(file => file.endsWith('.h'));
  return Object.fromEntries(headers.map(file => [file, readFileSync(join(harness, file), 'utf8')]));
}

// What the exercises begin with, and what they are given.
export function exercisesScript({ config: { source }, chapters }) {
  const read = path => readFileSync(join(source, path), 'utf8');
  const given = givenIn(source);
  const all = [...chapters.values()].flatMap(({ page }) => [...page.tasks.values()]);
  const tasks = all.map(({ exercise, folder }) => [
    exercise,
    { starter: read(`${folder}/starter.h`), harness: read(`${folder}/harness.h`) },
  ]);
  const exercises = { given, tasks: Object.fromEntries(tasks) };
  return `Object.assign((globalThis.Compiled ??= {}), { exercises: ${JSON.stringify(exercises)} });\n`;
}
