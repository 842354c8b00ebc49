// What stands around the text of an exercise that grades itself: what it is for, its starter, and how to have it graded.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { codeLines } from './blocks.mjs';
import { highlightLines } from './highlight.mjs';
import { sourceHref } from './source-pages.mjs';
import { KINDS } from './tasks.mjs';
import { escapeHtml, smarten } from './text.mjs';

const GIVEN = 'exercises/grader/harness/given.h';

export function levelHtml(difficulty) {
  const words = ['', 'easy', 'takes some thought', 'hard'][difficulty];
  return `<span class="difficulty" role="img" aria-label="Difficulty ${difficulty} of 3: ${words}">${'●'.repeat(difficulty)}${'○'.repeat(3 - difficulty)}</span>`;
}

export function taskHead({ goal, kind, difficulty, minutes }) {
  return (
    `<p class="task">${levelHtml(difficulty)} ` +
    `<span>${KINDS[kind]}</span> <span>${minutes} minutes</span> <span>graded</span></p>\n` +
    `<p class="goal"><b>Goal.</b> ${escapeHtml(smarten(goal))}</p>\n`
  );
}

export function taskFoot({ book, hold }, { name, exercise, folder }) {
  const starter = `${folder}/starter.h`;
  const code = readFileSync(join(book.config.source, starter), 'utf8').replace(/\n+$/, '');
  const lines = highlightLines(code, 'h');
  const commands = `build/exercises/grade start ${name}\nbuild/exercises/grade ${name}.h`;
  return (
    `<details class="starter"${book.config.judges ? ` data-exercise="${exercise}"` : ''}><summary>The starter</summary><div><figure class="listing"><figcaption><span class="head"></span>` +
    `<a class="file" href="${sourceHref(starter)}">${escapeHtml(starter).replace(/\//g, '/<wbr>')}</a></figcaption>` +
    `<pre><code>${hold(
      codeLines(
        lines,
        lines.map((_, i) => i + 1),
      ),
    )}</code></pre></figure></div></details>\n` +
    `<div class="codebox terminal"><pre><code>${hold(highlightLines(commands, 'sh').join('\n'))}</code></pre></div>\n` +
    (book.sources.has(GIVEN)
      ? `<p class="sources">What you are given: <a href="${sourceHref(GIVEN)}">given.h</a></p>`
      : '')
  );
}
