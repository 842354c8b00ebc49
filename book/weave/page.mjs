// One Markdown page: its tokens, its pieces in order, its boxes checked.
import { existsSync, readFileSync } from 'node:fs';
import { MARKS, NUMBERED } from './marks.mjs';
import { minutesToRead } from './reading-time.mjs';
import { slug } from './text.mjs';
import { allTokens, parseProse } from './prose.mjs';
import { putInTasks } from './tasks.mjs';

export function readPage(path, { file, order, name, owner, number, href, exercises, problems }) {
  const page = {
    file,
    order,
    name,
    owner,
    number,
    href,
    source: '',
    title: '',
    sections: [],
    tokens: [],
    pieces: [],
    tasks: new Map(),
    slides: [],
  };
  if (!existsSync(path)) {
    problems.add(file, 1, 'there is no such file; each chapter has one, and each page around them');
    return page;
  }
  page.source = readFileSync(path, 'utf8');
  if (number) takeInTasks(page, exercises, problems);
  page.tokens = parseProse(page.source, (line, message) => problems.add(file, line, message));
  const all = allTokens(page.tokens);
  const upTo = piece => all.findIndex(({ meta }) => meta === piece);
  page.minutes = until => minutesToRead(until ? all.slice(0, upTo(until)) : all);
  page.pieces = all.map(token => token.meta).filter(Boolean);
  page.pieces.forEach((piece, i) => {
    piece.token = i;
  });
  checkBoxes(page, problems);
  takeLiveForFigures(page);
  nameHeadings(page, problems);
  numberBoxes(page);
  return page;
}

function takeInTasks(page, folder, problems) {
  const { source, places, tasks } = putInTasks(page.source, { file: page.file, name: page.name, folder, problems });
  Object.assign(page, { source, tasks });
  problems.madeOf(page.file, places);
}

function checkBoxes(page, problems) {
  const open = [];
  for (const piece of page.pieces) {
    const within = MARKS[piece.name]?.within;
    if (piece.type === 'open') {
      if (within && !open.some(box => box.name === within))
        problems.add(
          page.file,
          piece.line,
          `\\${piece.name} stands outside of \\${within}; put it between \\${within} and \\end${within}`,
        );
      open.push(piece);
    } else if (piece.type === 'close') closeBox(page, open, piece, problems);
    if (piece.type !== 'close') piece.box = open.findLast(box => box !== piece) ?? null;
  }
  for (const box of open)
    if (!box.told)
      problems.add(page.file, box.line, `\\${box.name} is never closed; put \\end${box.name} where it ends`);
}

function closeBox(page, open, piece, problems) {
  const top = open.at(-1);
  if (top?.name === piece.name) {
    piece.opens = open.pop();
    piece.opens.closed = piece;
    return;
  }
  if (!open.some(box => box.name === piece.name)) {
    problems.add(
      page.file,
      piece.line,
      `\\end${piece.name} closes nothing; there is no open \\${piece.name} before it`,
    );
    return;
  }
  problems.add(
    page.file,
    piece.line,
    `\\end${piece.name} comes before \\end${top.name}: \\${top.name} of line ${top.line} is still open; close it first`,
  );
  const at = open.findLastIndex(box => box.name === piece.name);
  for (const box of open.slice(at)) box.told = true;
  open.splice(at, 1);
}

// A live figure is a figure, numbered and referred to as one, with something built on it. So is a film, whose program has the
// same name in every chapter.
function takeLiveForFigures(page) {
  for (const piece of page.pieces) {
    if (piece.type !== 'open' || piece.incomplete) continue;
    if (piece.name === 'live') Object.assign(piece, { name: 'figure', live: true });
    if (piece.name !== 'film') continue;
    const [program, title] = piece.args;
    Object.assign(piece, { name: 'figure', program, args: [`${program}-${page.name}`, title] });
  }
}

function nameHeadings(page, problems) {
  const headings = page.pieces.filter(piece => piece.type === 'heading');
  const [first, ...rest] = headings;
  if (first?.line !== 1 || first.level !== 1)
    problems.add(page.file, 1, 'a page starts with its title; write "# Title" in the first line');
  page.title = first?.level === 1 ? first.text : '';
  const seen = new Map();
  let section = 0,
    sub = 0,
    previous = 1;
  for (const heading of rest) {
    heading.id = slug(heading.text);
    if (heading.level === 1) problems.add(page.file, heading.line, 'a second title; sections start with ##');
    else if (heading.level > previous + 1)
      problems.add(
        page.file,
        heading.line,
        `a heading of level ${heading.level} right below one of level ${previous}; leave no level out`,
      );
    if (seen.has(heading.id))
      problems.add(
        page.file,
        heading.line,
        `this section has the same name as the one in line ${seen.get(heading.id)}; links could not tell them apart`,
      );
    seen.set(heading.id, heading.line);
    previous = heading.level;
    if (heading.level === 2) {
      ++section;
      sub = 0;
    } else if (heading.level === 3) ++sub;
    if (page.number && heading.level <= 3)
      heading.number = `${page.number}.${section}${heading.level === 3 ? `.${sub}` : ''}`;
    page.sections.push(heading);
  }
}

function numberBoxes(page) {
  const count = {};
  for (const piece of page.pieces) {
    if (piece.name === 'term') piece.id = `term-${slug(piece.args[0])}`;
    if (['claim', 'tested'].includes(piece.name)) piece.id = `cited-${(count.claim = (count.claim ?? 0) + 1)}`;
    if (piece.type === 'close' || piece.incomplete || !NUMBERED[piece.name]) continue;
    count[piece.name] = (count[piece.name] ?? 0) + 1;
    piece.number = page.number ? `${page.number}.${count[piece.name]}` : String(count[piece.name]);
    piece.id = piece.name === 'listing' ? `listing-${count.listing}` : `${piece.name}-${slug(piece.args[0])}`;
  }
}
