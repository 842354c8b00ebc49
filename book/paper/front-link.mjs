// The front page leads to the PDF from the moment that it lies beside it: so the link never leads nowhere.
import { readFileSync, renameSync, writeFileSync } from 'node:fs';
import { basename, dirname, join, resolve } from 'node:path';

const LINE = /<p class="pdf">.*<\/p>\n/;

export function linkFromFront(book, file, about) {
  if (dirname(resolve(file)) !== resolve(book)) return;
  const front = join(book, 'index.html');
  const html = readFileSync(front, 'utf8').replace(LINE, '');
  const line = `<p class="pdf"><a href="${basename(file)}">The whole book as one PDF</a>, to print: ${about}.</p>\n`;
  writeFileSync(
    `${front}.new`,
    html.replace(/(?<=<div class="lead">.*<\/div>\n)/, () => line),
  );
  renameSync(`${front}.new`, front);
}
