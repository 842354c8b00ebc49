// Compiles C++ in a thread of its own, so that the page stays alive; one thing after the other.
import { addPart } from './worker-files.js'; // before the compiler, whose loader takes its `fetch` from there
import { runClang } from '@yowasp/clang';

const ready = runClang(null, {}, { fetchProgress: () => {} }); // without words of its own in the console
const kept = {}; // file -> bytes: headers that were precompiled
let turn = Promise.resolve();

async function compile({ args, files, wanted }) {
  const decoder = new TextDecoder();
  let said = '';
  const stderr = bytes => {
    if (bytes) said += decoder.decode(bytes, { stream: true });
  };
  try {
    await ready;
    const all = await runClang(args, { ...kept, ...files }, { stderr });
    return { made: all[wanted], said };
  } catch (fault) {
    return { made: null, said: said || String(fault) };
  }
}

const tasks = {
  part: addPart,
  compile: asked => answer(asked, () => compile(asked)),
  // What is wanted stays here, for whatever is compiled later.
  precompile: asked =>
    answer(asked, async () => {
      const { made, said } = await compile(asked);
      if (made) kept[asked.wanted] = made;
      return { made: made !== null, said };
    }),
};

function answer({ id }, work) {
  turn = turn.then(async () => postMessage({ id, ...(await work()) }));
}

onmessage = ({ data }) => tasks[data.task](data);
