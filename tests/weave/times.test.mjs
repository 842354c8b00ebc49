// The table of times is made of Ninja's log, which has a line for each output and keeps those of older builds.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { lastBuildSeconds, readLog, summarise, edgesOf, table } from '../../book/weave/times.mjs';

const LOG = [
  '# ninja log v5',
  '0\t9000\t1\tchapters/2-euler/program.o\taaaa',
  '0\t9000\t1\t/build/chapters/2-euler/program.o\taaaa',
  '9000\t9500\t1\tchapters/2-euler/data/numbers.csv\tbbbb',
  '10\t4010\t2\tchapters/2-euler/program.o\tcccc',
  '10\t4010\t2\t/build/chapters/2-euler/program.o\tcccc',
  '4010\t4110\t2\tchapters/2-euler/figures/spiral.svg\tdddd',
  '4010\t4110\t2\tchapters/2-euler/figures/spiral-narrow.svg\tdddd',
  '4110\t7110\t2\tweave/book.stamp\teeee',
  '7110\t7160\t2\ttimes.txt\tffff',
  '',
].join('\n');
const entries = readLog(LOG, '/build');
const groups = Object.fromEntries(
  summarise(edgesOf(entries)).map(({ name, edges, seconds }) => [name, [edges, seconds]]),
);

test('an edge with two outputs counts once', () => assert.deepEqual(groups.figures, [1, 0.1]));
test('of an output built twice, the last time counts', () => assert.deepEqual(groups.compile, [1, 4]));
test('an edge that the last build left alone keeps its time', () => assert.deepEqual(groups['run programs'], [1, 0.5]));
test('the table itself does not count', () =>
  assert.deepEqual(Object.keys(groups), ['weave', 'figures', 'run programs', 'compile']));
test('the last build begins where the clock starts again', () => assert.equal(lastBuildSeconds(entries), 7.16));
test('in which folders the build lies says nothing of what an edge made', () => {
  const folder = '/home/reader/book/build',
    moved = readLog(LOG.replaceAll('/build/', `${folder}/`), folder);
  assert.deepEqual(summarise(edgesOf(moved)), summarise(edgesOf(entries)));
});
test('the table adds up', () => assert.match(table(entries), /^all of them +4 +7\.6$/m));
