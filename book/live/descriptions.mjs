// The descriptions of the live figures: chapters/*/live/NAME.json, with the control by which a reader makes the mistakes that one lists.
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const MUTANTS = new URL('../../tests/mutants/', import.meta.url);

/**
 * The edit of a header that makes a mistake, "euler/position-with-new-velocity": its file, its header, and what the reader reads:
 * what is done, and why it does what it does.
 */
export function readMistake(name) {
  const file = fileURLToPath(new URL(`${name}.txt`, MUTANTS));
  if (!existsSync(file)) throw new Error(`there is no mistake "${name}": tests/mutants has no such edit`);
  const head = readFileSync(file, 'utf8').split('\n\n')[0].split('\n');
  const words = head.find(line => !/^\w+: /.test(line));
  const said = key => head.find(line => line.startsWith(`${key}: `))?.slice(key.length + 2);
  if (!words) throw new Error(`tests/mutants/${name}.txt does not say in words what it does`);
  return {
    name,
    file,
    header: name.split('/')[0],
    type: said('Method'),
    words,
    why: said('Why'),
  };
}

/** A description with its control "own", where it lists mistakes. */
export function withMistakes({ mistakes = [], ...description }) {
  if (!mistakes.length) return { controls: [], ...description };
  const of = mistakes.map(readMistake);
  const own = {
    name: 'own',
    label: 'Change it',
    choices: { none: 'As it is', ...Object.fromEntries(of.map(({ name, words }) => [name, words])) },
    why: Object.fromEntries(of.map(({ name, why }) => [name, why])),
    start: 'none',
    chips: true,
  };
  return { ...description, controls: [...description.controls, own] };
}

/** [{ name, folder, ... }] of all figures under a folder of chapters. */
export function readDescriptions(chapters) {
  const folders = readdirSync(chapters)
    .sort()
    .map(chapter => new URL(`${chapter}/live/`, chapters))
    .filter(folder => existsSync(folder));
  return folders.flatMap(folder =>
    readdirSync(folder)
      .filter(file => file.endsWith('.json'))
      .sort()
      .map(file => ({
        name: file.slice(0, -5),
        ...withMistakes(JSON.parse(readFileSync(new URL(file, folder), 'utf8'))),
      })),
  );
}
