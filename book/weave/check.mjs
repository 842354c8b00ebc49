// Looks up everything that the marks name, and reports what is not there.
import { existsSync } from 'node:fs';
import { failureText } from './claims.mjs';
import { MARKS, NUMBERED, REFERS } from './marks.mjs';
import { renderTex, substituteNumbers } from './math.mjs';
import { didYouMean } from './problems.mjs';
import { tableFault } from './tables.mjs';

export function checkBook(book) {
  collectLabels(book);
  for (const page of book.pages) {
    for (const piece of page.pieces) {
      const report = message => book.problems.add(page.file, piece.line, message);
      const check = CHECKS[piece.name];
      if (check && piece.type !== 'close') check({ book, page, piece, report });
      checkPlace(piece, report);
    }
  }
  checkFigureScripts(book);
  checkClaims(book);
}

function collectLabels(book) {
  for (const page of book.pages) {
    for (const piece of page.pieces) {
      if (!piece.number || piece.type === 'heading') continue;
      const key = piece.name === 'listing' ? `listing:${page.name}:${piece.args[0]}:${piece.args[1]}` : `${piece.name}:${piece.args[0]}`;
      const first = book.labels.get(key);
      if (first && piece.name !== 'listing') {
        book.problems.add(page.file, piece.line, `the ${NUMBERED[piece.name].toLowerCase()} name "${piece.args[0]}" is taken by ${first.page.file}:${first.piece.line}; names are unique in the book`);
      }
      if (!first) book.labels.set(key, { page, piece });
    }
    for (const piece of page.pieces.filter(p => p.name === 'bibitem')) book.references.set(piece.args[0], { page, piece });
  }
}

function checkPlace(piece, report) {
  const box = piece.box;
  if (piece.type === 'heading' && box) report(`a heading inside \\${box.name} of line ${box.line}; is \\end${box.name} missing?`);
  if (MARKS[piece.name]?.kind === 'box' && ['figure', 'table', 'eq'].includes(box?.name)) report(`\\${piece.name} stands inside \\${box.name} of line ${box.line}, which can hold no box`);
}

const CHECKS = {
  number({ book, page, piece, report }) {
    piece.value = findNumber(book, page, piece.args[0], report);
  },
  math: ({ book, page, piece, report }) => { piece.html = formula(book, page, piece, false, report); },
  display({ book, page, piece, report }) {
    piece.html = formula(book, page, piece, true, report);
    if (piece.box?.name === 'eq') (piece.box.formulas ??= []).push(piece);
  },
  claim({ book, page, piece, report }) {
    const [name] = piece.args;
    piece.claim = book.claims.get(name);
    if (piece.claim) piece.claim.cited.push({ page, piece });
    else report(`no test bears the name of the claim "${name}".${didYouMean(name, book.claims.keys()) || ' Write the test, or give the sentence another proof.'}`);
  },
  figref: reference, eqref: reference, tabref: reference, exerciseref: reference,
  lstref({ book, page, piece, report }) {
    const [path, tag] = piece.args;
    piece.target = book.labels.get(`listing:${page.name}:${path}:${tag}`)
      ?? [...book.labels].find(([key]) => key.startsWith('listing:') && key.endsWith(`:${path}:${tag}`))?.[1];
    if (!piece.target) report(`no \\listing{${path}, ${tag}} stands in the book`);
  },
  citep({ book, piece, report }) {
    for (const key of piece.args) {
      if (!book.references.has(key)) report(`there is no reference "${key}" in book/references.md.${didYouMean(key, book.references.keys())}`);
    }
  },
  chapterref({ book, piece, report }) { piece.target = findChapter(book, piece.args[0], report); },
  sectionref({ book, piece, report }) {
    const [name, id] = piece.args;
    piece.target = findChapter(book, name, report);
    if (!piece.target) return;
    piece.section = piece.target.page.sections.find(section => section.id === id);
    if (!piece.section) report(`${name} has no section "${id}".${didYouMean(id, piece.target.page.sections.map(s => s.id))}`);
  },
  listing({ book, piece, report }) {
    const [path, tag, caption = ''] = piece.args;
    piece.snippet = book.snippet(path, tag);
    if (piece.snippet.fault) report(piece.snippet.fault);
    else if (!book.sources.has(path)) report(`${path} is not a C++ file under code/ or chapters/, so nothing compiles it`);
    plainTitle(caption, report);
  },
  figure({ book, page, piece, report }) {
    const [name, title] = piece.args;
    const figures = book.chapters.get(page.name)?.figures ?? new Map();
    piece.figure = figures.get(name);
    plainTitle(title, report);
    if (!piece.figure) {
      report(`there is no ${page.folder}/${name}.gp that draws the figure "${name}".${didYouMean(name, figures.keys())}`);
      return;
    }
    piece.figure.used = true;
    for (const svg of [piece.figure.wide, piece.figure.narrow]) {
      if (!existsSync(svg)) report(`${piece.figure.script} has not drawn ${book.short(svg)}; is the chapter built?`);
    }
  },
  exercise: ({ piece, report }) => plainTitle(piece.args[1], report),
  rows({ book, page, piece, report }) {
    const [name] = piece.args;
    const tables = book.chapters.get(page.name)?.tables ?? new Map();
    piece.table = tables.get(name);
    if (!piece.table) report(`the program of this chapter writes no table "${name}".${didYouMean(name, tables.keys())}`);
    const fault = piece.table && tableFault(piece.table);
    if (fault) report(fault);
  },
};

