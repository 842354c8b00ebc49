// Compiles C++ in a thread of its own, so that the page stays alive.
import { addPart } from './worker-files.js'; // before the compiler, whose loader takes its `fetch` from there
import { runClang } from '@yowasp/clang';

const ready = runClang(null, {}, { fetchProgress: () => {} }); // without words of its own in the console

const tasks = {
  part: addPart,

  async compile({ id, args, files, wanted }) {
    const decoder = new TextDecoder();
    let said = '';
    const stderr = bytes => {
      if (bytes) said += decoder.decode(bytes, { stream: true });
    };
    let made = null;
    try {
      await ready;
      const all = await runClang(args, files, { stderr });
      made = all[wanted];
    } catch (fault) {
      said ||= String(fault);
    }
    postMessage({ id, made, said });
  },
};

onmessage = ({ data }) => tasks[data.task](data);
