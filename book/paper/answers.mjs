// The answers leave their tasks for an appendix; each task says on which page its answer is.
import { escapeHtml } from '../weave/text.mjs';

export const ANSWERS = 'answers';

// The HTML of the appendix.
export function takeAnswers(parts) {
  return parts
    .map(part => ({ part, answers: answersOf(part) }))
    .filter(({ answers }) => answers.length)
    .map(({ part, answers }) => `<h2>Chapter ${part.number}, ${escapeHtml(part.title)}</h2>\n${answers.join('\n')}`)
    .join('\n');
}

function answersOf({ $ }) {
  return $('.exercise:has(.answer)')
    .get()
    .map(exercise => {
      const task = $(exercise).attr('id');
      const at = `${ANSWERS}--${task}`;
      const html = $(exercise).find('.answer > div').html();
      const title = $(exercise).find('h3').html();
      $(exercise).find('.answer').replaceWith(`<p class="overleaf"><a href="#${at}" data-sheet="000">Answer</a></p>`);
      return `<section class="solved" id="${at}"><h3>${title}</h3>\n${html}\n<p class="overleaf"><a href="#${task}" data-sheet="000">Task</a></p></section>`;
    });
}
