// The page that lists every exercise of the book, by chapters. Who did one may tick it off; the page remembers.
import { levelHtml } from './task-box.mjs';
import { KINDS } from './tasks.mjs';
import { escapeHtml, smarten } from './text.mjs';

const HEAD =
  '<thead><tr><th scope="col">Exercise</th><th scope="col">Kind</th><th scope="col">Level</th><th scope="col">Minutes</th><th scope="col" class="tick" hidden>Done</th></tr></thead>';

export function exercisesPage(book) {
  const chapters = [...book.chapters.values()].map(chapter => ({ ...chapter, exercises: exercisesOf(chapter.page) }));
  const all = chapters.flatMap(({ exercises }) => exercises);
  const graded = all.filter(({ task }) => task);
  const minutes = graded.reduce((sum, { task }) => sum + Number(task.minutes), 0);
  const lead =
    `<p class="lead">All ${all.length} exercises. ${graded.length} of them are judged, on their own page or by a program that comes with the book, and take some ${Math.round(minutes / 60)} hours; ` +
    `the others have hints and answers to fold out.</p>\n`;
  return {
    href: 'exercises.html',
    title: 'Exercises',
    kind: 'exercises',
    body: lead + chapters.map(section).join('\n'),
    sections: chapters.map(({ name, title }) => ({ id: name, title })),
  };
}

const exercisesOf = page =>
  page.pieces
    .filter(({ type, name }) => type === 'open' && name === 'exercise')
    .map(({ id, number, args: [name, title] }) => ({
      id,
      number,
      title,
      href: `${page.href}#${id}`,
      task: page.tasks.get(name),
    }));

const section = ({ name, number, title, exercises }) =>
  `<h2 id="${name}"><span class="secno">${number}</span> ${escapeHtml(smarten(title))}</h2>\n` +
  `<table class="tasks">${HEAD}<tbody>\n${exercises.map(row).join('\n')}\n</tbody></table>`;

function row({ id, number, title, href, task }) {
  const words = escapeHtml(smarten(title));
  const cells = task
    ? [KINDS[task.kind], levelHtml(task.difficulty), task.minutes].map(html => `<td>${html}</td>`)
    : ['<td colspan="3">by yourself, with an answer</td>'];
  return (
    `<tr><th scope="row"><a href="${href}"><span class="secno">${number}</span> ${words}</a></th>${cells.join('')}` +
    `<td class="tick" hidden><input type="checkbox" name="${id}" aria-label="Done: ${words}"></td></tr>`
  );
}
