// An exercise, done in the page: its starter to be written on, run by a main of one's own, and judged as grade does it.
import { CodeBox } from './code-box.js';
import { runProgram } from './compiler.js';
import { element } from './element.js';
import { hasMain, judgedSource, ownSource, withMain } from './exercise-source.js';
import { judgeModule, loadJudges } from './judge-module.js';
import { keep, kept } from './kept-code.js';
import { noteReport } from './progress.js';
import { showReport } from './report-view.js';

const NO_MAIN = 'remove main(), or put it between #ifndef GRADING and #endif: the judges bring their own';

// What is wrong, and in no line of the header: with what the exercise calls, or in the linker.
function withoutLine(said) {
  const missing = /undefined symbol: (.*)/.exec(said)?.[1];
  if (missing) return `${missing} is declared, but never defined.`;
  const twice = /duplicate symbol: (.*)/.exec(said)?.[1];
  if (twice) return `${twice} is there twice: the library has one of that name.`;
  const error = /error: (.*)/.exec(said)?.[1];
  if (!error) return said.trim().split('\n')[0];
  return `This is not what the exercise calls; compare with the starter. ${error}`;
}

class ExerciseEditor {
  constructor(exercise, id, { judges, harness, exercises }) {
    const { given, tasks } = exercises;
    Object.assign(this, { exercise, id, judges, task: { ...tasks[exercise], given, object: harness } });
    this.header = `${exercise.split('/').at(-1)}.h`;
    this.report = element('div', { className: 'report' });
    this.report.setAttribute('aria-label', 'What the judges say');
    const { starter } = this.task;
    this.code = new CodeBox({
      file: this.header,
      text: kept(exercise) ?? starter,
      acts: { Run: () => this.run(), Judge: () => this.judge() },
      more: { 'Download': () => this.download(), 'Back to the starter': () => this.code.editor.write(starter) },
      changed: text => keep(exercise, text === starter ? null : text),
      withoutLine,
    });
  }

  async run() {
    this.report.replaceChildren();
    const isNew = !hasMain(this.code.text);
    if (isNew) this.code.editor.write(withMain(this.code.text));
    const program = await this.code.compiled(ownSource(this.task, this.header, this.code.text));
    if (!program) return;
    const { printed, ended } = await runProgram(program);
    this.code.prints.textContent = printed;
    const words = isNew ? 'A main was added at the end. Print there what you want to see.' : 'It ran.';
    this.code.say(ended || words);
  }
  async judge() {
    this.report.replaceChildren();
    const module = await this.code.compiled(judgedSource(this.task, this.header, this.code.text));
    if (!module) return;
    if (WebAssembly.Module.exports(new WebAssembly.Module(module)).some(({ name }) => name === 'main'))
      return this.code.say(NO_MAIN);
    this.code.say('Judging …');
    const report = await judgeModule(this.judges, module, this.exercise);
    showReport(this.report, report);
    this.code.say(report.headline);
    noteReport(this.id, report);
  }

  download() {
    const address = URL.createObjectURL(new Blob([this.code.text], { type: 'text/plain' }));
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
    const editor = new ExerciseEditor(exercise, id, await loadJudges());
    editors.set(place, editor);
    editor.code.open(place, editor.report);
  }
  editors.get(place)?.code.editor.focus();
}
