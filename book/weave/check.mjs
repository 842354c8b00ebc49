// Looks up everything that the marks name, and reports what is not there.
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { checkChange } from './change-box.mjs';
import { checkWhole } from './check-whole.mjs';
import { checkFilm } from './films.mjs';
import { findChapter, findNumber } from './look_up.mjs';
import { liveFolder, methodsOf } from './live.mjs';
import { MARKS, NUMBERED, REFERS } from './marks.mjs';
import { renderTex, substituteNumbers } from './math.mjs';
import { didYouMean, nameOneOf } from './problems.mjs';
import { checkSet } from './set-links.mjs';
import { tableColumns, tableFault } from './tables.mjs';
import { introduction, italics } from './terms.mjs';
import { checkTake } from './pick-a-method.mjs';

export function checkBook(book) {
  collectLabels(book);
  for (const page of book.pages) {
    for (const piece of page.pieces) {
      const report = (message, line = 0) => book.problems.add(page.file, piece.line + line, message);
      const check = CHECKS[piece.name];
      if (check && piece.type !== 'close' && !piece.incomplete) check({ book, page, piece, report });
      checkPlace(piece, report);
    }
  }
  checkWhole(book);
}

// What is documented in code/ is known when Doxygen has run.
export function checkReferencesToCode(book) {
  for (const page of book.pages) {
    for (const piece of page.pieces.filter(({ name }) => name === 'ref')) {
      const [name] = piece.args;
      piece.target = book.api.names.get(name);
      if (!piece.target)
        book.problems.add(
          page.file,
          piece.line,
          `a reference to nothing: \\ref ${name}; name something that is documented in code/, with its namespace.${didYouMean(name, book.api.names.keys())}`,
        );
    }
  }
}

function collectLabels(book) {
  for (const page of book.pages) {
    for (const piece of page.pieces) {
      if (!piece.number || piece.type === 'heading') continue;
      const key =
        piece.name === 'listing'
          ? `listing:${page.name}:${piece.args[0]}:${piece.args[1]}`
          : `${piece.name}:${piece.args[0]}`;
      const first = book.labels.get(key);
      if (first && piece.name !== 'listing') {
        book.problems.add(
          page.file,
          piece.line,
          `the ${NUMBERED[piece.name].toLowerCase()} name "${piece.args[0]}" is taken by ${first.page.file}:${first.piece.line}; names are unique in the book`,
        );
      }
      if (!first) book.labels.set(key, { page, piece });
    }
    for (const piece of page.pieces.filter(p => p.name === 'bibitem')) {
      const [key] = piece.args;
      const first = book.references.get(key);
      if (first)
        book.problems.add(
          page.file,
          piece.line,
          `the reference "${key}" is taken by ${first.page.file}:${first.piece.line}; give this one another key`,
        );
      else book.references.set(key, { page, piece });
    }
  }
}

function checkPlace(piece, report) {
  const box = piece.box;
  if (piece.type === 'heading' && box?.closed)
    report(`a heading inside \\${box.name} of line ${box.line}; is \\end${box.name} missing?`);
  const { kind, within } = MARKS[piece.name] ?? {};
  if (kind === 'box' && within !== 'live' && ['figure', 'table', 'eq'].includes(box?.name))
    report(`\\${piece.name} stands inside \\${box.name} of line ${box.line}, which can hold no box`);
}

const CHECKS = {
  number({ book, page, piece, report }) {
    piece.value = findNumber(book, page, piece.args[0], report);
  },
  math: ({ book, page, piece, report }) => {
    piece.html = formula(book, page, piece, false, report);
  },
  display: ({ book, page, piece, report }) => {
    piece.html = formula(book, page, piece, true, report);
  },
  claim,
  tested: claim,
  set: checkSet,
  figref: reference,
  eqref: reference,
  tabref: reference,
  exerciseref: reference,
  lstref({ book, page, piece, report }) {
    const [path, tag] = piece.args;
    piece.target =
      book.labels.get(`listing:${page.name}:${path}:${tag}`) ??
      [...book.labels].find(([key]) => key.startsWith('listing:') && key.endsWith(`:${path}:${tag}`))?.[1];
    if (piece.target) return;
    const known = [...book.labels.values()]
      .filter(label => label.piece.name === 'listing')
      .map(label => label.piece.args.slice(0, 2).join(', '));
    report(`no \\listing{${path}, ${tag}} stands in the book.${nameOneOf(`${path}, ${tag}`, known)}`);
  },
  citep({ book, piece, report }) {
    for (const key of piece.args) {
      if (!book.references.has(key))
        report(`there is no reference "${key}" in book/references.md.${nameOneOf(key, book.references.keys())}`);
    }
  },
  chapterref: chapter,
  minutes: chapter,
  graded: chapter,
  sectionref({ book, piece, report }) {
    const [name, id] = piece.args;
    piece.target = findChapter(book, name, report);
    if (!piece.target) return;
    piece.section = piece.target.page.sections.find(section => section.id === id);
    if (!piece.section)
      report(
        `${name} has no section "${id}".${nameOneOf(
          id,
          piece.target.page.sections.map(s => s.id),
        )}`,
      );
  },
  term({ book, piece, report }) {
    const [name] = piece.args;
    piece.target = introduction(book, name);
    if (!piece.target)
      report(`no chapter says *${name}* in italics, as where a term is introduced.${didYouMean(name, italics(book))}`);
  },
  listing({ book, piece, report }) {
    const [path, tag, caption = ''] = piece.args;
    piece.snippet = book.snippet(path, tag);
    if (piece.snippet.fault) report(piece.snippet.fault);
    else if (!book.sources.has(path))
      report(`${path} is not a C++ file under code/ or chapters/, so nothing compiles it`);
    plainTitle(caption, report);
  },
  figure({ book, page, piece, report }) {
    const [name, title] = piece.args;
    if (piece.program) return (plainTitle(title, report), checkFilm({ book, page, piece, report }));
    const { folder = '', figures = new Map() } = book.programs.get(page.owner) ?? {};
    piece.figure = figures.get(name);
    plainTitle(title, report);
    if (!piece.figure) {
      report(
        `there is no ${folder && `${folder}/`}${name}.gp that draws the figure "${name}".${didYouMean(name, figures.keys())}`,
      );
      return;
    }
    piece.figure.used = true;
    if (piece.live) checkLive(book, page, piece, report);
    for (const svg of [piece.figure.wide, piece.figure.narrow]) {
      if (!existsSync(svg)) report(`${piece.figure.script} has not drawn ${book.short(svg)}; is the chapter built?`);
    }
  },
  // Those in their place were put in before the page was cut to pieces.
  task: ({ report }) => report('\\task{name} stands on a line of its own, in a chapter'),
  exercise: ({ piece, report }) => plainTitle(piece.args[1], report),
  card({ book, piece, report }) {
    const [name] = piece.args;
    piece.card = book.cards.get(name);
    if (!piece.card) report(`there is no card of a function "${name}".${nameOneOf(name, book.cards.keys())}`);
  },
  take: checkTake,
  choice: ({ piece, report }) => plainTitle(piece.args[1], report),
  change(context) {
    plainTitle(context.piece.args[0], context.report);
    checkChange(context);
  },
  rows: checkTable,
  sketch: checkTable,
};

