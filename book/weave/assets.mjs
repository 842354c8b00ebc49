// Style sheet, scripts, fonts and data files that lie beside the pages.
import { copyFileSync, cpSync, existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';
import { copyFilms } from './films.mjs';
import { LIVE_SCRIPTS, colourRules } from './live.mjs';
import { readLooks } from './method-looks.mjs';
import { exercisesScript, sourcesScript } from './page-sources.mjs';
import { isMark } from './snippets.mjs';

const require = createRequire(import.meta.url);
const theme = fileURLToPath(new URL('../theme/', import.meta.url));
const livePage = fileURLToPath(new URL('../live/page/', import.meta.url));
const packageFolder = name => dirname(require.resolve(`${name}/package.json`));

const FONTS = [
  [
    '@fontsource-variable/source-serif-4',
    'source-serif-4',
    ['latin-wght-normal', 'latin-wght-italic', 'greek-wght-normal', 'greek-wght-italic'],
  ],
  ['@fontsource-variable/inter', 'inter', ['latin-wght-normal', 'greek-wght-normal']],
  ['@fontsource-variable/jetbrains-mono', 'jetbrains-mono', ['latin-wght-normal', 'greek-wght-normal']],
];

// What every page can do, in one file.
const SCRIPTS = ['book', 'values', 'marks', 'search', 'change-it', 'edit'];

// One file of several scripts, without the lines that only explain and without indents; in words over several lines, an indent
// would be part of the words.
function joinScripts(files) {
  const lines = files.flatMap(file => readFileSync(file, 'utf8').split('\n'));
  const open = lines.find(line => line.split('`').length % 2 === 0);
  if (open) throw new Error(`a script of the page has words over several lines: ${open.slice(0, 200)}`);
  const code = lines.map(line => line.trimStart()).filter(line => line && !line.startsWith('//'));
  return code.join('\n');
}

export function copyAssets(book, out) {
  for (const file of ['book.css', 'print.css', 'whole.css', 'find.js', 'exercises.js', 'pick-a-method.js', 'wall.html'])
    copyFileSync(join(theme, file), join(out, file));
  writeFileSync(join(out, 'book.js'), joinScripts(SCRIPTS.map(name => join(theme, `${name}.js`))));
  const minisearch = join(dirname(require.resolve('minisearch')), '../..');
  copyFileSync(join(minisearch, 'dist/umd/index.js'), join(out, 'minisearch.js'));
  copyFileSync(join(minisearch, 'LICENSE.txt'), join(out, 'minisearch-LICENSE.txt'));
  if (book.config.compiler) {
    cpSync(book.config.compiler, join(out, 'compiler'), { recursive: true });
    writeFileSync(join(out, 'compiler', 'sources.js'), sourcesScript(book));
    if (book.config.judges) writeFileSync(join(out, 'compiler', 'exercises.js'), exercisesScript(book));
  }
  if (book.config.live) copyLive(book, join(out, 'live'));
  copyFilms(book, out);
  copyFonts(join(out, 'fonts'));
  copyKatex(join(out, 'katex'));
  for (const chapter of book.programs.values()) copyData(chapter.data, join(out, 'data', chapter.name));
  copyData(book.config.cards, join(out, 'data', 'cards'));
  copyData(book.config.shelf, join(out, 'data', 'shelf'));
  copyHeaders(book, join(out, 'headers'));
}

// The module stands in a script, compressed and in Base64, since a page on disk can load a script and nothing else.
function copyLive({ config, live, labels }, folder) {
  mkdirSync(folder, { recursive: true });
  const uplot = dirname(require.resolve('uplot'));
  const scripts = [join(uplot, 'uPlot.iife.min.js'), ...LIVE_SCRIPTS.map(name => join(livePage, `${name}.js`))];
  writeFileSync(join(folder, 'live.js'), joinScripts(scripts));
  copyFileSync(join(uplot, '../LICENSE'), join(folder, 'uplot-LICENSE.txt'));
  const script = readFileSync(join(theme, 'figure.gp'), 'utf8');
  const colours = colourRules(readLooks(join(config.methods, 'methods.csv')), script);
  const rules = [join(uplot, 'uPlot.min.css'), join(livePage, 'live.css')].map(file => readFileSync(file, 'utf8'));
  writeFileSync(join(folder, 'live.css'), [colours, ...rules].join('\n'));
  writeFileSync(
    join(folder, 'compiled.js'),
    `(globalThis.Live ??= {}).compiled = "${gzipSync(readFileSync(config.live)).toString('base64')}";\n`,
  );
  const brought = new Map(); // a page and a table -> the figure that brings it
  for (const description of live.values()) {
    const { name, tables = {} } = description;
    const page = labels.get(`figure:${name}`).page.name;
    const bringers = Object.keys(tables).map(table => {
      const key = `${page} ${table}`;
      if (!brought.has(key)) brought.set(key, name);
      return [table, brought.get(key)];
    });
    copyFigure(config.source, description, join(folder, `${name}.js`), bringers);
  }
}

// A figure brings its own description, so that no page has those of all, and a table unless another figure of its page does.
function copyFigure(source, description, to, bringers) {
  const { name, folder } = description;
  const one = figure => `globalThis.Live.descriptions['${figure}']`;
  const [own, lent] = [true, false].map(mine => bringers.filter(([, bringer]) => (bringer === name) === mine));
  const tables = Object.fromEntries(own.map(([table]) => [table, description.tables[table]]));
  const described = `(globalThis.Live.descriptions ??= {})['${name}'] = ${JSON.stringify({ ...description, tables })};\n`;
  const borrowed = lent.map(
    ([table, bringer]) =>
      `Object.defineProperty(${one(name)}.tables, '${table}', { get: () => ${one(bringer)}.tables['${table}'] });\n`,
  );
  writeFileSync(to, described + borrowed.join('') + joinScripts([join(source, folder, `${name}.js`)]));
}

function copyFonts(folder) {
  mkdirSync(folder, { recursive: true });
  for (const [name, file, faces] of FONTS) {
    const from = packageFolder(name);
    for (const face of faces)
      copyFileSync(join(from, 'files', `${file}-${face}.woff2`), join(folder, `${file}-${face}.woff2`));
    copyFileSync(join(from, 'LICENSE'), join(folder, `${file}-LICENSE.txt`));
  }
}

// The older font formats are for browsers that could not show the rest of the page either.
function copyKatex(folder) {
  const from = join(packageFolder('katex'), 'dist');
  mkdirSync(join(folder, 'fonts'), { recursive: true });
  const css = readFileSync(join(from, 'katex.min.css'), 'utf8').replace(
    /,url\([^)]*\.(woff|ttf)\) format\("[^"]*"\)/g,
    '',
  );
  writeFileSync(join(folder, 'katex.css'), css);
  copyFileSync(join(from, '../LICENSE'), join(folder, 'LICENSE.txt'));
  for (const file of readdirSync(join(from, 'fonts')))
    if (file.endsWith('.woff2')) copyFileSync(join(from, 'fonts', file), join(folder, 'fonts', file));
}

function copyData(data, folder) {
  if (!existsSync(data)) return;
  mkdirSync(folder, { recursive: true });
  for (const file of readdirSync(data)) if (file.endsWith('.csv')) copyFileSync(join(data, file), join(folder, file));
}

// The headers that readers take home, without the marks between which the book cuts its listings.
function copyHeaders({ api, config }, folder) {
  mkdirSync(folder, { recursive: true });
  for (const { file, name } of api.headers.values()) {
    const lines = readFileSync(join(config.source, file), 'utf8').split('\n');
    writeFileSync(join(folder, name), lines.filter(line => !isMark(line)).join('\n'));
  }
}
