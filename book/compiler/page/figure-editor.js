// The lines of a live figure's method, to be written anew: they are compiled as one stops typing, and move in the figure beside
// the book's.
import header from '../reader.h';
import { askForCompiler } from './ask.js';
import { openEditor } from './code-editor.js';
import { element, press } from './element.js';
import { keep, kept, packed, unpacked } from './kept-code.js';
import { messagesOf } from './messages.js';
import { READER_FLAGS, readerSource } from './reader-source.js';

const QUIET = 400; // after a letter, before it is compiled [ms]
const MOST = 20_000; // letters of a step; more is no step

class FigureEditor {
  constructor(figure, method) {
    const { stage, element: whole } = figure;
    Object.assign(this, { figure, method, own: `yours/${method}`, name: `${whole.dataset.live}/${method}` });
    this.listing = stage.querySelector(`.listing[data-method="${method}"]:not([data-own])`);
    this.book = [...this.listing.querySelectorAll('.line')].map(line => line.textContent).join('\n');
    this.about = JSON.parse(this.listing.dataset.edit);
  }

  async open(brought) {
    const { made, isYours } = this.figure.mistakes;
    if (made && !isYours) this.figure.choose({ own: 'none' });
    const back = press('Back to the book’s', () => this.goBack());
    const title = this.listing.querySelector('b').textContent;
    this.status = element('span', { className: 'compiled' });
    this.status.setAttribute('role', 'status');
    this.box = element(
      'div',
      { className: 'listing edited' },
      element('p', {}, element('b', { textContent: `Yours, for ${title}` }), this.status, back),
    );
    Object.assign(this.box.dataset, { method: this.method, own: this.own });
    this.listing.after(this.box);
    this.offer();
    this.editor = openEditor(this.box, {
      text: brought ?? kept(this.name) ?? this.book,
      label: `Your ${title}, in C++`,
      changed: () => this.changed(),
      most: MOST,
      refused: letters => this.say(`No step has ${letters} letters; the most is ${MOST}.`),
    });
    this.show();
    this.editor.focus();
    this.compiler = await askForCompiler(this.box, 'step');
    if (this.compiler) await this.compile();
    else this.say('Not compiled: the compiler is not here. Press Edit again to fetch it.');
  }
  // The choice "Yours", beside the mistakes.
  offer() {
    const { stage, settings } = this.figure;
    const control = settings.of('own');
    const input = element('input', { type: 'radio', name: control.radios[0].name, value: this.own });
    const label = element('label', {}, input, ' Yours');
    label.dataset.of = this.method;
    stage.querySelector('.chips .edit').before(label);
    control.radios.push(input);
    control.choices[this.own] = 'Yours';
  }
  // The editor stands where the code is; what is written there runs once it is compiled.
  show() {
    this.figure.showing = this.own;
    this.figure.showCode(this.method);
  }
  run() {
    this.figure.showing = null;
    this.figure.choose({ own: this.own });
  }
  say(words) {
    this.status.textContent = words;
  }

  changed() {
    const { text } = this.editor;
    keep(this.name, text === this.book ? null : text);
    clearTimeout(this.due);
    this.due = setTimeout(() => this.compile(), QUIET);
  }

  async compile() {
    if (!this.compiler) return;
    const { text } = this.editor;
    this.say('Compiling …');
    const from = performance.now();
    const files = { 'reader.h': header, 'step.cpp': readerSource(text, this.about) };
    const args = ['clang++', ...READER_FLAGS, '-I.', 'step.cpp', '-o', 'step.wasm'];
    const { made, said } = await this.compiler.compile(args, files, 'step.wasm');
    if (text !== this.editor.text) return; // the next one is on its way
    const messages = messagesOf(said, 'lines');
    const errors = messages.filter(({ kind }) => kind === 'error');
    this.editor.say(errors.length ? errors : messages);
    if (!made)
      return this.say(errors.length ? 'It does not compile. Your last version goes on.' : said.trim().split('\n')[0]);
    const seconds = ((performance.now() - from) / 1000).toFixed(1);
    this.figure.useReader(new WebAssembly.Module(made), await packed(text));
    this.run();
    this.say(this.figure.readerFault ?? `Compiled in ${seconds}\u202fs.`);
  }

  // To the book's lines; what was written is forgotten.
  goBack() {
    this.editor.write(this.book);
    clearTimeout(this.due);
    this.figure.showing = null;
    this.figure.choose({ own: 'none' });
  }
}

const editors = new WeakMap(); // figure -> { method: FigureEditor }

/** Opens the lines of the method that a figure shows; those that a link has brought, if it has some. */
export async function editFigure(figure) {
  const { method } = figure;
  if (!editors.has(figure)) editors.set(figure, new Map());
  const open = editors.get(figure);
  const brought = figure.links.brought;
  const text = brought?.own === `yours/${method}` ? await unpacked(brought.code) : null;
  const before = open.get(method);
  if (before?.compiler) {
    await before.compile();
    before.editor.focus();
    return;
  }
  if (before) {
    before.show();
    before.compiler = await askForCompiler(before.box, 'step');
    if (before.compiler) await before.compile();
    return;
  }
  const editor = new FigureEditor(figure, method);
  open.set(method, editor);
  await editor.open(text);
}
