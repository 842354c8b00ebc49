// What the boxes become, given the HTML of what stands in them.
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { inlineText } from './inline.mjs';
import { changeHtml } from './change-box.mjs';
import { filmHtml, filmSources } from './films.mjs';
import { liveHtml } from './live.mjs';
import { sourceHref } from './source-pages.mjs';
import { adoptSvg } from './svg.mjs';
import { valuesHtml } from './svg-points.mjs';
import { taskFoot, taskHead } from './task-box.mjs';
import { choiceHtml } from './pick-a-method.mjs';
import { escapeHtml, HOLE, smarten, textOfHtml } from './text.mjs';

export function boxHtml(context, piece, html) {
  return BOXES[piece.name](html, piece, context);
}

const note =
  (name, label = '') =>
  html =>
    `<div class="${name}" role="note"${label ? ` aria-label="${label}"` : ''}>${label ? `<p class="label">${label}</p>\n` : ''}${html}</div>`;

const BOXES = {
  lead: html => `<div class="lead">${html}</div>`,
  goals: html => `<div class="goals" role="note" aria-label="Goals">${html}</div>`,
  takehome: note('takehome', 'To take home'),
  aside: note('aside'),
  remark: note('remark'),
  rest: (html, { args: [title] }) =>
    `<details class="rest"><summary>${escapeHtml(smarten(title))}</summary><div>${html}</div></details>`,
  hint: html => `<details class="hint"><summary>Hint</summary><div>${html}</div></details>`,
  choice: choiceHtml,
  paper: html => `<div class="on-paper">${html}</div>`,
  screen: html => `<div class="on-screen">${html}</div>`,
  answer: html => `<details class="answer"><summary>Answer</summary><div>${html}</div></details>`,
  eq: (html, piece) =>
    `<div class="equation" id="${piece.id}">${html}<span class="eqno">(${piece.number})</span></div>`,
  exercise: (html, { id, number, args: [name, title] }, { book, page, hold }) =>
    `<section class="exercise" id="${id}" aria-labelledby="${id}-title">` +
    `<h3 id="${id}-title"><span class="secno">Exercise ${number}</span> ${escapeHtml(smarten(title))}</h3>\n${aroundTask(html, page.tasks.get(name), { book, hold })}</section>`,
  table: (html, { id, number }) => {
    const at = html.indexOf('<div class="tablescroll">');
    const caption = at < 0 ? html : html.slice(0, at);
    return `<figure class="tablebox" id="${id}"><figcaption>${startWith(`<b>Table ${number}.</b> `, caption)}</figcaption>${at < 0 ? '' : html.slice(at)}</figure>`;
  },
  change: changeHtml,
  figure: (html, piece, { book, page, hold }) => {
    if (piece.film) return filmBox(html, piece, { book, page, hold });
    const {
      id,
      figure,
      args: [, title],
    } = piece;
    const words = smarten(title);
    const onPaper = html.replace(/<div class="on-screen">[^]*?<\/div>\s*/g, '');
    const description = textOfHtml(onPaper)
      .replace(HOLE, (_, n) => inlineText(page.pieces[n]))
      .replace(/\s+/g, ' ')
      .trim();
    const draw = (file, size) =>
      adoptSvg(readFileSync(file, 'utf8'), { id: `${id}-${size}`, title: words, description: description || words });
    const [wide, narrow] = [draw(figure.wide, 'wide'), draw(figure.narrow, 'narrow')];
    const values = valuesHtml({ wide: wide.points, narrow: narrow.points });
    page.slides.push({ id, number: piece.number, title: escapeHtml(words), picture: wide.html });
    const room = ({ shape }) => `style="aspect-ratio:${shape};max-width:${shape.split('/')[0]}px"`;
    const svgs = `<div class="wide" ${room(wide)}>${wide.html}</div>\n<div class="narrow" ${room(narrow)}><template>${narrow.html}</template></div>\n${values}`;
    const live = book.config.live && piece.live;
    const stage = live ? ` data-live="${live.name}"` : '';
    const caption = live ? html : onPaper;
    const still = live ? `<div class="still">${svgs}</div>\n${liveHtml({ book }, live)}` : svgs;
    return (
      `<figure class="plot" id="${id}"${stage}>${hold(still)}\n<figcaption>${figureLabel(piece, caption)}` +
      `${figureLinks(book.programs.get(page.owner), figure, book, live)}</figcaption></figure>`
    );
  },
};

const filmBox = (html, piece, { book, page, hold }) => {
  const {
    id,
    number,
    args: [, title],
  } = piece;
  const { html: shown, still, href } = filmHtml(page, piece, book);
  page.slides.push({ id, number, title: escapeHtml(smarten(title)), picture: still, film: href });
  return `<figure class="plot" id="${piece.id}">${hold(shown)}\n<figcaption>${figureLabel(piece, html)}${filmSources(page, piece)}</figcaption></figure>`;
};

const figureLabel = ({ number, args: [, title] }, caption) =>
  startWith(`<b>Figure ${number}. ${escapeHtml(smarten(title).replace(/\.$/, ''))}.</b> `, caption);

const aroundTask = (html, task, context) => (task ? `${taskHead(task)}${html}\n${taskFoot(context, task)}` : html);

const startWith = (label, html) =>
  html.startsWith('<p>') ? html.replace('<p>', `<p>${label}`) : `<p>${label.trim()}</p>${html}`;

function figureLinks(chapter, figure, book, live) {
  const links = csvFiles(chapter, figure, book).map(file => `<a href="data/${chapter.name}/${file}">${file}</a>`);
  links.push(`<a href="${sourceHref(figure.script)}">${figure.name}.gp</a>`);
  if (live) links.push(`<a href="${sourceHref(`${live.folder}/${live.name}.cpp`)}">${figure.name}.cpp</a>`);
  return `<p class="sources">${links.length > 1 ? 'Data and script: ' : 'Script: '}${links.join(', ')}</p>`;
}

// The files that the script names, as "name.csv" or as file("name"); a %d, %s or the like in a name stands for several.
// Where a variable or a function is given to file(), every quoted word may be a name.
export function csvFiles(chapter, figure, book) {
  const script = readFileSync(join(book.config.source, figure.script), 'utf8');
  const there = existsSync(chapter.data)
    ? readdirSync(chapter.data)
        .filter(file => file.endsWith('.csv'))
        .sort()
    : [];
  const names = [...script.matchAll(/([\w.%-]+)\.csv|\bfile\((?:sprintf\()?["']([\w.%-]+)["']/g)].map(
    found => found[1] ?? found[2],
  );
  if (/\bfile\([A-Za-z_]\w*/.test(script.replace(/\bfile\(sprintf\(["']/g, ''))) {
    for (const [, , quoted] of script.matchAll(/(["'])(.*?)\1/g))
      names.push(...quoted.split(/\s+/).filter(word => /^\w[\w-]*(%[\d.]*[dsfg])?$/.test(word)));
  }
  const wanted = names.map(
    name => new RegExp(`^${name.replace(/\./g, '\\.').replace(/%[\d.\\]*[dsfg]/g, '[\\w.-]+')}\\.csv$`),
  );
  return there.filter(file => wanted.some(pattern => pattern.test(file)));
}
