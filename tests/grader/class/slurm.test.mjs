// A class graded as a job array by a Slurm that this test starts, for which it must be root:
//   node slurm.test.mjs GRADE EXERCISES
import assert from 'node:assert/strict';
import {spawn, spawnSync} from 'node:child_process';
import {chmodSync, existsSync, mkdirSync, readFileSync, readdirSync, writeFileSync} from 'node:fs';
import {createServer} from 'node:net';
import {join} from 'node:path';
import {test} from 'node:test';
import {setTimeout as sleep} from 'node:timers/promises';
import {realClass, skip} from './real.mjs';
import {slurmConf} from './slurm.conf.mjs';

const [grade, exercises] = process.argv.slice(2);
const path = `${process.env.PATH}:/usr/sbin:/sbin`;
for (const program of ['munged', 'slurmctld', 'slurmd', 'sbatch']) {
  const there = path.split(':').some(folder => existsSync(join(folder, program)));
  if (!there) skip(`${program} is not installed; slurmctld, slurmd, slurm-client and munge are needed`);
}
if (process.getuid() !== 0) skip('only root can start a Slurm');

const room = realClass(exercises);
const at = name => join(room.folder, name);
const env = {...process.env, PATH: path, SLURM_CONF: at('slurm.conf')};

function freePort() {
  return new Promise(resolve => {
    const server = createServer().listen(0, '127.0.0.1', () => {
      const {port} = server.address();
      server.close(() => resolve(port));
    });
  });
}

function start(program, ...words) {
  const child = spawn(program, words, {env, stdio: ['ignore', 'ignore', 'pipe']});
  let said = '';
  child.stderr.on('data', data => { said = (said + data).slice(-2000); });
  const ended = new Promise(resolve => child.on('close', resolve));
  return {said: () => `${program}: ${said}`, stop: () => child.kill('SIGTERM') && ended};
}

async function until(condition, otherwise) {
  for (let i = 0; i < 120; ++i) {
    if (condition()) return;
    await sleep(500);
  }
  assert.fail(otherwise());
}

const slurm = (program, ...words) => spawnSync(program, words, {env, encoding: 'utf8', cwd: room.folder});

async function startSlurm(daemons) {
  chmodSync(room.folder, 0o755);  // munge wants its socket to be reached by all
  for (const folder of ['state', 'spool']) mkdirSync(at(folder));
  writeFileSync(at('munge.key'), Buffer.alloc(64, 'not a secret'), {mode: 0o600});
  writeFileSync(at('slurm.conf'), slurmConf(room.folder, [await freePort(), await freePort()]));
  const said = () => daemons.map(daemon => daemon.said()).join('\n');
  daemons.push(start('munged', '--foreground', '--socket', at('munge.socket'), '--key-file', at('munge.key'),
      '--pid-file', at('munge.pid'), '--log-file', at('munge.log'), '--seed-file', at('munge.seed')));
  await until(() => existsSync(at('munge.socket')), said);
  daemons.push(start('slurmctld', '-D'), start('slurmd', '-D'));
  await until(() => /idle/.test(slurm('sinfo', '-h').stdout), said);
}

function gradeBySlurm() {
  const command = [grade, '--class', room.submissions, '--out', room.results];
  const script = join(exercises, 'grader/class/slurm.sbatch');
  const job = slurm('sbatch', '--wait', '--array=1-3', '--mem-per-cpu=0', '--output', at('task-%a.txt'), script, ...command);
  const printed = readdirSync(room.folder).filter(name => name.startsWith('task-')).map(name => readFileSync(at(name), 'utf8'));
  assert.equal(job.status, 0, [job.stderr, ...printed].join('\n'));
  assert.equal(printed.length, 3);
  for (const student of room.right) assert.equal(room.report(student).verdict, 'ACCEPTED');
  const last = spawnSync(command[0], command.slice(1), {encoding: 'utf8'});
  assert.equal(last.status, 0, last.stderr);
  assert.match(last.stdout, new RegExp(`^${room.students.length} submissions graded before and skipped\n`));
}

test('a job array of Slurm grades a class, and the grader then only makes the tables', async () => {
  const daemons = [];
  try {
    await startSlurm(daemons);
    gradeBySlurm();
  } finally {
    for (const daemon of daemons.reverse()) await daemon.stop();
  }
});
