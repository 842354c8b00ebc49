// Runs Doxygen over the prepared pages and code/, and tells its complaints in terms of the chapters.
import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { spawnSync } from 'node:child_process';
import { join, relative } from 'node:path';
import { doxygenLabel } from './prose.mjs';
import { NAMESPACES } from './namespaces.mjs';
import { APOSTROPHE } from './xml.mjs';

const TEMPLATE = new URL('../Doxyfile.in', import.meta.url);

// For sed: each ' behind ///, from the last to the first.
const HIDE_APOSTROPHES = `:again\ns|\\(///.*\\)'|\\1${APOSTROPHE}|\nt again\n`;

// Returns the folder of Doxygen's XML; its complaints end up in book.problems.
export function runDoxygen(book) {
  const { source, work, doxygen } = book.config;
  const pages = join(work, 'pages');
  const xml = join(work, 'xml');
  for (const folder of [pages, xml]) rmSync(folder, { recursive: true, force: true });
  mkdirSync(pages, { recursive: true });
  const byFile = new Map();
  for (const page of book.pages) {
    const path = join(pages, `${doxygenLabel(page)}.md`);
    byFile.set(path, page);
    writeFileSync(path, page.doxygenText);
  }
  writeFileSync(join(pages, 'namespaces.dox'), namespaceDocs());
  const filter = join(work, 'apostrophes.sed');
  writeFileSync(filter, HIDE_APOSTROPHES);
  const doxyfile = readFileSync(TEMPLATE, 'utf8')
    .replace('@OUTPUT@', work)
    .replace('@SOURCE@', source)
    .replace('@FILTER@', filter)
    .replace('@INPUT@', `"${pages}" "${join(source, 'code')}"`);
  writeFileSync(join(work, 'Doxyfile'), doxyfile);
  const run = spawnSync(doxygen, [join(work, 'Doxyfile')], { encoding: 'utf8', cwd: work });
  if (run.error) book.problems.add('book/Doxyfile.in', 0, `cannot run ${doxygen}: ${run.error.message}`);
  else if (run.status !== 0) report(book, byFile, (run.stderr + run.stdout).replaceAll(APOSTROPHE, "'"));
  return xml;
}

const namespaceDocs = () => NAMESPACES.map(n => `/** @namespace ${n.name}\n * ${n.about}\n */\n`).join('');

function report(book, byFile, output) {
  const before = book.problems.list.length;
  let last = null;
  const tell = () => last && book.problems.add(last.file, last.line, advise(last.message));
  for (const text of output.split('\n').filter(line => line.trim())) {
    const found = text.match(/^(.+?):(\d+): (?:error|warning): (.*?)(?: \(warning treated as error, aborting now\))?$/);
    if (!found) {
      if (last && /^\s/.test(text)) last.message += ` ${text.trim()}`;
      continue;
    }
    tell();
    last = { ...place(book, byFile, found[1], Number(found[2])), message: found[3] };
  }
  tell();
  if (book.problems.list.length === before)
    book.problems.add('book/Doxyfile.in', 0, `Doxygen failed: ${output.trim()}`);
}

function place(book, byFile, path, line) {
  const page = byFile.get(path);
  if (!page) return { file: relative(book.config.source, path), line };
  return { file: page.file, line: page.lineMap[Math.min(line, page.lineMap.length) - 1] };
}

function advise(message) {
  const name = message.match(/unable to resolve reference to '([^']*)'/)?.[1];
  if (name)
    return `a reference to nothing: \\ref ${name}; name something that is documented in code/, with its namespace`;
  if (/Unsupported xml\/html tag/.test(message))
    return `${message.replace(' found', '')}: write < as \\<, or put code into backticks`;
  return `Doxygen: ${message}`;
}