function reference({ book, piece, report }) {
  const kind = REFERS[piece.name];
  const [name] = piece.args;
  piece.target = book.labels.get(`${kind}:${name}`);
  if (piece.target) return;
  const known = [...book.labels.keys()].filter(key => key.startsWith(`${kind}:`)).map(key => key.slice(kind.length + 1));
  report(`there is no \\${kind}{${name}}.${didYouMean(name, known)}`);
}

function plainTitle(title, report) {
  if (/\\f[$[{]/.test(title)) report('a formula in a title: write the title in words and put the formula into the text below');
  else if (/\\[a-z]/i.test(title)) report('a mark in a title: titles are plain text');
}

function formula(book, page, piece, display, report) {
  const problems = book.problems.list.length;
  const tex = substituteNumbers(piece.tex, name => findNumber(book, page, name, report));
  return problems === book.problems.list.length ? renderTex(tex, display, report) : '';
}

function findChapter(book, name, report) {
  const chapter = book.chapters.get(name);
  if (!chapter) report(`there is no chapter "${name}".${didYouMean(name, book.chapters.keys())}`);
  return chapter;
}

export function findNumber(book, page, name, report) {
  const [owner, own] = name.includes('/') ? name.split('/') : [page.name, name];
  const chapter = book.chapters.get(owner);
  const number = chapter?.numbers.get(own);
  if (number && Number.isNaN(number.value)) report(`the number "${name}" is not a number: ${chapter.program} wrote "${number.written}"`);
  if (number) return { ...number, chapter };
  const known = [...(chapter?.numbers.keys() ?? [])].map(known => (owner === page.name && !name.includes('/') ? known : `${owner}/${known}`));
  const elsewhere = [...book.chapters.values()].filter(c => c.numbers.has(own)).map(c => `${c.name}/${own}`);
  if (!chapter && !elsewhere.length) report(name.includes('/') ? `there is no chapter "${owner}" that could write the number "${name}"` : `no chapter writes here: name the number's chapter, as in \\number{2-euler/${name}}`);
  else report(`unknown number "${name}"; ${chapter ? chapter.program : 'the program'} writes none of that name.${didYouMean(name, [...known, ...elsewhere])}`);
  return null;
}

function checkFigureScripts(book) {
  for (const chapter of book.chapters.values()) {
    for (const figure of chapter.figures.values()) {
      if (!figure.used) book.problems.add(figure.script, 1, `no \\figure{${figure.name}, ...} in ${chapter.page.file} shows this figure; show it, or delete the script`);
    }
  }
}

function checkClaims(book) {
  for (const claim of book.claims.values()) {
    if (claim.test.passed) continue;
    const { test } = claim;
    for (const { page, piece } of claim.cited) book.problems.add(page.file, piece.line, `the claim is false: "${test.name}"${failureText(test)}`);
    if (!claim.cited.length) book.problems.add(test.file, test.line, `this test fails: "${test.name}"${failureText(test)}`);
  }
  for (const page of book.pages) {
    for (const box of page.pieces.filter(piece => piece.type === 'open' && piece.name === 'eq')) {
      if (box.formulas?.length !== 1) book.problems.add(page.file, box.line, `\\eq{${box.args[0]}} holds ${box.formulas?.length ?? 0} displayed formulas; it numbers one: \\f[ ... \\f]`);
    }
  }
}
