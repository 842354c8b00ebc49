// A report of the judges, as a page shows it.
import { element } from './element.js';
import { drawPlot } from './plot.js';

const paragraph = (text, className = '') => element('p', { className, textContent: text });

function failedView({ lines, plot }, room) {
  const list = element('dl');
  for (const { label, text } of lines)
    list.append(element('dt', { textContent: label }), element('dd', { textContent: text }));
  return plot ? [list, drawPlot(plot, room)] : [list];
}

function testView({ name, points, outcome, failed }, room) {
  const item = element('li', { className: outcome === 'held' ? 'held' : 'failed' });
  const worth = points === 1 ? '1 point' : `${points} points`;
  item.append(element('p', {}, element('b', { textContent: name }), ` ${outcome}, ${worth}`));
  if (failed) item.append(...failedView(failed, room));
  return item;
}

/** Shows it in `place`. */
export function showReport(place, { headline, sentence, why, tests }) {
  const list = element('ol', {}, ...tests.map(test => testView(test, place.parentElement.clientWidth - 20)));
  place.replaceChildren(paragraph(headline, 'headline'), paragraph(sentence));
  if (why) place.append(element('pre', { textContent: why }));
  place.append(list, paragraph('This is practice, with the inputs that everybody gets. A mark comes from grade.'));
}
