// The page of the things that move has every thing of chapters/cast.h and cast_of_many.h, each with a picture and with the
// chapters where it moves.   node tests/book/cast.test.mjs build SOURCE
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { parse } from './book.mjs';

const chapters = join(process.argv[3] ?? '.', 'chapters');
const $ = parse('cast.html');

// { name, moves } of what a header defines at the start of a line; a number does not move.
function definitions(text) {
  const found = [
    ...text.matchAll(
      /^(?!struct|class|namespace|using|template)(?:inline |constexpr |const )*([\w:]+(?:<.*>)?)\s+(\w+)\s*[{(=;]/gm,
    ),
  ];
  return found.map(([, type, name]) => ({ name, moves: !['double', 'long'].includes(type) }));
}
const cast = ['cast.h', 'cast_of_many.h'].flatMap(file => definitions(readFileSync(join(chapters, file), 'utf8')));

// A chapter's code without comments and strings.
const code = folder =>
  readdirSync(join(chapters, folder), { recursive: true })
    .filter(file => /\.(h|cpp)$/.test(file))
    .map(file => readFileSync(join(chapters, folder, file), 'utf8').replace(/\/\/.*|"(?:\\.|[^"\\\n])*"/g, ''))
    .join('\n');
const pages = new Map(
  readdirSync(chapters)
    .filter(folder => /^\d-|^front$/.test(folder))
    .map(folder => [folder === 'front' ? 'index.html' : `${folder}.html`, code(folder)]),
);
const moving = names =>
  [...pages]
    .filter(([, text]) => names.some(name => new RegExp(`(?<![\\w.>])${name}\\b`).test(text)))
    .map(([page]) => page);

const named = within =>
  $(within)
    .find('code')
    .map((_, e) => $(e).text().replace(/\(.*/, ''))
    .get();
const figures = $('figure.plot')
  .get()
  .map(figure => ({
    names: named(figure).filter(name => cast.some(thing => thing.name === name)),
    links: $(figure)
      .find('figcaption a')
      .map((_, a) => $(a).attr('href'))
      .get()
      .filter(href => pages.has(href)),
    drawn: [$(figure).find('.wide'), $(figure).find('.narrow template').contents()].every(
      drawing => drawing.find('svg :is(path, use)').length > 2,
    ),
  }));

test('things are found', () => {
  assert.ok(cast.length > 30, `${cast.length} things`);
  assert.deepEqual(
    definitions(
      'inline const scenes::Cat<> cat{1};\ninline constexpr double tail = 2;\n  const double inner = 3;\nscenes::Cat<Real> cat_of(int n) {\n',
    ),
    [
      { name: 'cat', moves: true },
      { name: 'tail', moves: false },
      { name: 'cat_of', moves: true },
    ],
  );
});

for (const { name, moves } of cast) {
  const shown = moves && name !== 'swinging'; // any of the springs
  test(`${name} is on the page${shown ? ', with a picture' : ''}`, () => {
    assert.ok(named('main').includes(name), `chapters/cast/chapter.md never says \`${name}\``);
    if (shown)
      assert.ok(
        figures.some(figure => figure.drawn && figure.names.includes(name)),
        `no figure of chapters/cast/chapter.md shows \`${name}\``,
      );
  });
}

for (const { names, links } of figures) {
  test(`${names.join(', ')}: the chapters where they move`, () =>
    assert.deepEqual([...new Set(links)].sort(), moving(names).sort()));
}
