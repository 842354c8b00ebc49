// The page about this copy: its edition and what is new in it, how to cite it, and where to tell of a mistake. And the page that a
// server shows for an address that leads nowhere.
import { contentsHtml } from './blocks.mjs';
import { onTheWay } from './book.mjs';
import { escapeHtml, slug, smarten } from './text.mjs';

export function aboutPage(book) {
  const { version, url, report } = book.config;
  const name = escapeHtml(smarten(book.title));
  const at = url ? `,\n  url     = {${url}}` : '';
  const bibtex = `@book{onestep,\n  author  = {{The authors of ${book.title}}},\n  title   = {${book.title}},\n  edition = {${version}}${at}\n}`;
  const parts = [
    [
      'How to cite it',
      `<p>The authors of ${name}. <i>${name}</i>. Version ${escapeHtml(version)}.${url ? ` <a href="${escapeHtml(url)}">${escapeHtml(url)}</a>` : ''} As BibTeX, for those who write LaTeX:</p>
<div class="codebox"><pre><code>${escapeHtml(bibtex)}</code></pre></div>
<p>Name the version: numbers are measured anew in each. Programs that read citations find it in <code>CITATION.cff</code> beside the sources.</p>`,
    ],
    [
      'Report a mistake',
      `<p>${report ? `<a href="${escapeHtml(report)}">Here</a>` : 'Write to whoever gave you this copy'}, with the page, the sentence, and what you found instead. Of a number, say what it should be and how you know: a test is the best report, and <a href="checked.html">how the book is checked</a> says how they are run.</p>`,
    ],
    [
      'Licences',
      `<p>Prose and figures are under CC BY 4.0: copy, change and sell them, and name where they come from. Code is under MIT-0: do with it what you like, and name nobody.
The fonts, KaTeX, MiniSearch, uPlot, and the compiler and editor of the page have licences of their own, which lie beside their files.</p>`,
    ],
  ].map(([heading, html]) => ({ id: slug(heading), title: heading, html }));
  return {
    href: 'about.html',
    title: 'About this copy',
    kind: 'about',
    body: [
      `<p class="lead">This is version ${escapeHtml(version)} of <i>${name}</i>. What is new in it stands in the <a href="changelog.html">changelog</a>.</p>`,
      ...parts.map(({ id, title, html }) => `<h2 id="${id}">${title}</h2>\n${html}`),
    ].join('\n'),
    sections: parts.map(({ id, title }) => ({ id, title })),
  };
}

export const lostPage = book => ({
  href: '404.html',
  title: 'There is no such page',
  kind: 'lost',
  body: `<p class="lead">The address leads nowhere, or no longer. The search knows every section, exercise and header.</p>
${contentsHtml(book.pages.filter(onTheWay))}`,
});
