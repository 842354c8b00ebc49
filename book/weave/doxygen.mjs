// Runs Doxygen over code/, and passes its complaints on.
import { spawnSync } from 'node:child_process';
import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join, relative } from 'node:path';
import { NAMESPACES } from './namespaces.mjs';
import { APOSTROPHE } from './xml.mjs';

const TEMPLATE = new URL('../Doxyfile.in', import.meta.url);

// For sed: each ' behind ///, from the last to the first.
const HIDE_APOSTROPHES = `:again\ns|\\(///.*\\)'|\\1${APOSTROPHE}|\nt again\n`;

// Returns the folder of Doxygen's XML; its complaints end up in book.problems.
export function runDoxygen(book) {
  const { source, work, doxygen } = book.config;
  const xml = join(work, 'xml');
  rmSync(xml, { recursive: true, force: true });
  mkdirSync(work, { recursive: true });
  const inputs = {
    'namespaces.dox': namespaceDocs(),
    'apostrophes.sed': HIDE_APOSTROPHES,
    'Doxyfile': readFileSync(TEMPLATE, 'utf8')
      .replace('@OUTPUT@', work)
      .replace('@SOURCE@', source)
      .replace('@FILTER@', join(work, 'apostrophes.sed'))
      .replace('@INPUT@', `"${join(work, 'namespaces.dox')}" "${join(source, 'code')}"`),
  };
  for (const [name, text] of Object.entries(inputs)) writeFileSync(join(work, name), text);
  const run = spawnSync(doxygen, [join(work, 'Doxyfile')], { encoding: 'utf8', cwd: work });
  if (run.error) book.problems.add('book/Doxyfile.in', 0, `cannot run ${doxygen}: ${run.error.message}`);
  else if (run.status !== 0) report(book, (run.stderr + run.stdout).replaceAll(APOSTROPHE, "'"));
  return xml;
}

const namespaceDocs = () => NAMESPACES.map(n => `/** @namespace ${n.name}\n * ${n.about}\n */\n`).join('');

function report(book, output) {
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
    last = { file: relative(book.config.source, found[1]), line: Number(found[2]), message: found[3] };
  }
  tell();
  if (book.problems.list.length === before)
    book.problems.add('book/Doxyfile.in', 0, `Doxygen failed: ${output.trim()}`);
}

function advise(message) {
  const name = message.match(/unable to resolve reference to '([^']*)'/)?.[1];
  if (name)
    return `a reference to nothing: \\ref ${name}; name something that is documented in code/, with its namespace`;
  if (/Unsupported xml\/html tag/.test(message))
    return `${message.replace(' found', '')}: write < as \\<, or put code into backticks`;
  return `Doxygen: ${message}`;
}
