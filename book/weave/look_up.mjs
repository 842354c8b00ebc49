// Looks up what a page names in one of the chapters, or reports what is wrong with the name.
import { numberFault } from './numbers.mjs';
import { didYouMean, nameOneOf } from './problems.mjs';

export function findChapter(book, name, report) {
  const chapter = book.chapters.get(name);
  if (!chapter) report(`there is no chapter "${name}".${nameOneOf(name, book.chapters.keys())}`);
  return chapter;
}

export function findNumber(book, page, name, report) {
  const [owner, own] = name.includes('/') ? name.split('/') : [page.owner, name];
  const chapter = book.programs.get(owner);
  const number = chapter?.numbers.get(own);
  const fault = number && numberFault(number);
  if (fault) report(`${fault}; ${chapter.program} wrote it`);
  if (number) return { ...number, chapter };
  const elsewhere = [...book.programs.values()].filter(c => c.numbers.has(own)).map(c => `${c.name}/${own}`);
  const near = didYouMean(own, chapter?.numbers.keys() ?? []).replace(/"(?=\w)/g, name === own ? '"' : `"${owner}/`);
  if (!chapter && !name.includes('/'))
    report(`this page has no program; name the number's chapter, too: \\number{${elsewhere[0] ?? `2-euler/${name}`}}`);
  else if (!chapter)
    report(
      `there is no chapter "${owner}" that could write the number "${name}".${nameOneOf(owner, book.chapters.keys())}`,
    );
  else
    report(
      `unknown number "${name}"; ${chapter.program} writes none of that name.${elsewhere.length ? didYouMean(elsewhere[0], elsewhere) : near || ` Let it do so: record.number("${own}", ...)`}`,
    );
  return null;
}
