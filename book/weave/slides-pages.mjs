// For a lecturer: what each chapter teaches, and its figures as slides, one to a sheet.
import { goalsIn } from './head.mjs';
import { beforeColon, escapeHtml, smarten } from './text.mjs';

const hrefOf = ({ number }) => `slides-${number}.html`;
const titleOf = ({ title }) => escapeHtml(smarten(title));

// `prose` are the pages as they are written, `book.pages` the same as they were read: in these each figure has left its picture.
export function slidesPages(book, prose) {
  const chapters = [...book.chapters.values()].map(({ page, title, number, href }) => {
    const besides = book.pages.filter(({ beside }) => beside?.page === page);
    const slides = [page, ...besides].flatMap(it => it.slides.map(slide => ({ ...slide, page: it })));
    return { title, number, href, slides, goals: goalsIn(prose.find(it => it.href === href).body) };
  });
  return [overview(chapters), ...chapters.map(slidesPage)];
}

const overview = chapters => ({
  href: 'slides.html',
  title: 'What each chapter teaches, and its slides',
  kind: 'made',
  body:
    '<p class="lead">For whoever teaches a course: the goals of each chapter, and its figures in large, one to a sheet.</p>\n' +
    chapters
      .map(
        chapter =>
          `<h2 id="chapter-${chapter.number}"><span class="secno">${chapter.number}</span> ${titleOf(chapter)}</h2>\n${chapter.goals}\n` +
          `<p><a href="${hrefOf(chapter)}">${chapter.slides.length} slides</a>, and <a href="${chapter.href}">the chapter</a></p>`,
      )
      .join('\n'),
  sections: chapters.map(({ number, title }) => ({ id: `chapter-${number}`, title })),
});

const slidesPage = chapter => ({
  href: hrefOf(chapter),
  title: `Slides: ${beforeColon(chapter.title)}`,
  kicker: `Chapter ${chapter.number}`,
  kind: 'slides',
  body:
    `<p class="lead">The ${chapter.slides.length} figures of chapter ${chapter.number}. Print them, and each fills a sheet. Below each is the way back to where it is explained, and can be played with.</p>\n` +
    (chapter.goals && `<section class="slide"><h2>What it teaches</h2>\n${chapter.goals}</section>\n`) +
    chapter.slides.map(slideHtml).join('\n'),
});

const slideHtml = ({ page, id, number, title, picture, film }) =>
  `<section class="slide"><h2>${title}</h2>\n<div class="plot${film ? ' film' : ''}">${picture}</div>\n` +
  `<p><a href="${page.href}#${id}">Figure ${number}${page.beside ? `, beside chapter ${page.beside.number}` : ''}</a>${film ? `, and <a href="${film}">the film</a>` : ''}</p></section>`;
