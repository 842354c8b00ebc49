// The words of readers, for the search and for titles: book/search.json, with the line of each place that it names.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { linesBefore } from './text.mjs';

export const WORDS = 'book/search.json';

export function readWords({ source }) {
  const text = readFileSync(join(source, WORDS), 'utf8');
  return { ...JSON.parse(text), lineOf: url => linesBefore(text, text.indexOf(`"${url}"`)) + 1 };
}
