// The compiler of the page, in Node: each method that a reader may write anew, by the lines that the book shows of it, makes the very
// run that the book makes with it; and what it says of a mistake is found.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { load } from 'cheerio';
import { runClang } from '@yowasp/clang';
import { messagesOf } from '../../book/compiler/page/messages.js';
import { READER_FLAGS, readerSource } from '../../book/compiler/page/reader-source.js';
import '../../book/live/page/module.js';
import { cases } from '../../book/live/cases.mjs';
import { parse } from './book.mjs';
import { figures, module } from './live.mjs';

const header = readFileSync(new URL('../../book/compiler/reader.h', import.meta.url), 'utf8');
await runClang(null, {}, { fetchProgress: () => {} });

async function compile(lines, about) {
  let said = '';
  const decoder = new TextDecoder();
  const stderr = bytes => bytes && (said += decoder.decode(bytes));
  const files = { 'reader.h': header, 'step.cpp': readerSource(lines, about) };
  const args = ['clang++', ...READER_FLAGS, '-I.', 'step.cpp', '-o', 'step.wasm'];
  const made = await runClang(args, files, { stderr }).catch(() => ({}));
  return { bytes: made['step.wasm'], said };
}

// The lines of each method that can be edited, by the page: { method: { lines, about } }.
const editable = new Map();
const editedIn = [];
for (const figure of figures) {
  const template = parse(figure.page)(`[data-live="${figure.name}"] > template`).html();
  const $ = load(template ?? '');
  $('.listing[data-edit]').each((_, box) => {
    const method = $(box).attr('data-method');
    const lines = $(box).find('.line').get();
    editable.set(method, {
      lines: lines.map(line => $(line).text()).join('\n'),
      about: JSON.parse($(box).attr('data-edit')),
    });
    editedIn.push({ figure: figure.name, method });
  });
}

test('there are methods to write anew', () => assert.ok(editable.size >= 6, [...editable.keys()].join(', ')));

const live = await WebAssembly.compile(module);
for (const [method, { lines, about }] of editable)
  test(`${method}: the same bits in each figure`, async () => {
    const { bytes, said } = await compile(lines, about);
    assert.ok(bytes, said);
    const step = new WebAssembly.Module(bytes);
    assert.deepEqual(
      WebAssembly.Module.imports(step).map(({ module: from, name }) => `${from}.${name}`),
      ['scene.acceleration'],
    );
    for (const { figure } of editedIn.filter(edited => edited.method === method)) {
      const runs = cases(['start']).filter(run => run.figure === figure && (run.settings.method ?? method) === method);
      assert.ok(runs.length > 0);
      for (const { settings } of runs) {
        const prints = [];
        for (const own of ['none', `yours/${method}`]) {
          const opened = await globalThis.Live.open(live, figure);
          opened.useReader(step);
          for (const [name, value] of Object.entries({ ...settings, own })) opened.set(name, value);
          prints.push(opened.fingerprint(500));
          assert.equal(opened.readerFault, null);
        }
        assert.equal(prints[1], prints[0], `${figure}: ${JSON.stringify(settings)}`);
      }
    }
  });

test('a mistake: its line, its column and its words', async () => {
  const { bytes, said } = await compile('v = v + h * a;');
  assert.equal(bytes, undefined);
  assert.deepEqual(messagesOf(said, 'lines'), [
    { line: 1, column: 13, kind: 'error', text: "use of undeclared identifier 'a'" },
  ]);
});
