// Every test of the weaver, in one process: most of what a run costs is to start, and to load what typesets formulas.
import { readdirSync } from 'node:fs';

const here = new URL('.', import.meta.url);
const files = readdirSync(here).filter(file => file.endsWith('.test.mjs') && !import.meta.url.endsWith(`/${file}`));
for (const file of files) await import(new URL(file, here));
