// The pages that stand for all: every page that has prose, and of each sort of page that is made of the code, the smallest and
// the largest. The tier `thorough` has the others.
import { kind, pages, read } from './book.mjs';

export const isMade = page => ['api', 'source'].includes(kind(page));

// "source cpp", "api struct", "api code" for the page of a header: what makes two pages alike.
function sortOf(page) {
  if (kind(page) === 'source') return `source ${page.match(/-(\w+)\.html$/)[1]}`;
  return `api ${read(page).match(/<h1><span class="kicker">(\w+)/)?.[1]}`;
}

const sorts = {};
for (const page of pages.filter(isMade)) (sorts[sortOf(page)] ??= []).push(page);
const ends = Object.values(sorts).flatMap(sort => {
  const bySize = sort.sort((a, b) => read(a).length - read(b).length);
  return [bySize[0], bySize.at(-1)];
});

export const chosen = pages.filter(page => !isMade(page) || ends.includes(page));
export const others = pages.filter(page => !chosen.includes(page));
// What a test is asked for:  node some.test.mjs BUILD [others]
export const asked = process.argv.includes('others') ? others : chosen;
