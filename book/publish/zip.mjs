// Zips a folder, the same bytes from the same files: in order, under one date, and saying of each only whether it can be run.
//   node zip.mjs FOLDER FILE.zip
import { readFileSync, readdirSync, statSync, writeFileSync } from 'node:fs';
import { basename, join, relative } from 'node:path';
import { pathToFileURL } from 'node:url';
import { deflateRawSync } from 'node:zlib';

const DATE = (1 << 5) | 1; // the first of January 1980, the first day that a zip knows
const UNIX = 3 << 8;
const VERSION = 20;
const UTF8 = 1 << 11;
const DEFLATED = 8;

// All files of a folder, by their paths: [{ name, data, runs }]
export function filesOf(folder, within = basename(folder)) {
  return readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter(entry => entry.isFile())
    .map(entry => join(entry.parentPath ?? entry.path, entry.name))
    .map(path => ({
      name: `${within}/${relative(folder, path)}`,
      data: readFileSync(path),
      runs: (statSync(path).mode & 0o100) !== 0,
    }));
}

export function zip(files) {
  const sorted = [...files].sort((a, b) => (a.name < b.name ? -1 : 1));
  const parts = [],
    directory = [];
  let at = 0;
  for (const file of sorted) {
    const name = Buffer.from(file.name);
    const packed = deflateRawSync(file.data, { level: 9 });
    const about = aboutFile(file.data, packed, name);
    const head = Buffer.concat([numbers([4, 0x04034b50]), about, name]);
    parts.push(head, packed);
    directory.push(Buffer.concat([entryHead(), about, entryFoot(file.runs, at), name]));
    at += head.length + packed.length;
  }
  const list = Buffer.concat(directory);
  const n = sorted.length;
  const end = numbers([4, 0x06054b50], [2, 0], [2, 0], [2, n], [2, n], [4, list.length], [4, at], [2, 0]);
  return Buffer.concat([...parts, list, end]);
}

const entryHead = () => numbers([4, 0x02014b50], [2, UNIX | VERSION]);

// What a file's head and its entry in the directory have in common.
const aboutFile = (data, packed, name) =>
  numbers(
    [2, VERSION],
    [2, UTF8],
    [2, DEFLATED],
    [2, 0],
    [2, DATE],
    [4, crc32(data)],
    [4, packed.length],
    [4, data.length],
    [2, name.length],
    [2, 0],
  );

const entryFoot = (runs, at) =>
  numbers([2, 0], [2, 0], [2, 0], [4, ((0o100644 | (runs ? 0o111 : 0)) << 16) >>> 0], [4, at]);

function numbers(...fields) {
  const buffer = Buffer.alloc(fields.reduce((sum, [size]) => sum + size, 0));
  let at = 0;
  for (const [size, value] of fields) at = buffer.writeUIntLE(value, at, size);
  return buffer;
}

const TABLE = Uint32Array.from({ length: 256 }, (_, byte) => {
  let c = byte;
  for (let bit = 0; bit < 8; ++bit) c = c & 1 ? 0xedb88320 ^ (c >>> 1) : c >>> 1;
  return c;
});

function crc32(data) {
  let c = 0xffffffff;
  for (const byte of data) c = TABLE[(c ^ byte) & 0xff] ^ (c >>> 8);
  return (c ^ 0xffffffff) >>> 0;
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  const [folder, file] = process.argv.slice(2);
  if (process.argv.length !== 4) {
    console.error('usage: node zip.mjs FOLDER FILE.zip');
    process.exit(2);
  }
  writeFileSync(file, zip(filesOf(folder)));
}
