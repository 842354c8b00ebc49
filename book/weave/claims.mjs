// What the chapters' claim tests found, from Catch2's XML reports.
import { existsSync, readFileSync } from 'node:fs';
import { isAbsolute, relative, resolve } from 'node:path';
import * as cheerio from 'cheerio';

// Reads one chapter's report into test cases { name, file, line, passed, failures, command }. A compiler behind a cache may
// have been handed paths that begin with ../, from the folder that it was started in: `build`.
export function readClaims(path, { source, build, command }) {
  if (!existsSync(path))
    return {
      tests: [],
      fault: `there is no report of the claims at ${fromSource(source, path)}; build the chapter first`,
    };
  const text = readFileSync(path, 'utf8');
  if (!/<\/Catch2?TestRun>\s*$/.test(text)) {
    return {
      tests: [],
      fault: `the report of the claims ends in the middle: the claims program crashed; run ${command}`,
    };
  }
  const $ = cheerio.load(text, { xml: true });
  const named = e => $(e).attr('filename') ?? '';
  const file = e => fromSource(source, named(e).startsWith('../') ? resolve(build, named(e)) : named(e));
  const place = e => ({ file: file(e), line: Number($(e).attr('line') ?? 0) });
  const tests = $('TestCase')
    .get()
    .map(e => {
      const result = $(e).children('OverallResult');
      const passed = result.attr('success') === 'true' && !Number(result.attr('skips') ?? 0);
      const name = $(e).attr('name');
      return { name, ...place(e), passed, failures: failures($, e, place), command: `${command} ${quote(name)}` };
    });
  return { tests };
}

function failures($, test, place) {
  const found = $(test)
    .find('Expression[success="false"]')
    .get()
    .map(e => {
      const original = $(e).children('Original').text().trim(),
        expanded = $(e).children('Expanded').text().trim();
      const thrown = $(e).children('Exception').text().trim();
      return { ...place(e), what: `${original}${thrown ? ` threw: ${thrown}` : `, where ${expanded}`}` };
    });
  const others = $(test)
    .find('Failure, Skip, FatalErrorCondition, Exception')
    .get()
    .filter(e => e.parent.name !== 'Expression')
    .map(e => ({ ...place(e), what: `${e.name.toLowerCase()}: ${$(e).text().trim()}` }));
  return [...found, ...others];
}

export function fromSource(source, file) {
  return isAbsolute(file) ? relative(source, file) : file;
}

// As a shell and Catch2's own test filter want it: commas separate tests there and brackets name tags.
const quote = name => `"${name.replace(/[,[\]*\\]/g, '\\$&').replace(/["$`\\]/g, '\\$&')}"`;

export function failureText(test) {
  const where = test.failures.map(f => `\n    ${f.file}:${f.line}: ${f.what}`).join('');
  return `${where}\n    run it alone: ${test.command}`;
}
