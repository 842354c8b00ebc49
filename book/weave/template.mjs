// The one page template.
import { onTheWay } from './book.mjs';
import { headHtml } from './head.mjs';
import { liveHead } from './live.mjs';
import { beforeColon, cssString, escapeHtml, smarten, textOfHtml } from './text.mjs';

// page: { href, title, kind, body, kicker?, titleHtml?, sections?, previous?, next? }
export function pageHtml(book, page) {
  const name = escapeHtml(smarten(book.title));
  const title = escapeHtml(smarten(page.title));
  const head = headTitle(book, page, name, title);
  return `<!DOCTYPE html>
<html lang="en"${book.config.compiler ? ' data-compiler' : ''}>
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>${head}</title>
${headHtml(book, page, head)}
<meta name="color-scheme" content="light dark">
<script>document.documentElement.classList.add("scripted");try{var t=localStorage.getItem("theme");if(t)document.documentElement.dataset.theme=t}catch(e){}</script>
${page.body.includes('class="katex') ? '<link rel="stylesheet" href="katex/katex.css">\n' : ''}<link rel="stylesheet" href="book.css">
${printHead(book, page)}
<script defer src="book.js"></script>
${page.kind === 'exercises' ? '<script defer src="exercises.js"></script>\n' : ''}${page.body.includes('class="your-spring"') ? '<script defer src="pick-a-method.js"></script>\n' : ''}${liveHead(page.body)}</head>
<body class="${page.kind}">
<a class="skip" href="#content">Skip to the text</a>
<div class="shell">
${sideNav(book, page, name)}
<div class="page">
<main id="content">
<h1>${page.kicker ? `<span class="kicker">${escapeHtml(page.kicker)}</span> ` : ''}${page.titleHtml ?? title}</h1>
${page.body}
${pager(page)}<footer>${name} ${escapeHtml(book.config.version)}. Prose and figures: CC BY 4.0. Code: MIT-0. <a href="about.html">How to cite, report a mistake</a></footer>
</main>
${onThisPage(page)}</div>
</div>
</body>
</html>
`;
}

const LONGEST_TITLE = 70; // letters that a list of hits shows

// On paper the book's name and the page's stand at the head of each sheet.
function printHead(book, { number, title, kind }) {
  const heads = { left: book.title, right: number ? `${number}  ${title}` : title };
  const boxes = Object.entries(heads).map(([side, text]) => `@top-${side} { content: ${cssString(smarten(text))}; }`);
  return `<style>@page { ${kind === 'slides' ? 'size: A4 landscape; ' : ''}${boxes.join(' ')} }</style>\n<link rel="stylesheet" href="print.css" media="print">`;
}

// What a browser's tab and a list of hits say: of what is right the longest that is shown whole.
function headTitle(book, page, name, title) {
  const searched = book.words.titles[page.href];
  if (page.href === 'index.html') return searched ? `${name}: ${searched}` : name;
  if (page.kind === 'source') return title; // the path of a file is long, and says enough
  const own = searched ?? (page.number ? `${page.number}. ${title}` : title);
  const more = page.kind === 'api' && page.kicker ? `${own}, ${escapeHtml(page.kicker)}` : own;
  const shown = text => textOfHtml(text).length <= LONGEST_TITLE;
  return [`${more} · ${name}`, more, own].find(shown) ?? own;
}

function sideNav(book, page, name) {
  const link = (href, text, number = '', kind = '') =>
    `<li${kind}><a href="${href}"${current(page, href)}><span class="no">${number}</span><span>${text}</span></a>${page.href === href ? within(page) : ''}</li>`;
  const prose = ({ href, title, number, beside }) =>
    link(href, escapeHtml(smarten(title)), number, beside ? ' class="beside"' : '');
  const numbered = book.pages.findLastIndex(p => p.number || p.beside) + 1;
  const before = book.pages.slice(1, numbered),
    after = book.pages.slice(numbered);
  const isFirst = ({ name: its }) => its === 'pick-a-method'; // whoever has a deadline looks there first
  const more = [
    ...after.filter(isFirst).map(prose),
    link('snippets.html', 'Snippets'),
    link('exercises.html', 'Exercises'),
    ...after.filter(p => !isFirst(p) && onTheWay(p)).map(prose),
    link('claims.html', 'Claims'),
    link('reference.html', 'Code reference'),
  ];
  return `<nav class="side" aria-label="Book">
<div class="bar"><a class="brand" href="index.html">${name}</a><span class="place" aria-hidden="true"></span></div>
<details class="menu"><summary>Contents</summary><div>
<div class="search" role="search"><input type="search" placeholder="Search" aria-label="Search the book" aria-keyshortcuts="/" autocomplete="off"><kbd>/</kbd><p class="unseen" role="status"></p><ul hidden></ul></div>
<ol class="toc">
${before.map(prose).join('\n')}
</ol>
<ol class="toc more">
${more.join('\n')}
</ol>
<div class="tools"><button type="button" class="theme">Light or dark</button> <button type="button" class="system" hidden>As the system</button></div>
</div></details>
</nav>`;
}

// Where there is no room beside the text, the sections of a page stand in the menu.
const within = page => (hasSections(page) ? `<ol class="within">${sectionLinks(page)}</ol>` : '');

const hasSections = ({ sections = [] }) => sections.length > 1;

const sectionLinks = ({ sections }) =>
  sections
    .map(s => `<li${s.within ? ' class="within"' : ''}><a href="#${s.id}">${escapeHtml(smarten(s.title))}</a></li>`)
    .join('');

function current(page, href) {
  if (page.href === href) return ' aria-current="page"';
  return href === 'reference.html' && (page.kind === 'api' || page.kind === 'source') ? ' aria-current="true"' : '';
}

function pager({ previous, next }) {
  if (!previous && !next) return '';
  const link = (rel, label, page) =>
    page
      ? `<a rel="${rel}" href="${page.href}"><small>${label}</small>${escapeHtml(smarten(page.number ? beforeColon(page.title) : page.title))}</a>`
      : '';
  return `<nav class="pager" aria-label="Previous and next page">${link('prev', 'Previous', previous)}${link('next', 'Next', next)}</nav>\n`;
}

function onThisPage(page) {
  if (!hasSections(page)) return '';
  return `<nav class="onpage" aria-label="On this page"><strong>On this page</strong><ol>${sectionLinks(page)}</ol></nav>\n`;
}