// A table that the page's program has written.
function checkTable({ book, page, piece, report }) {
  const [name] = piece.args;
  const tables = book.programs.get(page.owner)?.tables ?? new Map();
  piece.table = tables.get(name);
  if (!piece.table) report(`the program of this chapter writes no table "${name}".${nameOneOf(name, tables.keys())}`);
  const fault = piece.table && tableFault(piece.table);
  if (fault) report(fault);
}

function checkLive(book, page, piece, report) {
  const [name] = piece.args;
  const folder = liveFolder(book.programs.get(page.owner));
  piece.live = book.live.get(name);
  if (!piece.live) {
    report(
      `there is no ${folder}/${name}.json that describes the live figure "${name}".${nameOneOf(name, book.live.keys())}`,
    );
    return;
  }
  piece.live.used = true;
  if (piece.live.folder !== folder) {
    report(`${piece.live.file} lies with another chapter; move what is named ${name} to ${folder}`);
    return;
  }
  for (const kind of ['cpp', 'js']) {
    const file = `${folder}/${name}.${kind}`;
    if (!existsSync(join(book.config.source, file)))
      report(`there is no ${file}, which the live figure "${name}" needs`);
  }
  for (const { path, tag } of methodsOf(piece.live)) {
    const { fault } = book.snippet(path, tag);
    if (fault) report(`the live figure shows the code of its methods: ${fault}`);
  }
  findLiveTables(book, page, piece.live, report);
  findLiveNumbers(book, page, piece.live, report);
}

// { name: { column: [value] } } of the tables that a picture draws.
function findLiveTables(book, page, live, report) {
  const tables = book.programs.get(page.owner)?.tables ?? new Map();
  const found = (live.tables ?? []).map(name => {
    if (!tables.has(name))
      report(
        `${live.file} wants the table "${name}", and the program of this chapter writes none of that name.${nameOneOf(name, tables.keys())}`,
      );
    return [name, tables.has(name) && tableColumns(tables.get(name))];
  });
  live.tables = Object.fromEntries(found);
}

// { name: value } of the recorded numbers that a picture draws.
function findLiveNumbers(book, page, live, report) {
  const found = (live.numbers ?? []).map(name => [
    name,
    findNumber(book, page, name, fault => report(`${live.file}: ${fault}`))?.value,
  ]);
  live.numbers = Object.fromEntries(found);
}

function chapter({ book, piece, report }) {
  piece.target = findChapter(book, piece.args[0], report);
}

function claim({ book, page, piece, report }) {
  const [name] = piece.args;
  piece.claim = book.claims.get(name);
  if (piece.claim) piece.claim.cited.push({ page, piece });
  else
    report(
      `no test bears the name of the claim "${name}".${didYouMean(name, book.claims.keys()) || ' Write the test, or give the sentence another proof.'}`,
    );
}

function reference({ book, piece, report }) {
  const kind = REFERS[piece.name];
  const [name] = piece.args;
  piece.target = book.labels.get(`${kind}:${name}`);
  if (piece.target) return;
  const known = [...book.labels.keys()]
    .filter(key => key.startsWith(`${kind}:`))
    .map(key => key.slice(kind.length + 1));
  report(`there is no \\${kind}{${name}}.${nameOneOf(name, known)}`);
}

function plainTitle(title, report) {
  if (/\\f[$[{]/.test(title))
    report('a formula in a title: write the title in words and put the formula into the text below');
  else if (/\\[a-z]/i.test(title)) report('a mark in a title: titles are plain text');
}

function formula(book, page, piece, display, report) {
  const problems = book.problems.list.length;
  const tex = substituteNumbers(piece.tex, (name, line) =>
    findNumber(book, page, name, message => report(message, line)),
  );
  return problems === book.problems.list.length ? renderTex(tex, display, report) : '';
}
