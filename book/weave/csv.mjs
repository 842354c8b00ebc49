import { readFileSync } from 'node:fs';

// The rows of a CSV file as arrays of text; a quoted field may hold commas and doubled quotes.
export function readCsv(path) {
  return readFileSync(path, 'utf8')
    .split(/\r?\n/)
    .filter(line => line !== '')
    .map(splitRow);
}

function splitRow(line) {
  const fields = [];
  for (const [, quoted, plain] of line.matchAll(/(?:^|,)(?:"((?:[^"]|"")*)"|([^,]*))/g)) {
    fields.push(quoted === undefined ? plain.trim() : quoted.replace(/""/g, '"'));
  }
  return fields;
}

// The rows as objects keyed by the names in the first row.
export function readRecords(path) {
  const [header = [], ...rows] = readCsv(path);
  return rows.map(row => Object.fromEntries(header.map((name, i) => [name, row[i] ?? ''])));
}
