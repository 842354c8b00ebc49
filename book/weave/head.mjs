// What search engines and messengers read at the head of a page: what it is about, and, where the book has an address, where it is.
import { readFileSync } from 'node:fs';
import { escapeHtml, smarten, textOfHtml } from './text.mjs';

const LONGEST = 160; // letters that a search engine shows
// The colours of the style sheet: of its paper by day and by night, and of what stands out.
const STYLE = readFileSync(new URL('../theme/book.css', import.meta.url), 'utf8');
const coloursOf = name => [...STYLE.matchAll(new RegExp(`--${name}: (#[0-9a-f]+)`, 'g'))].map(([, colour]) => colour);
const PAPERS = coloursOf('paper');
const ICON = `data:image/svg+xml,%3Csvg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 16 16'%3E%3Crect width='16' height='16' rx='3' fill='${encodeURIComponent(coloursOf('accent')[0])}'/%3E%3Cpath d='M3 12h4V8h3V4h3' fill='none' stroke='white' stroke-width='1.6'/%3E%3C/svg%3E`;

export function headHtml(book, page, title) {
  const about = escapeHtml(description(page));
  const address = addressOf(book, page);
  const lines = [
    `<link rel="icon" href="${ICON}">`,
    ...['light', 'dark'].map(
      (scheme, i) => `<meta name="theme-color" content="${PAPERS[i]}" media="(prefers-color-scheme: ${scheme})">`,
    ),
    about && `<meta name="description" content="${about}">`,
    `<meta property="og:title" content="${title}">`,
    about && `<meta property="og:description" content="${about}">`,
    `<meta property="og:type" content="${page.href === 'index.html' ? 'book' : 'article'}">`,
    address && `<link rel="canonical" href="${address}">`,
    address && `<meta property="og:url" content="${address}">`,
    page.kind === 'source' && '<meta name="robots" content="noindex">',
    page.href === 'index.html' && `<script type="application/ld+json">${aboutBook(book, address)}</script>`,
  ];
  return lines.filter(Boolean).join('\n');
}

// What one can do after a chapter, by the HTML of its page.
export const goalsIn = body => body.match(/<div class="goals"[^>]*>([^]*?)<\/div>/)?.[1] ?? '';

// The page's first sentences, as many as are shown whole; of a chapter what one can do after it.
function description({ body }) {
  const goals = goalsIn(body);
  if (goals)
    return asMany([...goals.matchAll(/<li>([^]*?)<\/li>/g)].map(([, goal]) => plain(goal).replace(/[.;]$/, '')));
  const patterns = [
    /<(?:div|p) class="lead">([^]*?)<\/(?:div|p)>/,
    /<p class="brief">([^]*?)<\/p>/,
    /<p[^>]*>([^]*?)<\/p>/,
  ];
  const [, first] = patterns.map(pattern => body.match(pattern)).find(Boolean) ?? ['', body.slice(0, 2000)];
  const text = plain(first);
  if (text.length <= LONGEST) return text;
  const cut = text.slice(0, LONGEST);
  const sentence = cut.match(/^.*[.!?](?= )/)?.[0];
  return sentence ?? `${cut.slice(0, cut.lastIndexOf(' '))} …`;
}

const plain = html =>
  textOfHtml(html.replace(/<(annotation|svg|style|script)\b[^]*?<\/\1>/g, ' ')).replace(/ (?=[.,;:!?])/g, '');

// "Write this; predict that."
function asMany([first, ...goals]) {
  let text = first.charAt(0).toUpperCase() + first.slice(1);
  for (const goal of goals) if (`${text}; ${goal}.`.length <= LONGEST) text += `; ${goal}`;
  return `${text}.`;
}

const addressOf = ({ config }, { href }) =>
  config.url ? `${config.url.replace(/\/$/, '')}/${href === 'index.html' ? '' : href}` : '';

const aboutBook = (book, url) =>
  JSON.stringify({
    '@context': 'https://schema.org',
    '@type': 'Book',
    'name': smarten(book.title),
    'version': book.config.version,
    'inLanguage': 'en',
    'learningResourceType': 'textbook',
    'license': 'https://creativecommons.org/licenses/by/4.0/',
    ...(url && { url }),
  }).replace(/</g, '\\u003c');

// For a book with an address: each page that a search engine should know.
export function sitemap(book, pages) {
  const urls = pages
    .filter(({ kind }) => kind !== 'source')
    .map(page => `<url><loc>${escapeHtml(addressOf(book, page))}</loc></url>`);
  return `<?xml version="1.0" encoding="UTF-8"?>\n<urlset xmlns="http://www.sitemaps.org/schemas/sitemap/0.9">\n${urls.join('\n')}\n</urlset>\n`;
}
