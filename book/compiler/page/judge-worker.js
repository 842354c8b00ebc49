// The judges' thread, which can be stopped when a student's code never comes back.
import { judge } from './judging.js';

onmessage = ({ data: { judges, module, exercise, seed } }) => {
  try {
    const report = judge(judges, module, exercise, seed, soFar => postMessage({ soFar }));
    postMessage({ report });
  } catch (fault) {
    postMessage({ fault: String(fault) });
  }
};
