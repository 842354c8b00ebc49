// Every address and every fragment leads somewhere on the disk, and no id stands twice on a page.
import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { folder, pages, parse } from './book.mjs';

const ids = new Map(
  pages.map(page => [
    page,
    parse(page)('[id]')
      .map((_, e) => e.attribs.id)
      .get(),
  ]),
);
const places = new Map(pages.map(page => [page, new Set(ids.get(page))]));
const twice = list => list.filter((id, i) => list.indexOf(id) !== i);
const there = path => existsSync(join(folder, path));
let links = 0;

function fault(page, tag, address) {
  if (/^data:/.test(address)) return null;
  if (/^[a-z]+:|^\/\//i.test(address))
    return tag === 'a' && /^https:/.test(address) ? null : `${address} leaves the disk`;
  ++links;
  const [path, fragment] = address.split('#').map(decodeURIComponent);
  const target = path || page;
  if (!there(target)) return `${address} leads to no file`;
  if (fragment && !places.get(target)?.has(fragment)) return `${address} leads to no such place in ${target}`;
  return null;
}

for (const page of pages) {
  test(page, () => {
    const $ = parse(page);
    const addresses = $('[href], [src]')
      .map((_, e) => ({ tag: e.name, address: e.attribs.href ?? e.attribs.src }))
      .get();
    const faults = addresses.map(({ tag, address }) => fault(page, tag, address)).filter(Boolean);
    assert.ok(!faults.length, faults.join('\n'));
    assert.equal(ids.get(page).length, places.get(page).size, `ids that stand twice: ${twice(ids.get(page))}`);
  });
}

test('what the style sheets name is there', () => {
  const sheets = new Set(
    pages.flatMap(page =>
      parse(page)('link[rel=stylesheet]')
        .map((_, e) => e.attribs.href)
        .get(),
    ),
  );
  for (const sheet of sheets) {
    const named = [...readFileSync(join(folder, sheet), 'utf8').matchAll(/url\(["']?(.*?)["']?\)/g)].map(
      found => found[1],
    );
    assert.deepEqual(
      named.filter(path => !path.startsWith('data:') && !there(join(dirname(sheet), path))),
      [],
    );
  }
});

test('each figure leads to its script and to the data that the script reads', () => {
  for (const page of pages) {
    const $ = parse(page);
    $('figure.plot').each((_, figure) => {
      const addresses = $(figure)
        .find('figcaption a')
        .map((_, a) => a.attribs.href)
        .get();
      if ($(figure).find('iframe').length) {
        assert.ok(
          addresses.some(address => /^source-.*-cpp\.html$/.test(address)),
          `${figure.attribs.id} in ${page} names no program`,
        );
        return;
      }
      const script = addresses.find(address => /^source-.*-gp\.html$/.test(address));
      assert.ok(script, `${figure.attribs.id} in ${page} names no script`);
      if (!/\bfile\(|\.csv/.test(parse(script)('pre').text())) return;
      assert.ok(
        addresses.some(address => address.endsWith('.csv')),
        `${figure.attribs.id} in ${page} names no data`,
      );
    });
  }
});

test('there were links to follow', () => assert.ok(links > 10 * pages.length, `${links} links`));
