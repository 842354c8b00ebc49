// Grades hostile and broken submissions of the corpus through the real grader, and prints
// one table:  node corpus.mjs GRADE ALONE EXERCISES BUILD few|others|all|PART-OF-A-NAME
// `few` are the first of either kind for each verdict, one that can have no other if there is any.
import { readFileSync } from 'node:fs';
import os from 'node:os';
import { join } from 'node:path';
import { items } from './items.mjs';
import { checker } from './one.mjs';

const [grade, alone, exercises, build, which] = process.argv.slice(2);
const { check, nextIsAccepted } = checker({ grade, alone, exercises, build });
const all = items(readFileSync(join(exercises, '2-euler/orbit-drift/solution.h'), 'utf8'));
const outcome = item => `${item.name.split('/')[0]} ${item.verdict.split('|')[0]}`;
const alternatives = item => item.verdict.split('|').length;
const lastToFirst = [...all].reverse().sort((a, b) => alternatives(b) - alternatives(a));
const firsts = new Map(lastToFirst.map(item => [outcome(item), item]));
const few = item => firsts.get(outcome(item)) === item;
const parts = { few, others: item => !few(item), all: () => true };
const waiting = all.filter(parts[which] ?? (item => item.name.includes(which)));
if (waiting.length === 0) throw new Error(`no item's name holds '${which}'`);

// After every few of them, and after the last, the right answer still has full marks.
const between = 8;
const done = [];
async function work() {
  for (let count = 1, item = waiting.shift(); item; item = waiting.shift(), ++count) {
    const checked = await check(item);
    if ((count % between === 0 || waiting.length === 0) && !(await nextIsAccepted()))
      checked.faults.push(`the next submission, after this or one of the ${between} before`);
    done.push(checked);
  }
}
await Promise.all(Array.from({ length: os.cpus().length }, work));

done.sort((a, b) => (a.name < b.name ? -1 : 1));
for (const { name, verdictFound, score, seconds, faults } of done) {
  const line = [name.padEnd(36), verdictFound.padEnd(15), score.padStart(5), `${seconds.toFixed(1)} s`.padStart(8)];
  console.log(line.join(' '), faults.length ? ` WRONG: ${faults.join(', ')}` : ' ok');
}
const bad = done.filter(item => item.faults.length > 0).length;
console.log(`${done.length} submissions, ${bad} not as they should be`);
process.exit(bad ? 1 : 0);
