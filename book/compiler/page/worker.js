// Compiles C++ in a thread of its own, so that the page stays alive; one thing after the other.
import { addPart, shipped } from './worker-files.js'; // before the compiler, whose loader takes its `fetch` from there
import { runClang } from '@yowasp/clang';
import header from '../standard.h';
import { PRECOMPILED } from './program-source.js';

const ready = runClang(null, {}, { fetchProgress: () => {} }); // without words of its own in the console
let turn = Promise.resolve();

// Clang wants to see the header, too.
const standard = async () => ({ 'standard.h': header, [PRECOMPILED]: await shipped(PRECOMPILED) });

async function compile({ args, files, wanted }) {
  const decoder = new TextDecoder();
  let said = '';
  const stderr = bytes => {
    if (bytes) said += decoder.decode(bytes, { stream: true });
  };
  try {
    await ready;
    const more = args.includes(PRECOMPILED) ? await standard() : {};
    const all = await runClang(args, { ...more, ...files }, { stderr });
    return { made: all[wanted], said };
  } catch (fault) {
    return { made: null, said: said || String(fault) };
  }
}

const tasks = {
  part: addPart,
  compile: asked => answer(asked, () => compile(asked)),
};

function answer({ id }, work) {
  turn = turn.then(async () => postMessage({ id, ...(await work()) }));
}

onmessage = ({ data }) => tasks[data.task](data);
