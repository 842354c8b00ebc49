// A report of the judges, as a page shows it: what is wrong before with what it was tried.
import { element } from './element.js';
import { drawPlot } from './plot.js';

// In this order; all others stand between the two lists.
const FIRST = ['Diagnosis', 'Hint', 'Asked', 'Expected', 'Got'];
const LAST = ['Allowed', 'Input'];

const rankOf = ({ label }) => {
  if (FIRST.includes(label)) return FIRST.indexOf(label);
  return FIRST.length + 1 + LAST.indexOf(label);
};

const paragraph = (text, className = '') => element('p', { className, textContent: text });

function failedView({ lines, plot }, room) {
  const list = element('dl');
  for (const { label, text } of [...lines].sort((one, other) => rankOf(one) - rankOf(other)))
    list.append(element('dt', { textContent: label }), element('dd', { textContent: text }));
  return plot ? [list, drawPlot(plot, room)] : [list];
}

// Of the tests that failed the first is shown, and others fold out: mostly it is the same mistake.
function testView({ name, points, outcome, failed }, isFirst, room) {
  const item = element('li', { className: outcome === 'held' ? 'held' : 'failed' });
  const worth = points === 1 ? '1 point' : `${points} points`;
  item.append(element('p', {}, element('b', { textContent: name }), ` ${outcome}, ${worth}`));
  if (!failed) return item;
  const fold = element('details', { open: isFirst }, element('summary', { textContent: 'What came' }));
  fold.append(...failedView(failed, room));
  item.append(fold);
  return item;
}

/** Shows it in `place`. */
export function showReport(place, { headline, sentence, why, tests }) {
  const room = place.parentElement.clientWidth - 20;
  const first = tests.find(({ failed }) => failed);
  const list = element('ol', {}, ...tests.map(test => testView(test, test === first, room)));
  place.replaceChildren(paragraph(headline, 'headline'), paragraph(sentence));
  if (why) place.append(element('pre', { textContent: why }));
  place.append(
    list,
    paragraph('This is practice, with inputs that stay the same. A mark comes from the program grade.'),
  );
}
