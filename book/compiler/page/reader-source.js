// The source of a step that a reader has written.

const MOST = 2_000_000; // ways through the code that a step may take, before it counts as one that never ends

/**
 * @param lines  what the reader has written
 * @param before  lines of the header before its step, which name parts of it: "const Clock t_end = ..."
 * @param keeps  what the method keeps from step to step besides x and v, if it does: its acceleration
 *
 * The state of a run is place, velocity, what is kept, and 1 once the run has begun.
 */
export const readerSource = (lines, { before = '', keeps = 'kept' } = {}) => `#include "reader.h"
static double state[10];
__attribute__((noinline)) static void move(Vec& x, Vec& v, Vec& ${keeps}, const Time t, const Real h, const Acceleration& acceleration) {
${before}
#line 1 "lines"
${lines}
#line 1 "page"
}
EXPORT(room) double* room() { return state; }
EXPORT(step) void step(double t, double h) {
  Vec x{state[0], state[1], state[2]}, v{state[3], state[4], state[5]}, kept{state[6], state[7], state[8]};
  const Acceleration acceleration;
  fuel = ${MOST};
  ${keeps === 'kept' ? '' : 'if (state[9] == 0) kept = acceleration(x, v, t);'}
  move(x, v, kept, t, h, acceleration);
  state[0] = x.x, state[1] = x.y, state[2] = x.z, state[3] = v.x, state[4] = v.y, state[5] = v.z;
  state[6] = kept.x, state[7] = kept.y, state[8] = kept.z, state[9] = 1;
}
`;

export const READER_FLAGS = [
  '-std=c++20',
  '-O2',
  '-ffp-contract=off',
  '-fno-exceptions',
  '-fno-rtti',
  '-fsanitize-coverage=edge,trace-pc,no-prune', // each way through it, the empty loop's too
  '-Wall',
  '-Wno-unused',
  '-mexec-model=reactor',
  '-nostartfiles',
  '-Wl,--no-entry',
  '-Wl,--strip-all',
  '-Wl,--max-memory=1048576',
  '-Wl,-z,stack-size=65536',
];
