// A script of page/ with all that it imports, as one text for a page.
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';

const PACKAGE = /node_modules\/((?:@[^/]+\/)?[^/]+)\//;

/** @returns { text, packages }: with the names of the packages that went into it */
export async function bundled(entry) {
  const folder = fileURLToPath(new URL('page/', import.meta.url));
  const { outputFiles, metafile } = await build({
    entryPoints: [folder + entry],
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
    absWorkingDir: folder,
  });
  const packages = Object.keys(metafile.inputs).map(input => input.match(PACKAGE)?.[1]);
  return { text: outputFiles[0].text, packages: packages.filter(Boolean) };
}
