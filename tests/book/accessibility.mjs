// What axe finds wrong with the page that a tab shows, one line each. The strokes of its pictures are gone afterwards.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';

const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

export async function accessibility(tab) {
  await tab.evaluate(removeStrokes);
  await tab.evaluate(axe);
  // preload would make axe fetch the style sheets, which a page on disk may not
  const { violations } = await tab.evaluate(() => {
    const rules = { 'target-size': { enabled: innerWidth < 500 } }; // where fingers tap
    return axe.run(document, { resultTypes: ['violations'], preload: false, rules });
  });
  return violations.map(
    ({ id, help, nodes }) =>
      `axe ${id}: ${help}, ${nodes.length} times, first at ${nodes[0].target} ${nodes[0].any[0]?.message ?? ''}`,
  );
}

// Runs within a page. More than half of a chapter's elements are the lines and points of its figures, and axe looks at each; but
// what it can say of a picture is said of words, names and roles.
function removeStrokes() {
  const says = 'text, title, desc, a, foreignObject, [role], [tabindex], [aria-label], [aria-labelledby]';
  for (const svg of document.querySelectorAll('svg'))
    for (const part of svg.querySelectorAll('*'))
      if (!part.querySelector(says) && !part.parentElement.closest('text, a, foreignObject') && !part.matches(says))
        part.remove();
}
