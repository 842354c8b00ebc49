// The thread of page.test.mjs: the page's judges over the ways that a module holds, each named by its header's path.
import { readFileSync } from 'node:fs';
import { parentPort, workerData } from 'node:worker_threads';
import { judge } from '../../book/compiler/page/judging.js';

const { exercise } = workerData;
const [judges, module] = [workerData.judges, workerData.module].map(file => new WebAssembly.Module(readFileSync(file)));

parentPort.on('message', header => {
  const letters = new TextEncoder().encode(header);
  const ways = memory => ({
    length: () => letters.length,
    letters: to => new Uint8Array(memory().buffer, to, letters.length).set(letters),
  });
  const told = soFar => parentPort.postMessage({ told: soFar });
  parentPort.postMessage({ report: judge(judges, module, exercise, 1, told, ways) });
});
