// The whole book as one page, to be printed.
import { cssString, escapeHtml } from '../weave/text.mjs';
import { adopt } from './adopt.mjs';
import { ANSWERS, takeAnswers } from './answers.mjs';
import { readParts } from './parts.mjs';

// HTML that is at home in the folder of the woven book.
export function wholeBook(book) {
  const { version, address, parts } = readParts(book);
  const [front] = parts;
  const { title } = front;
  const cover = coverHtml(front, version, address);
  front.title = 'What this book is about';
  adopt(parts, address);
  const appendix = { name: ANSWERS, kind: ANSWERS, number: '', title: 'Answers', html: takeAnswers(parts) };
  for (const part of parts) {
    part.$('main > h1').remove();
    part.html = part.$('main').html();
  }
  const all = [...parts, appendix];
  return `<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<title>${escapeHtml(title)}</title>
<link rel="stylesheet" href="katex/katex.css">
<link rel="stylesheet" href="book.css">
<style>@page { @top-left { content: ${cssString(title)}; } }</style>
<link rel="stylesheet" href="print.css">
<link rel="stylesheet" href="whole.css">
<style>${all.map(headRule).join('\n')}</style>
</head>
<body>
${cover}
${contentsHtml(all)}
${all.map(partHtml).join('\n')}
</body>
</html>
`;
}

const numbered = ({ number, title }) => (number ? `${number}  ${title}` : title);

// The page to pick a method has a sheet of its own kind.
const headRule = part =>
  part.kind === 'pick-a-method'
    ? ''
    : `@page ${pageName(part)} { @top-right { content: ${cssString(numbered(part))}; } } .${pageName(part)} { page: ${pageName(part)}; }`;

const pageName = ({ name }) => `part-${name}`;

function coverHtml({ $, title }, version, address) {
  const about = $('main .lead')
    .text()
    .match(/^[^.]*\./)[0];
  const where = address ? `<p><a href="${escapeHtml(address)}">${escapeHtml(address)}</a></p>` : '';
  return `<section class="cover"><p class="title">${escapeHtml(title)}</p><p class="about">${escapeHtml(about)}</p>
<div class="imprint"><p>Version ${escapeHtml(version)}</p>${where}<p>Prose and figures: CC BY 4.0. Code: MIT-0.</p></div></section>`;
}

function contentsHtml(parts) {
  const line = (id, number, title) =>
    `<a href="#${id}" data-sheet="000"><span class="no">${number}</span><span>${escapeHtml(title)}</span></a>`;
  const items = parts.map(part => {
    const sections = part.number ? sectionsOf(part).map(s => `<li>${line(s.id, s.number, s.title)}</li>`) : [];
    return `<li>${line(part.name, part.number, part.title)}${sections.length ? `<ol>${sections.join('')}</ol>` : ''}</li>`;
  });
  return `<nav class="whole"><h1>Contents</h1><ol>${items.join('\n')}</ol></nav>`;
}

function sectionsOf({ $ }) {
  return $('main h2[id]')
    .get()
    .map(heading => ({
      id: $(heading).attr('id'),
      number: $(heading).find('.secno').text(),
      title: $(heading).clone().find('.secno').remove().end().text().trim(),
    }));
}

function partHtml(part) {
  const kicker = part.number ? `<span class="kicker">Chapter ${part.number}</span> ` : '';
  return `<div class="${part.kind} ${pageName(part)}"><main><h1 id="${part.name}">${kicker}${escapeHtml(part.title)}</h1>
${part.html}</main></div>`;
}
