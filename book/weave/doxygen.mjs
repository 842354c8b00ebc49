// Runs Doxygen over code/, and passes its complaints on.
import { spawnSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { join, relative } from 'node:path';
import { NAMESPACES } from './namespaces.mjs';
import { APOSTROPHE } from './xml.mjs';

const TEMPLATE = new URL('../Doxyfile.in', import.meta.url);

// For sed: each ' behind ///, from the last to the first.
const HIDE_APOSTROPHES = `:again\ns|\\(///.*\\)'|\\1${APOSTROPHE}|\nt again\n`;

// Returns the folder of Doxygen's XML; its complaints end up in book.problems. What a weaving before made of the same code is
// taken again.
export function runDoxygen(book) {
  const { source, work, doxygen } = book.config;
  const xml = join(work, 'xml');
  const code = join(source, 'code');
  const stamp = join(work, 'xml.sha256');
  mkdirSync(work, { recursive: true });
  const inputs = {
    'namespaces.dox': namespaceDocs(),
    'apostrophes.sed': HIDE_APOSTROPHES,
    'Doxyfile': readFileSync(TEMPLATE, 'utf8')
      .replace('@OUTPUT@', work)
      .replace('@SOURCE@', source)
      .replace('@FILTER@', join(work, 'apostrophes.sed'))
      .replace('@INPUT@', `"${join(work, 'namespaces.dox')}" "${code}"`),
  };
  const digest = digestOf([versionOf(doxygen), ...Object.values(inputs)], code);
  if (existsSync(stamp) && readFileSync(stamp, 'utf8') === digest) return xml;
  for (const old of [stamp, xml]) rmSync(old, { recursive: true, force: true });
  for (const [name, text] of Object.entries(inputs)) writeFileSync(join(work, name), text);
  const run = spawnSync(doxygen, [join(work, 'Doxyfile')], { encoding: 'utf8', cwd: work });
  if (run.error) book.problems.add('book/Doxyfile.in', 0, `cannot run ${doxygen}: ${run.error.message}`);
  else if (run.status !== 0) report(book, (run.stderr + run.stdout).replaceAll(APOSTROPHE, "'"));
  else writeFileSync(stamp, digest);
  return xml;
}

const versionOf = doxygen => spawnSync(doxygen, ['--version'], { encoding: 'utf8' }).stdout ?? '';

function digestOf(texts, folder) {
  const hash = createHash('sha256');
  for (const text of texts) hash.update(`${text}\0`);
  const headers = existsSync(folder)
    ? readdirSync(folder, { recursive: true }).filter(file => file.endsWith('.h'))
    : [];
  for (const file of headers.sort()) hash.update(`${file}\0`).update(readFileSync(join(folder, file)));
  return hash.digest('hex');
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
