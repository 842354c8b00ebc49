// A class of the real exercise, from the exercise's own right and wrong answers.
import {copyFileSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {basename, join} from 'node:path';
import {after} from 'node:test';

export function realClass(exercises) {
  const name = '2-euler/orbit-drift';
  const folder = mkdtempSync(join(tmpdir(), 'class-'));
  after(() => rmSync(folder, {recursive: true, force: true}));
  const source = join(exercises, name);
  const files = ['right', 'wrong'].flatMap(kind => readdirSync(join(source, kind)).map(file => join(source, kind, file)));
  for (const file of files) {
    const student = join(folder, 'submissions', basename(file, '.h'), '2-euler');
    mkdirSync(student, {recursive: true});
    copyFileSync(file, join(student, 'orbit-drift.h'));
  }
  return {
    name,
    folder,
    submissions: join(folder, 'submissions'),
    results: join(folder, 'results'),
    students: files.map(file => basename(file, '.h')).sort(),
    right: readdirSync(join(source, 'right')).map(file => basename(file, '.h')),
    report: student => JSON.parse(readFileSync(join(folder, 'results', student, name, 'report.json'), 'utf8')),
  };
}

// ctest takes this exit code for skipped.
export function skip(why) {
  console.log(`Skipped: ${why}`);
  process.exit(77);
}
