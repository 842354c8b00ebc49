// Makes what a page loads when somebody wants to edit:  node bundle.mjs OUT
//
// editor.js (CodeMirror and what joins it to the pages), worker.js (the compiler's thread, as text) and part-NN.js (the
// compiler's files, compressed and in Base64, since a page on disk can load a script and nothing else), and the licences of all.
import { mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';
import { build } from 'esbuild';

const PART = 4 << 20; // letters of Base64 in a script
const [out] = process.argv.slice(2);
const modules = fileURLToPath(new URL('../../node_modules/', import.meta.url));
const packages = new Set();
const here = fileURLToPath(new URL('.', import.meta.url));
const clang = dirname(createRequire(import.meta.url).resolve('@yowasp/clang'));

async function bundled(entry) {
  const { outputFiles, metafile } = await build({
    entryPoints: [join(here, 'page', entry)],
    bundle: true,
    minify: true,
    write: false,
    format: 'iife',
    platform: 'browser',
    target: 'es2022',
    loader: { '.h': 'text' },
    define: { 'import.meta.url': '"http://nowhere.invalid/"' }, // the thread has the files, and asks nobody
    external: ['node:fs/promises'],
    legalComments: 'none',
    logLevel: 'warning',
    metafile: true,
    absWorkingDir: here,
  });
  for (const input of Object.keys(metafile.inputs)) {
    const [, name] = input.match(/node_modules\/((?:@[^/]+\/)?[^/]+)\//) ?? [];
    if (name) packages.add(name);
  }
  return outputFiles[0].text;
}

// Base64 in whole groups of four letters, so that each part can be decoded by itself.
function partsOf(file) {
  const base64 = gzipSync(readFileSync(join(clang, file)), { level: 9 }).toString('base64');
  return Array.from({ length: Math.ceil(base64.length / PART) }, (_, i) => ({
    file,
    base64: base64.slice(i * PART, (i + 1) * PART),
    last: (i + 1) * PART >= base64.length,
  }));
}

rmSync(out, { recursive: true, force: true });
mkdirSync(out, { recursive: true });
const parts = readdirSync(clang)
  .filter(file => /\.(wasm|tar)$/.test(file))
  .sort()
  .flatMap(partsOf);
parts.forEach(({ file, base64, last }, i) =>
  writeFileSync(
    join(out, `part-${String(i).padStart(2, '0')}.js`),
    `Compiled.part(${JSON.stringify(file)}, "${base64}", ${last});\n`,
  ),
);
const letters = parts.reduce((sum, { base64 }) => sum + base64.length, 0);
const [worker, runner] = [await bundled('worker.js'), await bundled('runner.js')];
const about = { parts: parts.length, megabytes: Math.round(letters / 1e6) };
writeFileSync(
  join(out, 'worker.js'),
  `Object.assign((globalThis.Compiled ??= {}), ${JSON.stringify({ ...about, worker, runner })});\n`,
);
writeFileSync(join(out, 'editor.js'), await bundled('editor.js'));
writeFileSync(join(out, 'LICENCES.txt'), [readFileSync(join(here, 'LICENCES.txt'), 'utf8'), ...licences()].join('\n'));

// Of all packages that went into the editor and the thread.
function licences() {
  return [...packages].sort().map(name => {
    const folder = join(modules, name);
    const files = readdirSync(folder).filter(file => /^licen[cs]e/i.test(file));
    return [`---- ${name} ----`, '', ...files.map(file => readFileSync(join(folder, file), 'utf8'))].join('\n');
  });
}
