// The program of a film, with its headers, to be changed and run: what it prints, and its film with the book's as a ghost.
import { withGhost } from '../../weave/film-ghost.mjs';
import { askForCompiler } from './ask.js';
import { openEditor } from './code-editor.js';
import { element, press } from './element.js';
import { loadScript, runProgram } from './compiler.js';
import { keep, kept, packed, unpacked } from './kept-code.js';
import { messagesOf } from './messages.js';
import { FILM, STANDARD } from './precompiled.js';
import { pathsOf, programArguments, treeOf } from './program-source.js';

class FilmEditor {
  // `brought`: what a link has of the program, { path: text } of what is not the book's.
  constructor(figure, brought) {
    const frame = figure.querySelector('.film iframe');
    Object.assign(this, { figure, book: frame.closest('.film'), path: frame.dataset.source });
    this.texts = { ...globalThis.Compiled.sources };
    this.paths = pathsOf(this.texts, this.path).filter(path => !path.endsWith('/player.h'));
    for (const path of this.paths) this.texts[path] = (brought ? brought[path] : kept(path)) ?? this.texts[path];
  }

  open() {
    this.status = element('span', { className: 'compiled' });
    this.status.setAttribute('role', 'status');
    this.tabs = element('span', { className: 'tabs' });
    this.run = press('Run', () => this.runIt());
    const link = press('Link to this program', () => this.link());
    const back = press('Back to the book’s', () => this.goBack());
    this.box = element(
      'div',
      { className: 'listing edited program' },
      element('p', {}, this.run, this.status, link, back),
      this.tabs,
    );
    this.prints = element('pre', { className: 'printed' });
    this.prints.tabIndex = 0;
    this.book.after(this.box, this.prints);
    this.editors = new Map();
    for (const path of this.paths) this.addTab(path);
    this.show(this.path);
    this.box.addEventListener('keydown', event => {
      if (event.key === 'Enter' && (event.ctrlKey || event.metaKey)) this.runIt();
    });
  }
  addTab(path) {
    const name = path.split('/').at(-1);
    const place = element('div');
    this.box.append(place);
    const tab = press(name, () => this.show(path));
    this.tabs.append(tab);
    const changed = text => {
      this.texts[path] = text;
      keep(path, text === globalThis.Compiled.sources[path] ? null : text);
    };
    const editor = openEditor(place, { text: this.texts[path], label: path, changed });
    this.editors.set(path, { editor, place, tab });
  }
  show(wanted) {
    for (const [path, { place, tab }] of this.editors) {
      place.hidden = path !== wanted;
      tab.setAttribute('aria-pressed', String(path === wanted));
    }
  }
  say(words) {
    this.status.textContent = words;
  }

  // The program as the book has it is compiled first, once: its film is the ghost of what comes.
  async begin() {
    this.compiler ??= await askForCompiler(this.box, 'program');
    if (!this.compiler) return this.say('Not compiled: the compiler is not here. Press Run to fetch it.');
    return (this.own ??= await this.filmOf(globalThis.Compiled.sources));
  }
  async filmOf(texts) {
    const { sources } = globalThis.Compiled;
    const isDrawnAlike = pathsOf(sources, 'chapters/play.h').every(path => texts[path] === sources[path]);
    const args = programArguments(this.path, isDrawnAlike ? FILM : STANDARD);
    const { made, said } = await this.compiler.compile(args, treeOf(texts), 'program.wasm');
    if (!made) return { said };
    const { printed, ended, files } = await runProgram(made);
    const film = Object.entries(files).find(([name]) => name.endsWith('.html'))?.[1];
    return { said, printed: printed.replace(/^Open .*\n/m, ''), ended, film };
  }

  async runIt() {
    if (this.running) return;
    this.running = true;
    this.say('Compiling …');
    const from = performance.now();
    try {
      const own = await this.begin();
      if (!own) return;
      const isOwn = this.paths.every(path => this.texts[path] === globalThis.Compiled.sources[path]);
      this.tell(isOwn ? own : await this.filmOf(this.texts), own, performance.now() - from);
    } finally {
      this.running = false;
    }
  }
  tell({ said, printed, ended, film }, own, time) {
    let isSaid = false;
    for (const [path, { editor, tab }] of this.editors) {
      const messages = messagesOf(said, path);
      const errors = messages.filter(({ kind }) => kind === 'error');
      editor.say(errors.length ? errors : messages);
      tab.classList.toggle('wrong', errors.length > 0);
      if (errors.length && !isSaid) this.show(path);
      isSaid ||= errors.length > 0;
    }
    if (printed === undefined)
      return this.say(isSaid ? 'It does not compile. Your last version goes on.' : said.trim().split('\n')[0]);
    this.prints.textContent = printed;
    this.say(ended || (film ? `Compiled and run in ${(time / 1000).toFixed(1)}\u202fs.` : 'It wrote no film.'));
    if (film) this.play(film === own.film ? film : withGhost(film, own.film));
  }
  play(page) {
    // In the browser's letters: a page made here may load no others from disk.
    const address = URL.createObjectURL(new Blob([page], { type: 'text/html' }));
    const film = this.book.cloneNode(true);
    for (const still of film.querySelectorAll('.still')) still.remove();
    film.querySelector('iframe').src = `${address}#${document.documentElement.dataset.theme ?? ''}`;
    (this.shown ?? this.book).replaceWith(film);
    this.shown = film;
  }

  async link() {
    const { sources } = globalThis.Compiled;
    const own = this.paths.filter(path => this.texts[path] !== sources[path]);
    const program = await packed(JSON.stringify(Object.fromEntries(own.map(path => [path, this.texts[path]]))));
    history.replaceState(null, '', `#${this.figure.id}?program=${program}`);
    const written = globalThis.isSecureContext && navigator.clipboard?.writeText(location.href);
    const isCopied = await Promise.resolve(written || Promise.reject()).then(
      () => true,
      () => false,
    );
    this.say(isCopied ? 'Link copied.' : 'The link is in the address bar.');
  }

  goBack() {
    const { sources } = globalThis.Compiled;
    for (const [path, { editor }] of this.editors) editor.write(sources[path]);
    this.shown?.replaceWith(this.book);
    this.shown = null;
    this.prints.textContent = '';
    this.say('');
  }
}

const editors = new WeakMap();

// What a link brings; nothing where somebody has cut it short.
async function programIn(packed) {
  try {
    const texts = Object.entries(JSON.parse(await unpacked(packed)) ?? {});
    return Object.fromEntries(texts.filter(([, text]) => typeof text === 'string'));
  } catch {
    return null;
  }
}

/**
 * Opens the program of the film that a figure shows.
 * @param packed  what a link brings of it, if it does
 */
export async function editFilm(figure, packed) {
  if (!globalThis.Compiled?.sources) await loadScript('sources.js');
  if (!editors.has(figure)) {
    const editor = new FilmEditor(figure, packed && (await programIn(packed)));
    editors.set(figure, editor);
    editor.open();
    await editor.runIt();
  }
  editors.get(figure).box.scrollIntoView({ block: 'nearest' });
}
