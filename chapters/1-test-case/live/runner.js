// A runner between two walls, as he is drawn from the newest state, blended and extrapolated; a dot for each of the last frames.
globalThis.Live.figure('runner', {
  lanes: [
    ['newest', 'newest state', 'first', 2],
    ['blended', 'blended', 'second', 1],
    ['extrapolated', 'extrapolated', 'third', 0],
  ],
  half: 0.2, // of the runner's width [m]
  view: () => ({ x: [-0.55, 3.72], y: [0, 3], free: true }),
  draw(pen, run) {
    const { wall } = run.now;
    const walls = [
      [-1, -this.half],
      [wall + this.half, wall + 1],
    ];
    for (const wall of walls) pen.box(wall, [0, 3], { colour: 'grid' });
    for (const [name, label, colour, floor] of this.lanes) this.lane(pen, run, name, label, colour, floor);
  },
  lane(pen, { now, trace }, name, label, colour, floor) {
    const up = pixels => floor + pixels / pen.metreUp,
      x = now[name],
      top = up(pen.metreUp - 22);
    pen.text(now.wall / 2, up(pen.metreUp - 10), label, { colour });
    pen.line([-this.half, now.wall + this.half], [up(22), up(22)], { colour: 'context' });
    const last = trace[name].slice(-30);
    pen.dots(
      last,
      last.map(() => up(12)),
      2,
      colour,
    );
    for (let stripe = -2; stripe <= 2; ++stripe) {
      const [from, to] = [x + (stripe - 0.3) * 0.083, x + (stripe + 0.3) * 0.083];
      pen.box([from, to], [up(22), top], { colour });
    }
  },
  tell({ frames, still, behind, beyond }) {
    const { Live } = globalThis;
    if (frames === 0) return 'nothing has been drawn yet.';
    const size = value => (value > 0.0005 ? `up to ${Live.metres(value)}` : 'never');
    return `newest: still in ${still} of ${frames} frame${frames === 1 ? '' : 's'}; blended: ${size(behind)} behind; extrapolated: ${size(beyond)} in a wall.`;
  },
});
