// One submission through the real grader, and all that must be true after it.
import { spawn } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import Ajv from 'ajv/dist/2020.js';

const exercise = '2-euler/orbit-drift';
// Processor time and time on the clock [s], to compile and to run: enough for what is right, and
// short for what never ends.
const limits = '10,30,2,6';
const mostSeconds = 90; // compiling and running to their limits on the clock, twice, and a margin
const traces = ['/tmp/corpus-was-here', '/dev/shm/corpus-was-here', '/var/tmp/corpus-was-here', '/corpus-was-here'];

const text = path => (existsSync(path) ? readFileSync(path, 'utf8') : '');
const flat = string => string.replace(/\s+/g, ' ');

function parsed(path) {
  try {
    return JSON.parse(readFileSync(path, 'utf8'));
  } catch {
    return undefined;
  }
}

export function checker({ grade, alone, exercises, build }) {
  const schema = parsed(new URL('../../../exercises/grader/report/report.schema.json', import.meta.url));
  const valid = new Ajv({ allowUnionTypes: true }).compile(schema);
  const solution = join(exercises, exercise, 'solution.h');

  function run(path, room) {
    const started = performance.now();
    const child = spawn(
      alone,
      [grade, exercise, path, '--out', join(room, 'out'), '--seed', '20261121', '--limits', limits],
      {
        cwd: join(room, 'work'),
        env: { PATH: process.env.PATH, TMPDIR: join(room, 'work') },
        timeout: 1000 * mostSeconds,
      },
    );
    let shown = '';
    for (const stream of [child.stdout, child.stderr]) stream.on('data', data => (shown += data));
    return new Promise(resolve =>
      child.on('close', code =>
        resolve({
          code,
          shown,
          seconds: (performance.now() - started) / 1000,
          report: parsed(join(room, 'out/report.json')),
          feedback: text(join(room, 'out/feedback.md')),
        }),
      ),
    );
  }

  function scoreIsRight({ verdict, score, points }) {
    if (verdict === 'ACCEPTED') return score === points;
    return verdict === 'PARTIAL' ? score > 0 && score < points : score === 0;
  }

  // What a student may see must not name what is ours, nor hold what was not for them: the inputs of
  // tests behind the one in which the program came to its end. What to run next is named as the caller would have to type it.
  function leaks({ report, feedback, shown }, source) {
    const seen = [JSON.stringify(report), feedback, shown.replace(/^Next: .*$/gm, '')].join('\n');
    const secrets = ['root:x:', exercises, build, 'harness.h', 'judge.cpp', 'glue.cpp'];
    return (
      secrets.some(secret => seen.includes(secret) && !source.includes(secret)) ||
      report.tests
        .filter(test => !test.ran)
        .slice(1)
        .some(test => test.findings.length > 0) ||
      /^\s*::|##\[|\x1b/m.test(shown)
    );
  }

  function faults(item, result, room) {
    const { report, code } = result;
    if (!report || !valid(report)) return ['no valid report'];
    const said = flat(`${report.why} ${result.feedback.replaceAll('\\', '')} ${result.shown}`);
    return Object.entries({
      'verdict': !item.verdict.split('|').includes(report.verdict),
      'score': !scoreIsRight(report),
      'exit code': code !== 0,
      'a process left': code === 99,
      'time': result.seconds > mostSeconds,
      'message': item.says !== undefined && !said.includes(item.says),
      'what should not be said': item.never !== undefined && flat(result.report.memory).includes(item.never),
      'a file left':
        readdirSync(join(room, 'work')).length > 0 ||
        traces.some(existsSync) ||
        readdirSync(join(room, 'out')).some(name => !['report.json', 'feedback.md', 'plots'].includes(name)),
      'a leak': leaks(result, item.source),
    })
      .filter(([, bad]) => bad)
      .map(([name]) => name);
  }

  async function inRoom(work) {
    const room = mkdtempSync(join(tmpdir(), 'corpus-'));
    for (const name of ['work', 'submission']) mkdirSync(join(room, name));
    try {
      return await work(room);
    } finally {
      rmSync(room, { recursive: true, force: true });
    }
  }

  async function check(item) {
    const [result, bad] = await inRoom(async room => {
      const graded = await run(item.make(join(room, 'submission')), room);
      return [graded, faults(item, graded, room)];
    });
    return {
      ...item,
      faults: bad,
      seconds: result.seconds,
      verdictFound: result.report?.verdict ?? 'none',
      score: result.report ? `${result.report.score}/${result.report.points}` : '',
    };
  }

  // What a submission does to the machine, the next one would meet.
  async function nextIsAccepted() {
    const next = await inRoom(room => run(solution, room));
    return next.report?.verdict === 'ACCEPTED';
  }
  return { check, nextIsAccepted };
}
