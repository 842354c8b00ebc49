// Words that set a live figure: \set{drone-spiral?rate=15, 15}.
import { escapeHtml, smarten } from './text.mjs';
import { didYouMean, nameOneOf } from './problems.mjs';

// What the words set has to be there: the figure, on the same page, and its controls with such values.
export function checkSet({ book, page, piece, report }) {
  const [, figure, query] = piece.args[0].match(/^([\w-]+)\?(.+)$/) ?? [];
  if (!figure) {
    report('\\set{...} names a live figure and what is set in it: \\set{drone-spiral?rate=15, fifteen}');
    return;
  }
  const own = [...book.live.values()].filter(({ name }) => book.labels.get(`figure:${name}`)?.page === page);
  const live = own.find(({ name }) => name === figure);
  if (!live) {
    report(
      `there is no live figure "${figure}" on this page.${nameOneOf(
        figure,
        own.map(({ name }) => name),
      )}`,
    );
    return;
  }
  piece.target = book.labels.get(`figure:${figure}`);
  piece.query = query;
  const settable = [...live.controls, ...axesOf(live.handle)];
  for (const [name, value] of new URLSearchParams(query)) {
    const control = settable.find(one => one.name === name);
    if (!control) {
      report(
        `the live figure "${figure}" has no control "${name}".${nameOneOf(
          name,
          settable.map(one => one.name),
        )}`,
      );
    } else checkValue(control, value, report);
  }
}

// What is dragged in the picture can be set by words, too.
const axesOf = handle =>
  [handle?.x, handle?.y].filter(axis => axis?.set).map(({ set, from, to }) => ({ name: set, from, to }));

// A choice by its key; a number in seconds and the like, as a link to settings has it.
function checkValue({ name, choices, values, from, to, scale = 1 }, value, report) {
  if (choices) {
    if (!(value in choices)) report(`"${value}" is no choice of "${name}".${didYouMean(value, Object.keys(choices))}`);
    return;
  }
  const shown = Number(value) / scale;
  const near = (a, b) => Math.abs(a - b) <= 1e-9 * Math.abs(b);
  const known = values ? values.some(one => near(shown, one)) : shown >= from && shown <= to;
  if (!known)
    report(
      `"${name}" cannot be ${value}: it goes ${values ? `by ${values.map(v => v * scale).join(', ')}` : `from ${from * scale} to ${to * scale}`}`,
    );
}

export const setHtml = ({ target, query, args: [, words] }) =>
  `<a class="set" href="#${target.piece.id}" data-set="${escapeHtml(query)}">${escapeHtml(smarten(words))}</a>`;
