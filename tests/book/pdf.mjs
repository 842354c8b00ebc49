// What stands in a PDF that Chromium wrote: its objects are plain text, its words are read by Poppler's tools.
import { execFileSync } from 'node:child_process';

const poppler = (tool, ...options) => execFileSync(tool, options, { encoding: 'utf8', maxBuffer: 1 << 28 });

// A form feed ends each sheet.
export const textOf = file => poppler('pdftotext', '-raw', file, '-');

// Each sheet's words, [{ xMin, xMax, word }, ...], and its width.
export const sheetsOf = file =>
  poppler('pdftotext', '-bbox', file, '-')
    .split('<page ')
    .slice(1)
    .map(sheet => ({
      width: Number(sheet.match(/width="([\d.]+)"/)[1]),
      words: [...sheet.matchAll(/<word xMin="([\d.-]+)" [^>]*xMax="([\d.-]+)"[^>]*>([^<]*)/g)].map(
        ([, xMin, xMax, word]) => ({ xMin: Number(xMin), xMax: Number(xMax), word }),
      ),
    }));

// { within: names of places, without: addresses } of all links, and the titles of the bookmarks.
export function linksOf(pdf) {
  const text = pdf.toString('latin1');
  const annotations = [...text.matchAll(/<<\/Type \/Annot\n\/Subtype \/Link[^]*?\nendobj/g)].map(([all]) => all);
  const found = pattern => annotations.map(all => all.match(pattern)?.[1]).filter(name => name !== undefined);
  return {
    all: annotations.length,
    within: found(/\/Dest \/(\S+)/),
    without: found(/\/URI \((.*)\)/),
    bookmarks: [...text.matchAll(/\n<<\/Title (\(.*\)|<[0-9A-F]*>)\n\/Dest/g)].map(([, title]) => title),
  };
}
