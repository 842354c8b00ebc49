// Runs a program in a thread of its own, which can be stopped: with files in memory, and nothing else.
import { ConsoleStdout, File, OpenFile, PreopenDirectory, WASI, WASIProcExit } from '@bjorn3/browser_wasi_shim';

const MOST = 100_000; // letters that a program may print

onmessage = async ({ data: bytes }) => {
  let printed = '';
  const print = line => {
    printed += `${line}\n`;
    if (printed.length > MOST) throw new Error(`it printed more than ${MOST} letters`);
  };
  const folder = new PreopenDirectory('.', new Map());
  const streams = [new OpenFile(new File([])), ConsoleStdout.lineBuffered(print), ConsoleStdout.lineBuffered(print)];
  const wasi = new WASI([], [], [...streams, folder], { debug: false });
  let ended = '';
  try {
    const instance = await WebAssembly.instantiate(await WebAssembly.compile(bytes), {
      wasi_snapshot_preview1: wasi.wasiImport,
    });
    const code = wasi.start(instance);
    if (code) ended = `It ended with ${code}.`;
  } catch (fault) {
    if (!(fault instanceof WASIProcExit && fault.code === 0)) ended = `It was stopped: ${fault.message}.`;
  }
  const decoder = new TextDecoder();
  const files = [...folder.dir.contents].map(([name, { data }]) => [name, decoder.decode(data)]);
  postMessage({ printed, ended, files: Object.fromEntries(files) });
};
