// Two ropes on one nail, and what a frame of each costs.
globalThis.Live.figure('hanging-rope', {
  view: () => ({ x: [-2.4, 2.4], y: [-3.3, 1.2] }),
  draw(pen, run, { method }, part) {
    pen.line([-2.3, 2.3], [0, 0], { colour: 'grid', width: 1 });
    const ropes = [
      ['stepped', 'symplectic_euler'],
      ['solved', 'backward_euler'],
    ];
    for (const [rope, colour] of ropes) {
      const [xs, ys] = ['x', 'y'].map(axis => this.blend(run, `${rope} ${axis}`, part));
      pen.line(xs, ys, { colour, width: method === colour ? 2.6 : 1.4 });
      if (this.isLost(xs, ys)) pen.text(0, 0.6, 'this rope is lost', { colour });
      else pen.dots(xs, ys, method === colour ? 3.2 : 2, colour);
    }
    pen.dot(0, 0, 4, 'ink');
    this.costs(pen, run.now);
  },
  isLost: (xs, ys) => ![...xs, ...ys].every(value => Math.abs(value) < 100),
  blend({ before, now }, name, part) {
    return Array.from(now[name], (value, i) => before[name][i] + part * (value - before[name][i]));
  },

  // Bars on one scale, whatever the settings.
  costs(pen, now) {
    const left = -2.3,
      most = 43_000,
      length = work => (4.6 * work) / most;
    pen.text(left - 0.05, -2.42, 'multiplications in a frame', { align: 'left' });
    [
      ['stepped', 'symplectic_euler', -2.72],
      ['solved', 'backward_euler', -3.06],
    ].forEach(([rope, colour, y]) => {
      const work = now[`${rope} work`];
      pen.line([left, left + length(work)], [y, y], { colour, width: 8 });
      const beside = length(work) < 3.4;
      pen.text(beside ? left + length(work) + 0.15 : 2.3, beside ? y : y + 0.17, globalThis.Live.fixed(work, 0), {
        colour,
        align: beside ? 'left' : 'right',
      });
    });
  },
  tell(now, { method }) {
    const rope = method === 'backward_euler' ? 'solved' : 'stepped';
    const what = rope === 'solved' ? 'solved once a frame' : 'in substeps';
    const energy = now[`${rope} energy`];
    if (!(Math.abs(energy) < 1)) return `the rope ${what} is lost.`;
    const share = globalThis.Live.fixed(Math.abs(100 * energy), 1);
    if (share === '0.0') return `the rope ${what} has the energy that it began with.`;
    return `the rope ${what} has ${energy < 0 ? 'lost' : 'gained'} ${share}\u202f% of the energy that a fall by its length would bring.`;
  },
});
