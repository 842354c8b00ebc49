// Prints the whole book:  node paper.mjs BOOK FILE.pdf   BOOK is the folder with the woven pages; where the file lies in it, too,
// the front page leads there.   Exit code 2: called wrongly, or there is no book; 1: it could not be printed.
import { existsSync, renameSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { countSheets } from './destinations.mjs';
import { linkFromFront } from './front-link.mjs';
import { printWhole } from './print.mjs';

const [book, file] = process.argv.slice(2);
if (process.argv.length !== 4 || !existsSync(join(book, 'index.html'))) {
  console.error('usage: node paper.mjs BOOK FILE.pdf   (BOOK is the folder with the woven pages)');
  process.exit(2);
}
const start = Date.now();
try {
  const pdf = await printWhole(book);
  writeFileSync(`${file}.new`, pdf);
  renameSync(`${file}.new`, file);
  const about = `${countSheets(pdf)} pages, ${Math.ceil(pdf.length / 1e6)}\u202fMB`;
  linkFromFront(book, file, about);
  console.log(`${file}: ${about}, in ${((Date.now() - start) / 1000).toFixed(0)} s`);
} catch (fault) {
  console.error(`The book is not printed. ${fault.message}`);
  process.exitCode = 1;
}
