// Makes what a page loads when somebody wants to edit:  node bundle.mjs OUT
//
// editor.js (CodeMirror and what joins it to the pages), worker.js (the compiler's thread, as text) and part-NN.js (the
// compiler's files and, behind them, headers precompiled by it, compressed and in Base64, since a page on disk can load a
// script and nothing else), and the licences of all.
import { mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';
import { runClang } from '@yowasp/clang';
import { bundled } from './bundled.mjs';
import { ABOVE, EXERCISE, FILM, STANDARD, headersOf } from './page/precompiled.js';
import { precompileArguments, treeOf } from './page/program-source.js';
import { givenIn, sourceForPage } from '../weave/page-sources.mjs';

const PART = 4 << 20; // letters of Base64 in a script
const [out] = process.argv.slice(2);
const modules = fileURLToPath(new URL('../../node_modules/', import.meta.url));
const here = fileURLToPath(new URL('.', import.meta.url));
const project = fileURLToPath(new URL('../../', import.meta.url));
const clang = dirname(createRequire(import.meta.url).resolve('@yowasp/clang'));

// Base64 in whole groups of four letters, so that each part can be decoded by itself.
function partsOf(file, bytes) {
  const base64 = gzipSync(bytes, { level: 7 }).toString('base64');
  return Array.from({ length: Math.ceil(base64.length / PART) }, (_, i) => ({
    file,
    base64: base64.slice(i * PART, (i + 1) * PART),
    last: (i + 1) * PART >= base64.length,
  }));
}

// The book's own headers that each one includes, as the page has them.
const drawn = Object.fromEntries(
  ['chapters/play.h', 'chapters/play/player.h'].map(path => [path, sourceForPage(project, path)]),
);
const INCLUDED = { [STANDARD]: {}, [FILM]: treeOf(drawn), [EXERCISE]: treeOf(givenIn(project)) };

// Each by the compiler of the page, and those above on top of the first.
async function precompiled() {
  const standard = readFileSync(join(here, 'standard.h'), 'utf8');
  await runClang(null, {}, { fetchProgress: () => {} }); // without words of its own
  const made = {};
  for (const name of [STANDARD, ...Object.keys(ABOVE)]) {
    let said = '';
    const decoder = new TextDecoder();
    const stderr = bytes => bytes && (said += decoder.decode(bytes, { stream: true }));
    const files = { ...headersOf([STANDARD, name], standard), ...made, ...INCLUDED[name] };
    const all = await runClang(precompileArguments(name), files, { stderr }).catch(() => ({}));
    if (!all[name]) throw new Error(`${name} can't be made of its header:\n${said}`);
    made[name] = all[name];
  }
  return made;
}

const write = (file, text) => writeFileSync(join(out, file), text);
const compiled = about => `Object.assign((globalThis.Compiled ??= {}), ${JSON.stringify(about)});\n`;

rmSync(out, { recursive: true, force: true });
mkdirSync(out, { recursive: true });
const own = readdirSync(clang)
  .filter(file => /\.(wasm|tar)$/.test(file))
  .sort()
  .flatMap(file => partsOf(file, readFileSync(join(clang, file))));
const parts = [...own, ...Object.entries(await precompiled()).flatMap(([name, bytes]) => partsOf(name, bytes))];
parts.forEach(({ file, base64, last }, i) =>
  write(`part-${String(i).padStart(2, '0')}.js`, `Compiled.part(${JSON.stringify(file)}, "${base64}", ${last});\n`),
);
const [worker, runner, editor] = await Promise.all(['worker.js', 'runner.js', 'editor.js'].map(bundled));
write('worker.js', compiled({ worker: worker.text, runner: runner.text }));
// How many parts are needed, from the first, and how many letters each has.
const about = { needed: { step: own.length, program: parts.length }, sizes: parts.map(({ base64 }) => base64.length) };
write('editor.js', compiled(about) + editor.text);
const packages = new Set([worker, runner, editor].flatMap(({ packages }) => packages));
write('LICENCES.txt', [readFileSync(join(here, 'LICENCES.txt'), 'utf8'), ...licences()].join('\n'));

// Of all packages that went into the editor and the thread.
function licences() {
  return [...packages].sort().map(name => {
    const folder = join(modules, name);
    const files = readdirSync(folder).filter(file => /^licen[cs]e/i.test(file));
    return [`---- ${name} ----`, '', ...files.map(file => readFileSync(join(folder, file), 'utf8'))].join('\n');
  });
}
