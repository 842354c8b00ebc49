// Has a student's module judged, in a thread of its own.
import { bytesOf } from './base64.js';
import { loadScript, threadOf } from './compiler.js';

const PATIENCE = 10_000; // with a test [ms]; exercises/grader/page/module.cpp says so in words

async function unpacked(base64) {
  return new Uint8Array(
    await new Response(new Blob([bytesOf(base64)]).stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer(),
  );
}

let loading;

/** { judges, harness, exercises }: the judges' module, what a student's is linked with, and each exercise's files. */
export function loadJudges() {
  loading ??= Promise.all([loadScript('judging.js'), loadScript('exercises.js')]).then(async () => ({
    judges: await WebAssembly.compile(await unpacked(globalThis.Compiled.judges)),
    harness: await unpacked(globalThis.Compiled.harness),
    exercises: globalThis.Compiled.exercises,
  }));
  return loading;
}

/** The report of words_as_json.h; of a module that never comes back, what the judges say of that. */
export async function judgeModule(judges, bytes, exercise) {
  const module = await WebAssembly.compile(bytes);
  const thread = threadOf(globalThis.Compiled.judging);
  return new Promise((done, failed) => {
    let soFar, late;
    const end = act => {
      clearTimeout(late);
      thread.terminate();
      act();
    };
    const wait = () => {
      clearTimeout(late);
      late = setTimeout(() => end(() => done(soFar)), PATIENCE);
    };
    thread.onmessage = ({ data }) => {
      if (data.report) return end(() => done(data.report));
      if (data.fault) return end(() => failed(new Error(data.fault)));
      soFar = data.soFar;
      wait();
    };
    thread.onerror = ({ message }) => end(() => failed(new Error(message)));
    thread.postMessage({ judges, module, exercise, seed: 1 });
  });
}
