// The places of a page that a search can lead to: its beginning, sections, exercises, answers that fold out, words that are explained.
import { slug, textOfHtml, HOLE } from './text.mjs';

const STARTS = /(?=<h[23] id="|<section class="exercise" id="|<details class="choice" id="|<li>\ue000)/;

// Of the page's HTML that still has holes; `inline` gives the text of a hole's piece. Each place is
// { kind, id, title, number?, level?, text }, with all that stands before the next.
export function placesOf(page, raw, inline) {
  const text = html =>
    textOfHtml(html.replace(/\ue002\d+\ue003|<a class="file"[^]*?<\/a>/g, ' '))
      .replace(HOLE, (_, n) => inline(n))
      .replace(/\s+/g, ' ')
      .replace(/ (?=[.,;:!?])/g, '');
  const places = [{ kind: 'page', id: '', title: '', html: '' }];
  for (const part of raw.split(STARTS)) {
    const place = startOf(page, part);
    if (place) places.push({ ...place, html: withoutStart(part, place) });
    else places.at(-1).html += part;
  }
  return places.map(({ html, ...place }) => ({ ...place, text: text(html) }));
}

function startOf(page, part) {
  const [, id] = part.match(/^<\w+ (?:class="\w+" )?id="([^"]*)"/) ?? [];
  const [, hole] = part.match(/^<li>\ue000(\d+)\ue001/) ?? [];
  if (hole !== undefined) {
    const piece = page.pieces[hole];
    return piece.name === 'term' ? { kind: 'word', id: piece.id, title: piece.args[0] } : null;
  }
  const section = page.sections.find(heading => heading.id === id && part.startsWith('<h'));
  if (section)
    return { kind: 'section', id, title: section.text.replace(/`/g, ''), number: section.number, level: section.level };
  const box = page.pieces.find(
    ({ type, name, id: own, args }) =>
      type === 'open' && (name === 'exercise' ? own === id : name === 'choice' && slug(args[0]) === id),
  );
  return box ? { kind: box.name, id, title: box.args[1], number: box.number } : null;
}

// Without its title, which stands by itself.
const withoutStart = (part, { kind }) =>
  kind === 'word' ? part.replace(HOLE, '') : part.replace(/^[^]*?<\/(?:h\d|summary)>/, '');
