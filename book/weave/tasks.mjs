// The exercises that grade themselves: exercises/CHAPTER/NAME/task.md, shown where the chapter says \task{NAME}.
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { didYouMean, nameOneOf } from './problems.mjs';

const INTRODUCTION = 'grading.md';
const HEAD = ['Goal', 'Kind', 'Difficulty', 'Minutes'];
export const KINDS = {
  write: 'write it',
  bug: 'find the bug',
  stability: 'stability',
  cost: 'accuracy against cost',
  design: 'design',
};

// The chapter's source with each \task put in, and for each of its lines the file and the line that it came from.
// What holds for all of them stands before the first: exercises/grading.md.
export function putInTasks(source, { file, name, folder, problems }) {
  const there = tasksIn(join(folder, name));
  const text = [],
    places = [],
    tasks = new Map();
  const put = (line, from, number) => {
    text.push(line);
    places.push({ file: from, line: number });
  };
  const putIntroduction = number => {
    const path = join(folder, INTRODUCTION);
    if (!existsSync(path))
      return problems.add(file, number, `there is no exercises/${INTRODUCTION}; it says how the tasks are graded`);
    return readFileSync(path, 'utf8')
      .split('\n')
      .forEach((words, n) => put(words, `exercises/${INTRODUCTION}`, n + 1));
  };
  source.split('\n').forEach((line, i) => {
    const found = line.match(/^\\task\{([\w-]+)\}\s*$/);
    if (!found) return put(line, file, i + 1);
    const [, wanted] = found;
    if (!there.includes(wanted))
      return problems.add(file, i + 1, `there is no exercises/${name}/${wanted}/task.md.${nameOneOf(wanted, there)}`);
    const from = `exercises/${name}/${wanted}/task.md`;
    const task = readTask(readFileSync(join(folder, name, wanted, 'task.md'), 'utf8'), from, problems);
    tasks.set(wanted, { ...task, name: wanted, exercise: `${name}/${wanted}`, folder: `exercises/${name}/${wanted}` });
    if (tasks.size === 1) putIntroduction(i + 1);
    put(`\\exercise{${wanted}, ${task.title}}`, from, 1);
    task.lines.forEach((words, n) => put(words, from, task.from + n));
    return put('\\endexercise', from, task.from + task.lines.length - 1);
  });
  for (const one of there)
    if (!tasks.has(one))
      problems.add(
        `exercises/${name}/${one}/task.md`,
        1,
        `${file} does not show this exercise; write \\task{${one}} there`,
      );
  return { source: text.join('\n'), places, tasks };
}

const tasksIn = folder =>
  existsSync(folder)
    ? readdirSync(folder)
        .filter(one => existsSync(join(folder, one, 'task.md')))
        .sort()
    : [];

// "# Title", four lines of what it is, an empty line, and the task.
function readTask(text, file, problems) {
  const [first, ...lines] = text.replace(/\n+$/, '').split('\n');
  const title = first.match(/^# (.+)/)?.[1];
  if (!title) problems.add(file, 1, 'a task starts with its title; write "# Title" in the first line');
  const task = { title: title ?? '' };
  HEAD.forEach((word, i) => {
    const value = lines[i]?.match(new RegExp(`^${word}: (.+)`))?.[1];
    if (value) task[word.toLowerCase()] = value;
    else problems.add(file, i + 2, `line ${i + 2} of a task says "${word}: ..."`);
  });
  if (task.kind && !KINDS[task.kind])
    problems.add(
      file,
      3,
      `a task is of one of the kinds ${Object.keys(KINDS).join(', ')}, not "${task.kind}".${didYouMean(task.kind, Object.keys(KINDS))}`,
    );
  if (task.difficulty && !/^[123]$/.test(task.difficulty))
    problems.add(file, 4, 'the difficulty of a task is 1, 2 or 3');
  if (task.minutes && !/^\d+$/.test(task.minutes)) problems.add(file, 5, 'the minutes of a task are a whole number');
  return { ...task, lines: lines.slice(HEAD.length), from: HEAD.length + 2 };
}
