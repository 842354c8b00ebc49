// Times of a step: those that the book was written with, and beside them this machine's, if nothing else ran while they were taken.
import { existsSync, readFileSync } from 'node:fs';
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

// Both files; { } where a book has no times.
export function readAllTimes({ recorded, here } = {}, problems) {
  if (!recorded) return {};
  if (!existsSync(recorded)) {
    problems.add('chapters/times.csv', 1, 'there are no recorded times; build the target record_times on a quiet machine');
    return {};
  }
  return { recorded: readTimes(recorded), here: existsSync(here) ? readTimes(here) : undefined };
}

// A twentieth of a processor is what a quiet system itself takes.
const quiet = times => Number(times.others) < 0.05;

export const isTime = field => MARK.test(field);
export const holdsTimes = rows => rows.some(row => row.some(isTime));

// `time:NAME` as the median, its quartiles, and this machine's.
export function timeHtml({ recorded, here }, field) {
  const [, name] = field.match(MARK);
  const time = recorded?.of.get(name);
  if (!time) return 'not recorded';
  const number = value => numberHtml(value, 2);
  const own = here && quiet(here) && here.of.get(name);
  return `<span class="time" title="half of the runs between ${time.lower} and ${time.upper} ns">${number(time.median)}</span>`
    + (own ? ` <span class="here" title="here half of the runs between ${own.lower} and ${own.upper} ns">(${number(own.median)})</span>` : '');
}

const share = ({ others }) => `${Number((100 * others).toPrecision(2))}\u202f%`;

// What has to be known of them.
export function aboutTimes({ recorded, here }) {
  if (!recorded) return '';
  const taken = `Medians of 31 runs in turn, recorded on ${recorded.processor} at ${recorded.clock} with ${recorded.compiler}, `
    + `${recorded.date}, while other programs took ${share(recorded)} of a processor.`;
  if (!here) return `<p class="times">${escapeHtml(taken)}</p>`;
  const own = quiet(here)
    ? `In brackets: on the machine that this copy was built on, ${escapeHtml(here.processor)} at ${escapeHtml(here.clock)} with ${escapeHtml(here.compiler)}.`
    : `The machine that this copy was built on was not quiet: other programs took ${share(here)} of a processor, so its times are not shown.`;
  return `<p class="times">${escapeHtml(taken)} ${own}</p>`;
}
