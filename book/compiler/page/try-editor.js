// The examples over a header, to be changed and run.
import { CodeBox } from './code-box.js';
import { loadScript, runProgram } from './compiler.js';
import { pathsOf, programArguments, treeOf } from './program-source.js';
import { examplesOf, programOf } from './try-source.js';

const FILE = 'try.cpp';

function openHeader(place, path) {
  const { sources } = globalThis.Compiled;
  const [, folder, name] = path.split('/');
  const own = programOf(folder, name, examplesOf(sources[path]));
  const run = async () => {
    const files = Object.fromEntries(pathsOf(sources, path).map(one => [one, sources[one]]));
    const source = {
      args: [...programArguments(FILE), '-Wno-unused-variable'],
      files: treeOf({ ...files, [FILE]: code.text }),
    };
    const program = await code.compiled(source);
    if (!program) return;
    const { printed, ended } = await runProgram(program);
    code.prints.textContent = printed;
    code.say(ended || 'It ran.');
  };
  const code = new CodeBox({
    file: FILE,
    text: own,
    acts: { Run: run },
    more: { 'Back to the example': () => code.editor.write(own) },
  });
  code.open(place);
  return code;
}

const opened = new WeakMap();

/**
 * Opens the examples over a header behind `place`, and runs them.
 * @param path  "code/integrate/euler.h"
 */
export async function tryHeader(place, path) {
  if (!globalThis.Compiled?.sources) await loadScript('sources.js');
  if (opened.has(place)) return opened.get(place).editor.focus();
  const code = openHeader(place, path);
  opened.set(place, code);
  await code.act(code.first);
}
