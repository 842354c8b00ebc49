// Compiles C++ in a thread of its own, so that the page stays alive; one thing after the other.
import { addPart, shipped } from './worker-files.js'; // before the compiler, whose loader takes its `fetch` from there
import { runClang } from '@yowasp/clang';
import header from '../standard.h';
import { headersOf, precompiledFor } from './precompiled.js';

const ready = runClang(null, {}, { fetchProgress: () => {} }); // without words of its own in the console
let turn = Promise.resolve();

async function precompiled(args) {
  if (!args.includes('-include-pch')) return {};
  const names = precompiledFor(args);
  const made = names.map(async name => [name, await shipped(name)]);
  return { ...headersOf(names, header), ...Object.fromEntries(await Promise.all(made)) };
}

const wordsOf = fault =>
  /memory/i.test(fault) ? 'This browser has not enough memory for the compiler.' : String(fault);

async function compile({ args, files, wanted }) {
  const decoder = new TextDecoder();
  let said = '';
  const stderr = bytes => {
    if (bytes) said += decoder.decode(bytes, { stream: true });
  };
  try {
    await ready;
    const all = await runClang(args, { ...(await precompiled(args)), ...files }, { stderr });
    return { made: all[wanted], said };
  } catch (fault) {
    return { made: null, said: said || wordsOf(fault) };
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
