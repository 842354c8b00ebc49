// An exercise, done in the page: its starter to be written on, run by a main of one's own, and judged as grade does it.
import { askForCompiler } from './ask.js';
import { openEditor } from './code-editor.js';
import { runProgram } from './compiler.js';
import { element, press } from './element.js';
import { hasMain, judgedSource, ownSource, withMain } from './exercise-source.js';
import { judgeModule, loadJudges } from './judge-module.js';
import { keep, kept } from './kept-code.js';
import { messagesOf } from './messages.js';
import { noteReport } from './progress.js';
import { showReport } from './report-view.js';

const NO_MAIN = 'remove main(), or put it between #ifndef GRADING and #endif: the judges bring their own';

// What is wrong, and in no line of the header: with what the exercise calls, or in the linker.
function withoutLine(said) {
  const missing = /undefined symbol: (.*)/.exec(said)?.[1];
  if (missing) return `${missing} is declared, but never defined.`;
  const error = /error: (.*)/.exec(said)?.[1] ?? said.trim().split('\n')[0];
  return `This is not what the exercise calls; compare with the starter. ${error}`;
}

class ExerciseEditor {
  constructor(exercise, { judges, harness, exercises }) {
    const { given, tasks } = exercises;
    Object.assign(this, { exercise, judges, task: { ...tasks[exercise], given, object: harness } });
    this.header = `${exercise.split('/').at(-1)}.h`;
    this.text = kept(exercise) ?? this.task.starter;
  }

  open(place, id) {
    this.id = id;
    this.status = element('span', { className: 'compiled' });
    this.status.setAttribute('role', 'status');
    const bar = element(
      'p',
      {},
      press('Run', () => this.act(() => this.run())),
      press('Judge', () => this.act(() => this.judge())),
      this.status,
      press('Download', () => this.download()),
      press('Back to the starter', () => this.editor.write(this.task.starter)),
    );
    this.box = element('div', { className: 'listing edited program' }, bar);
    this.prints = element('pre', { className: 'printed', tabIndex: 0 });
    this.report = element('div', { className: 'report' });
    this.report.setAttribute('aria-label', 'What the judges say');
    place.after(this.box, this.prints, this.report);
    this.editor = openEditor(this.box, { text: this.text, label: this.header, changed: text => this.write(text) });
    this.box.addEventListener('keydown', event => {
      if (event.key === 'Enter' && (event.ctrlKey || event.metaKey)) this.act(() => this.judge());
    });
  }
  write(text) {
    this.text = text;
    keep(this.exercise, text === this.task.starter ? null : text);
  }
  say(words) {
    this.status.textContent = words;
  }
  // One after the other.
  async act(act) {
    if (this.acting) return;
    this.acting = true;
    this.prints.textContent = '';
    this.report.replaceChildren();
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
    const messages = messagesOf(said, this.header);
    const errors = messages.filter(({ kind }) => kind === 'error');
    this.editor.say(errors.length ? errors : messages);
    if (made) return made;
    this.say(errors.length ? `Line ${errors[0].line}: ${errors[0].text}` : withoutLine(said));
    return null;
  }

  async run() {
    const isNew = !hasMain(this.text);
    if (isNew) this.editor.write(withMain(this.text));
    const program = await this.compiled(ownSource(this.task, this.header, this.text));
    if (!program) return;
    const { printed, ended } = await runProgram(program);
    this.prints.textContent = printed;
    this.say(ended || (isNew ? 'Run by a main that is new, at the end: write there what you want to see.' : 'Run.'));
  }
  async judge() {
    const module = await this.compiled(judgedSource(this.task, this.header, this.text));
    if (!module) return;
    if (WebAssembly.Module.exports(new WebAssembly.Module(module)).some(({ name }) => name === 'main'))
      return this.say(NO_MAIN);
    this.say('Judging …');
    const report = await judgeModule(this.judges, module, this.exercise);
    showReport(this.report, report);
    this.say(report.headline);
    noteReport(this.id, report);
  }

  download() {
    const address = URL.createObjectURL(new Blob([this.text], { type: 'text/plain' }));
    element('a', { href: address, download: this.header }).click();
    URL.revokeObjectURL(address);
  }
}

const editors = new WeakMap();

/**
 * Opens an exercise behind `place`.
 * @param exercise  such as "2-euler/orbit-drift"
 * @param id  of its section
 */
export async function editExercise(place, exercise, id) {
  if (!editors.has(place)) {
    editors.set(place, null);
    const editor = new ExerciseEditor(exercise, await loadJudges());
    editors.set(place, editor);
    editor.open(place, id);
  }
  editors.get(place)?.editor.focus();
}
