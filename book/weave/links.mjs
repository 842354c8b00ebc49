// A last look at the finished pages: every link and fragment leads somewhere, no id stands twice.
export function checkLinks(book, pages, files) {
  const ids = new Map(pages.map(({ href, html, file }) => [href, idsOf(book, file, href, html)]));
  for (const { href, html, file } of pages) {
    for (const [, url] of html.matchAll(/<a [^>]*?href="([^"]*)"/g)) {
      if (/^(https?:|mailto:)/.test(url)) continue;
      const [path, fragment] = url.split('#');
      const target = path || href;
      if (!ids.has(target) && !files.has(target)) book.problems.add(file, lineOf(book, file, url), `a link to nothing: ${url}`);
      else if (fragment && ids.has(target) && !ids.get(target).has(fragment)) book.problems.add(file, lineOf(book, file, url), `a link to nothing: ${target} has no "#${fragment}"`);
    }
  }
}

function idsOf(book, file, href, html) {
  const ids = new Set();
  for (const [, id] of html.matchAll(/<[^>]*? id="([^"]*)"/g)) {
    if (ids.has(id)) book.problems.add(file, 1, `the id "${id}" stands twice in ${href}; rename the section or box`);
    ids.add(id);
  }
  return ids;
}

function lineOf(book, file, url) {
  const page = book.pages.find(p => p.file === file);
  const at = page ? page.source.indexOf(`(${url.replace(page.href, '')}`) : -1;
  return at < 0 ? 1 : page.source.slice(0, at).split('\n').length;
}
