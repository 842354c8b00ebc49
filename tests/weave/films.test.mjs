// Films: what the chapter shows of a program that makes one, and what is missing.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { CHAPTER, paragraph, refuses, weaves } from './weaver.mjs';

const PROGRAM = 'chapters/2-euler/play.cpp';
const code = [
  PROGRAM,
  '// SPDX-License-Identifier: MIT-0\n// Chapter 2: a drone.\n// [main]\nint main() {\n  return 0;\n}\n// [main]\n',
];
const pictures = [
  [0.1, ['trail', 0, 0, 1]],
  [0.1, ['trail', 0, 1, 1]],
  [0.1, ['trail', 0, 2, 1], ['circle', 1, 2, 1, 0.5], ['label', 2, 1, 0.5, 'a < b']],
];
const page = [
  'built/2-euler/films/play.html',
  `<title>A film</title>\n<script>const view = [0, 0, 4, 2], speed = 1, names = ['Euler', 'true', 'scenery'], pictures = ${JSON.stringify(pictures)};</script>\n`,
];
const listing = `\\listing{${PROGRAM}, main, A drone}\n\n`;
const film = '\\film{play, A drone flies}\nLook at the dots. \\look\n\\endfilm';

test('a film: its page within the figure, as high as its pictures want, and its program', () => {
  const read = weaves(code, page, paragraph(listing + film));
  const html = read('2-euler.html');
  assert.match(html, /<figure class="plot" id="figure-play-2-euler">/);
  assert.match(
    html,
    /style="--shape:2\.000"><iframe src="films\/2-euler-play\.html" data-program="play" data-source="chapters\/2-euler\/play\.cpp" title="A drone flies"/,
  );
  assert.match(html, /Made by <a href="source-chapters-2-euler-play-cpp\.html">play\.cpp<\/a>/);
  assert.match(read('films/2-euler-play.html'), /<title>A drone flies<\/title>[^]*url\(\.\.\/fonts\/[^]*const view/);
});

test('the still of a film: its last picture, with what trails have left, in the colours of the book', () => {
  const html = weaves(code, page, paragraph(listing + film))('2-euler.html');
  const [still] = html.match(/<svg class="still"[^]*?<\/svg>/);
  assert.match(still, /^<svg class="still" viewBox="0 0 480 240" role="img" aria-label="A drone flies">/);
  assert.match(still, /<g style="color:var\(--plot-1\)"><path d="M0,120l240,0"\/><\/g>/);
  assert.match(still, /<g style="color:var\(--plot-7\)"><circle cx="240" cy="120" r="60"\/><\/g>/);
  assert.match(still, /<text x="120" y="180">a &lt; b<\/text><\/svg>$/);
});

test('a film that no program makes', () =>
  refuses(
    [code, page, paragraph(listing + film), paragraph('\\film{fly, It flies}\nLook. \\look\n\\endfilm')],
    [CHAPTER, '\\film{fly', 'there is no chapters/2-euler/fly.cpp that makes the film "fly". Did you mean "play"?'],
  ));

test('a film that is not made yet', () =>
  refuses(
    [code, paragraph(listing + film)],
    [CHAPTER, '\\film{play', `${PROGRAM} has not made its film; is the chapter built?`],
  ));

test('a film that no chapter shows', () =>
  refuses(
    [code, page, paragraph(listing)],
    [PROGRAM, '', 'no \\film{play, Title} in chapters/2-euler/chapter.md shows this film'],
  ));

test('a line of the program that no listing shows', () =>
  refuses(
    [[PROGRAM, `${code[1]}int left_out;\n`], page, paragraph(listing + film)],
    [PROGRAM, 'int left_out', 'no \\listing of chapters/2-euler/chapter.md shows this line'],
  ));

const prints = ['built/2-euler/films/play.txt', 'Open play.html\nit flies 3 m\n'];
const quoted = words => paragraph(`\`\`\`prints\n${words}\n\`\`\``);

test('what a program prints, quoted to the letter', () => {
  weaves(code, page, prints, paragraph(listing + film), quoted('it flies 3 m'));
  refuses(
    [code, page, prints, paragraph(listing + film), quoted('it flies 4 m')],
    [CHAPTER, '```prints', 'no program of the chapter prints this; they print films/play.txt'],
  );
});

const change = paragraph(
  '\\change{Fly away}\n```diff\n-   return 0;\n+   return 1;\n```\nIt flies away.\n\n```prints\nit flies 9 m\n```\n\\endchange',
);
const rows = [
  { sign: '-', code: '  return 0;' },
  { sign: '+', code: '  return 1;' },
];
const made = { name: 'fly-away', title: 'Fly away', program: 'play', edits: [{ line: 5, rows }] };
const filmed = [
  ['built/2-euler/changes/films.json', JSON.stringify([made])],
  ['built/2-euler/changes/fly-away.txt', 'Open play.html\nit flies 9 m\n'],
  ['built/2-euler/changes/fly-away.html', page[1]],
];

test('what to change in a program: lines that go, and lines that come, here and in the listing to be applied', () => {
  const read = weaves(code, page, ...filmed, paragraph(listing + film), change);
  const html = read('2-euler.html');
  assert.match(
    html,
    /<div class="change" id="change-fly-away" data-program="play" data-film="changes\/2-euler-fly-away.html">/,
  );
  assert.match(html, /<del>-   return 0;<\/del>\n<ins>\+   return 1;<\/ins>/);
  const [template] = html.match(/<template data-for="listing-\d+">[^]*?<\/template>/);
  assert.match(
    template,
    /data-n="5"><\/span><del>  .*0.*<\/del>\n<span class="ln" data-n=""><\/span><ins>  .*1.*<\/ins>\n<span class="ln" data-n="6">/,
  );
  assert.match(read('changes/2-euler-fly-away.html'), /<title>Fly away<\/title>/);
});

test('a change that was not made, and one that prints something else', () => {
  refuses(
    [code, page, paragraph(listing + film), change],
    [CHAPTER, '\\change{Fly away', 'the program has not been changed so and run; is the chapter built?'],
  );
  const [, prints, ...rest] = filmed;
  refuses(
    [code, page, filmed[0], [prints[0], 'it flies 8 m\n'], ...rest, paragraph(listing + film), change],
    [CHAPTER, '\\change{Fly away', 'the changed program prints "it flies 8 m", which its box should quote'],
  );
});
