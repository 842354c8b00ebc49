// Times of a step: those that the book was written with, and beside them this machine's, if nothing else ran while they were taken.
import { existsSync, readFileSync } from 'node:fs';
import { basename } from 'node:path';
import { numberHtml } from './numbers.mjs';
import { escapeHtml } from './text.mjs';

const MARK = /^time:(.+)$/;

// The file of a program that takes times: { processor, clock, compiler, date, others, of: name => { lower, median, upper } }, in ns.
export function readTimes(path) {
  const times = { of: new Map() };
  for (const line of readFileSync(path, 'utf8').split('\n')) {
    const [, word, said] = line.match(/^# (\w+): (.*)$/) ?? [];
    if (word) times[word] = said;
    const [, name, ...numbers] = line.match(/^([^#,]+),([\d.e+-]+),([\d.e+-]+),([\d.e+-]+)$/) ?? [];
    if (name) times.of.set(name, { lower: Number(numbers[0]), median: Number(numbers[1]), upper: Number(numbers[2]) });
  }
  return times;
}

// Pairs of files, { recorded, here }: what was recorded, and what this machine took, if it did.
export function readAllTimes(pairs = [], problems) {
  return pairs.flatMap(({ recorded, here }) => {
    if (existsSync(recorded))
      return [{ recorded: readTimes(recorded), here: existsSync(here) ? readTimes(here) : undefined }];
    problems.add(
      'code/measure/times.cpp',
      1,
      `there are no ${basename(recorded)}; build the target record_times on a quiet machine, or record_libraries of the preset peers`,
    );
    return [];
  });
}

// A twentieth of a processor is what a quiet system itself takes.
export const quiet = times => Number(times.others) < 0.05;

export const isTime = field => MARK.test(field);
const pairOf = (pairs, field) => pairs.find(({ recorded }) => recorded.of.has(field.match(MARK)[1]));

// `time:NAME` as the median, its quartiles, and this machine's.
export function timeHtml(pairs, field) {
  const [, name] = field.match(MARK);
  const { recorded, here } = pairOf(pairs, field) ?? {};
  if (!recorded) return 'not recorded';
  const time = recorded.of.get(name);
  const number = value => numberHtml(value, 2);
  const own = here && quiet(here) && here.of.get(name);
  return (
    `<span class="time" title="half of the runs between ${time.lower} and ${time.upper} ns">${number(time.median)}</span>` +
    (own
      ? ` <span class="here" title="here half of the runs between ${own.lower} and ${own.upper} ns">(${number(own.median)})</span>`
      : '')
  );
}

// What was recorded alone, where there is little room.
export function recordedHtml(pairs, field) {
  const [, name] = field.match(MARK);
  const { recorded } = pairOf(pairs, field) ?? {};
  return recorded ? numberHtml(recorded.of.get(name).median, 2) : '–';
}

const share = ({ others }) => `${Number((100 * others).toPrecision(2))}\u202f%`;

// What has to be known of the times in these fields; nothing if there are none.
export function aboutTimes(pairs, fields) {
  const pair = fields
    .filter(isTime)
    .map(field => pairOf(pairs, field))
    .find(Boolean);
  return pair ? `<p class="times">${escapeHtml(`${about(pair.recorded)} ${aboutHere(pair.here)}`.trim())}</p>` : '';
}

const about = ({ runs, processor, clock, compiler, date, ...times }) =>
  `Medians of ${runs} runs in turn, recorded on ${processor} at ${clock} with ${compiler}, ${date}, while other programs took ${share(times)} of a processor.`;

function aboutHere(here) {
  if (!here) return '';
  if (!quiet(here))
    return `The machine that this copy was built on was not quiet: other programs took ${share(here)} of a processor, so its times are not shown.`;
  return `In brackets: on the machine that this copy was built on, ${here.processor} at ${here.clock} with ${here.compiler}.`;
}
