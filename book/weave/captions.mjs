// The captions of the figures, and those of them that nothing binds to a run.
const PROVED = ['number', 'claim', 'look'];

export const captions = book =>
  book.pages.flatMap(page =>
    page.pieces
      .filter(piece => piece.type === 'open' && piece.name === 'figure' && piece.closed && !piece.incomplete)
      .map(piece => ({ page, piece })),
  );

// A number may stand within a formula.
export const bareCaptions = book =>
  captions(book).filter(
    ({ page, piece }) =>
      !page.pieces
        .slice(piece.token, piece.closed.token)
        .some(({ name, tex }) => PROVED.includes(name) || /\\number\{/.test(tex ?? '')),
  );
