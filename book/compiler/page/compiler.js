// The compiler, from the page: loaded once, when somebody asks for it, and then at work in a thread of its own.

const FOLDER = 'compiler';

export const threadOf = source => new Worker(URL.createObjectURL(new Blob([source], { type: 'text/javascript' })));

export function loadScript(file) {
  const script = document.createElement('script');
  script.src = `${FOLDER}/${file}`;
  const loaded = new Promise((done, failed) => {
    script.onload = done;
    script.onerror = () => failed(new Error(`${script.src} is not there: the book was built without its compiler`));
  });
  document.head.append(script);
  return loaded.finally(() => script.remove());
}

export class Cancelled extends Error {}

class Compiler {
  constructor(worker) {
    this.worker = worker;
    this.waiting = new Map();
    this.asked = 0;
    worker.onmessage = ({ data: { id, ...answer } }) => {
      this.waiting.get(id)(answer);
      this.waiting.delete(id);
    };
  }
  /** { made, said }: the bytes of the file that is wanted, null if there was a mistake; and what the compiler says. */
  compile(args, files, wanted) {
    return this.ask('compile', { args, files, wanted });
  }
  ask(task, about) {
    const id = ++this.asked;
    this.worker.postMessage({ task, id, ...about });
    return new Promise(answered => this.waiting.set(id, answered));
  }
}

let loading;
let come = 0; // parts

/** How much has not come yet of what the compiler needs for a 'step' or a 'program' [MB]. */
export function stillToCome(forWhat) {
  const { sizes, needed } = globalThis.Compiled;
  return Math.round(sizes.slice(come, needed[forWhat]).reduce((sum, size) => sum + size, 0) / 1e6);
}

/**
 * The compiler, which comes part by part.
 * @param forWhat  'step' or 'program', which needs the standard library besides
 * @param told  called with the share of it that is there, 0 to 1
 * @param signal  an AbortSignal: what has come by then stays, and the next call goes on from there
 */
export function loadCompiler(forWhat, told, signal) {
  loading ??= begin();
  return loading.then(begun => begun.goOn(globalThis.Compiled.needed[forWhat], told, signal));
}

async function begin() {
  await loadScript('worker.js');
  const worker = threadOf(globalThis.Compiled.worker);
  const compiler = new Compiler(worker);
  globalThis.Compiled.part = (file, base64, last) => worker.postMessage({ task: 'part', file, base64, last });
  let turn = Promise.resolve();
  return {
    goOn(parts, told, signal) {
      turn = turn
        .catch(() => {})
        .then(async () => {
          for (; come < parts; ++come) {
            if (signal?.aborted) throw new Cancelled();
            await loadScript(`part-${String(come).padStart(2, '0')}.js`);
            told((come + 1) / parts);
          }
          return compiler;
        });
      return turn;
    },
  };
}

const PATIENCE = 2000; // with a program [ms]

/** Runs a program: { printed, ended, files: { name: text } }; `ended` says in words what was wrong, if something was. */
export function runProgram(bytes) {
  const thread = threadOf(globalThis.Compiled.runner);
  return new Promise(done => {
    const stop = answer => {
      clearTimeout(late);
      thread.terminate();
      done(answer);
    };
    const late = setTimeout(
      () => stop({ printed: '', ended: 'It was stopped after two seconds.', files: {} }),
      PATIENCE,
    );
    thread.onmessage = ({ data }) => stop(data);
    thread.onerror = ({ message }) => stop({ printed: '', ended: `It was stopped: ${message}.`, files: {} });
    thread.postMessage(bytes);
  });
}
