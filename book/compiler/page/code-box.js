// Code that a reader writes, with what can be done with it: one thing after the other, and what the compiler says under its line.
import { askForCompiler } from './ask.js';
import { openEditor } from './code-editor.js';
import { element, press } from './element.js';
import { messagesOf } from './messages.js';

export class CodeBox {
  /**
   * @param file  as the compiler knows it
   * @param acts  { name: what it does }: buttons before the line that says how it went
   * @param more  the same behind it
   * @param withoutLine  (said) => words for what is wrong in no line of the file
   */
  constructor({ file, text, acts, more, changed = () => {}, withoutLine = said => said.trim().split('\n')[0] }) {
    Object.assign(this, { file, text, withoutLine, changed });
    this.status = element('span', { className: 'compiled' });
    this.status.setAttribute('role', 'status');
    const buttons = Object.entries(acts).map(([name, act]) => press(name, () => this.act(act)));
    const others = Object.entries(more).map(([name, act]) => press(name, act));
    this.box = element(
      'div',
      { className: 'listing edited program' },
      element('p', {}, ...buttons, this.status, ...others),
    );
    this.prints = element('pre', { className: 'printed', tabIndex: 0 });
    this.first = Object.values(acts).at(-1);
  }
  open(place, ...behind) {
    place.after(this.box, this.prints, ...behind);
    this.editor = openEditor(this.box, { text: this.text, label: this.file, changed: text => this.write(text) });
    this.box.addEventListener('keydown', event => {
      if (event.key === 'Enter' && (event.ctrlKey || event.metaKey)) this.act(this.first);
    });
  }
  write(text) {
    this.text = text;
    this.changed(text);
  }
  say(words) {
    this.status.textContent = words;
  }
  async act(act) {
    if (this.acting) return;
    this.acting = true;
    this.prints.textContent = '';
    try {
      this.compiler ??= await askForCompiler(this.box, 'program');
      if (this.compiler) await act();
      else this.say('The compiler is not here. Press again to fetch it.');
    } finally {
      this.acting = false;
    }
  }
  /** The program that comes of a source, or null if none does: then it is said why. */
  async compiled({ args, files }) {
    this.say('Compiling …');
    const { made, said } = await this.compiler.compile(args, files, 'program.wasm');
    const messages = messagesOf(said, this.file);
    const errors = messages.filter(({ kind }) => kind === 'error');
    this.editor.say(errors.length ? errors : messages);
    if (made) return made;
    this.say(errors.length ? `Line ${errors[0].line}: ${errors[0].text}` : this.withoutLine(said));
    return null;
  }
}
