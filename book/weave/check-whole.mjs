// Looks at what only the whole book shows: what is there and shown nowhere, tests that fail, boxes without what they are for.
import { bareCaptions } from './captions.mjs';
import { failureText } from './claims.mjs';
import { checkPrints, checkPrograms } from './films.mjs';

export function checkWhole(book) {
  checkFigureScripts(book);
  checkLiveFigures(book);
  checkPrograms(book);
  checkPrints(book);
  checkClaims(book);
  checkCaptions(book);
  for (const page of book.pages) checkContents(book, page);
}

function checkFigureScripts(book) {
  for (const chapter of book.programs.values()) {
    for (const figure of chapter.figures.values()) {
      if (!figure.used)
        book.problems.add(
          figure.script,
          1,
          `no \\figure{${figure.name}, ...} in ${chapter.page.file} shows this figure; show it, or delete the script`,
        );
    }
  }
}

function checkLiveFigures(book) {
  for (const live of book.live.values()) {
    if (!live.used)
      book.problems.add(
        live.file,
        1,
        `no page shows this with \\live{${live.name}, ...}; show it, or delete what is named ${live.name}`,
      );
  }
}

function checkClaims(book) {
  for (const claim of book.claims.values()) {
    if (claim.test.passed) continue;
    const { test } = claim;
    for (const { page, piece } of claim.cited)
      book.problems.add(page.file, piece.line, `the claim is false: "${test.name}"${failureText(test)}`);
    if (!claim.cited.length)
      book.problems.add(test.file, test.line, `this test fails: "${test.name}"${failureText(test)}`);
  }
}

// A caption is a sentence like any other: what it says of its data is measured or proved, and what only tells where to look
// is marked so. Those that are neither may only get fewer.
function checkCaptions(book) {
  const bare = bareCaptions(book);
  const most = book.config.bareCaptions ?? 0;
  if (bare.length <= most) return;
  for (const { page, piece } of bare)
    book.problems.add(
      page.file,
      piece.line,
      `the caption of "${piece.args[0]}" has neither \\number nor \\claim nor \\look; ${most} of the book may, and ${bare.length} do`,
    );
}

// A pair of boxes holds what it numbers, and one of it.
function checkContents(book, page) {
  const boxes = name =>
    page.pieces.filter(piece => piece.type === 'open' && piece.name === name && piece.closed && !piece.incomplete);
  for (const box of boxes('eq')) {
    const n = page.pieces.filter(piece => piece.name === 'display' && piece.box === box).length;
    if (n !== 1)
      book.problems.add(
        page.file,
        box.line,
        `\\eq{${box.args[0]}} holds ${n} displayed formulas; it numbers one: \\f[ ... \\f]`,
      );
  }
  for (const box of boxes('table')) {
    const n = page.pieces.filter(
      piece => piece.box === box && (piece.name === 'rows' || piece.type === 'tablestart'),
    ).length;
    if (n !== 1)
      book.problems.add(
        page.file,
        box.line,
        `\\table{${box.args[0]}} holds ${n} tables; put one between its caption and \\endtable: \\rows{name}, or rows in Markdown`,
      );
  }
}
