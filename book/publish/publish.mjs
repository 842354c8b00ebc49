// Puts what is published into build/published: the book, its PDF, the headers and the handout, each with the version in its name, and
// their checksums.   node publish.mjs SOURCE BUILD VERSION   Exit code 2: called wrongly; 1: something is not built.
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { filesOf, zip } from './zip.mjs';

const [source, build, version] = process.argv.slice(2);
if (process.argv.length !== 5) {
  console.error('usage: node publish.mjs SOURCE BUILD VERSION');
  process.exit(2);
}
const name = `one-step-at-a-time-${version}`;
const book = join(build, 'book'),
  pdf = join(book, 'one-step-at-a-time.pdf'),
  handout = join(build, 'one-step-at-a-time.zip');
for (const made of [pdf, handout]) {
  if (existsSync(made)) continue;
  console.error(`${made} is not there; cmake --workflow --preset publish makes it, too`);
  process.exit(1);
}

const licence = folder => ({ name: `${folder}/LICENSE`, data: readFileSync(join(source, 'LICENSE')) });

// As readers take them home, without the marks of the listings.
function headers(folder) {
  const inBook = part =>
    readdirSync(join(source, 'code', part))
      .filter(file => file.endsWith('.h'))
      .map(file => ({ name: `${folder}/${part}/${file}`, data: readFileSync(join(book, 'headers', file)) }));
  return ['integrate', 'shelf'].flatMap(inBook);
}

const zipAs = (folder, files) => ({ [`${folder}.zip`]: zip([licence(folder), ...files(folder)]) });

const published = {
  ...zipAs(`${name}-book`, folder => filesOf(book, folder)),
  [`${name}-handout.zip`]: readFileSync(handout),
  ...zipAs(`${name}-headers`, headers),
  [`${name}.pdf`]: readFileSync(pdf),
};
const out = join(build, 'published');
rmSync(out, { recursive: true, force: true });
mkdirSync(out);
let sums = '';
for (const [file, data] of Object.entries(published)) {
  writeFileSync(join(out, file), data);
  sums += `${createHash('sha256').update(data).digest('hex')}  ${file}\n`;
  console.log(`${join(out, file)}  ${(data.length / 1e6).toFixed(1)} MB`);
}
writeFileSync(join(out, 'SHA256SUMS'), sums);
