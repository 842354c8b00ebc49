// The live figures of the built book, each with the page that shows it.
import { readFigures } from '../../book/live/cases.mjs';
import { pages, read } from './book.mjs';

export const figures = readFigures().map(figure => ({
  ...figure,
  page: pages.find(page => read(page).includes(` data-live="${figure.name}"`)),
}));

// Of figures of one kind, which share all but the method, the first.
export const firstOfEachKind = figures.filter(
  ({ kind }, i) => !kind || figures.findIndex(one => one.kind === kind) === i,
);
