// A page for every file that the book's programs and figures are made of, without the marks between which listings are cut.
import { readFileSync } from 'node:fs';
import { extname, join } from 'node:path';
import { codeLines } from './blocks.mjs';
import { linker } from './api.mjs';
import { highlightLines } from './highlight.mjs';
import { isMark } from './snippets.mjs';
import { escapeHtml } from './text.mjs';

export const sourceHref = path => `source-${path.replace(/[^\w-]+/g, '-').toLowerCase()}.html`;

export function sourcePages(book) {
  return [...book.sources].map(path => {
    const code = readFileSync(join(book.config.source, path), 'utf8').replace(/\n+$/, '');
    const shown = code
      .split('\n')
      .map((text, i) => ({ text, number: i + 1 }))
      .filter(({ text }) => !isMark(text));
    const lines = highlightLines(
      shown.map(({ text }) => text).join('\n'),
      extname(path).slice(1),
      linker(book.api, path),
    );
    const numbers = shown.map(({ number }) => number);
    const body =
      `<figure class="listing source"><figcaption><span class="file">${lines.length} lines</span></figcaption>` +
      `<pre><code>${codeLines(lines, numbers, { id: n => ` id="L${n}"`, gaps: false })}</code></pre></figure>`;
    return {
      href: sourceHref(path),
      title: path,
      kind: 'source',
      kicker: 'Source',
      titleHtml: `<code>${escapeHtml(path).replace(/\//g, '/<wbr>')}</code>`,
      body,
    };
  });
}
