// The page about this copy: its edition and what is new in it, how to cite it, and where to tell of a mistake. And the page that a
// server shows for an address that leads nowhere.
import { escapeHtml, smarten } from './text.mjs';

export function aboutPage(book) {
  const { version, url, report } = book.config;
  const name = escapeHtml(smarten(book.title));
  const at = url ? `,\n  url     = {${url}}` : '';
  const bibtex = `@book{onestep,\n  author  = {{The authors of ${book.title}}},\n  title   = {${book.title}},\n  edition = {${version}}${at}\n}`;
  const body = `<p class="lead">This is version ${escapeHtml(version)} of <i>${name}</i>. What is new in it stands in the <a href="changelog.html">changelog</a>.</p>
<h2 id="how-to-cite">How to cite it</h2>
<p>The authors of ${name}. <i>${name}</i>. Version ${escapeHtml(version)}.${url ? ` <a href="${escapeHtml(url)}">${escapeHtml(url)}</a>` : ''} As BibTeX, for those who write LaTeX:</p>
<div class="codebox"><pre><code>${escapeHtml(bibtex)}</code></pre></div>
<p>Name the version: numbers are measured anew in each. Programs that read citations find it in <code>CITATION.cff</code> beside the sources.</p>
<h2 id="report-a-mistake">Report a mistake</h2>
<p>${
    report
      ? `<a href="${escapeHtml(report)}">Here</a>, with the page, the sentence, and what you found instead.`
      : 'Write to whoever gave you this copy, with the page, the sentence, and what you found instead.'
  } Of a number, say what it should be and how you know: a test is the best report, and <a href="preface.html">the preface</a> says how they are run.</p>
<h2 id="licences">Licences</h2>
<p>Prose and figures are under CC BY 4.0: copy, change and sell them, and name where they come from. Code is under MIT-0: do with it what you like, and name nobody.
The fonts, KaTeX, MiniSearch and uPlot have licences of their own, which lie beside their files.</p>`;
  return {
    href: 'about.html',
    title: 'About this copy',
    kind: 'about',
    body,
    sections: [
      ['how-to-cite', 'How to cite it'],
      ['report-a-mistake', 'Report a mistake'],
      ['licences', 'Licences'],
    ].map(([id, title]) => ({ id, title })),
  };
}

export const lostPage = book => ({
  href: '404.html',
  title: 'There is no such page',
  kind: 'lost',
  body: `<p class="lead">The address leads nowhere, or no longer. The search knows every section, exercise and header.</p>
<ol class="contents">
${book.pages
  .filter(({ isAside }) => !isAside)
  .map(
    ({ href, number, title }) =>
      `<li><a href="${href}"><span class="no">${number || ''}</span><span class="title">${escapeHtml(smarten(title))}</span></a></li>`,
  )
  .join('\n')}
</ol>`,
});
