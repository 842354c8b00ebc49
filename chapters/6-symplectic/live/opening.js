// The points of a swing, and the curve of the shadow energy on which they lie.
globalThis.Live.figure('opening', {
  view: () => ({ x: [-3.5, 3.5], y: [-3.5, 3.5] }),
  draw(pen, run) {
    const grid = [-3, -2, -1, 0, 1, 2, 3];
    pen.grid(grid, grid);
    const { now } = run;
    pen.circle(0, 0, now.size, { colour: 'exact', width: 1.2, dash: [7, 5] });
    for (const [from, to] of this.pieces(now['curve x']))
      pen.line(now['curve x'].slice(from, to), now['curve u'].slice(from, to), { colour: 'first', width: 1.4 });
    const [x, u] = ['x', 'u'].map(name => run.past(name, 1));
    pen.dots(x, u, 3, 'symplectic_euler');
    for (let i = 0; i < Math.min(4, x.length); ++i) {
      const out = 1 + 0.25 / Math.hypot(x[i], u[i]); // a number stands a little farther out than its point
      pen.text(out * x[i], out * u[i], String(i + 1), { colour: 'symplectic_euler' });
    }
    pen.body(now.x, now.u, 6, 'symplectic_euler');
  },
  // An ellipse is one; of a hyperbola, which is nowhere in some directions, there are several.
  pieces(xs) {
    const found = [];
    xs.forEach((x, i) => {
      if (!(Math.abs(x) < 20)) return;
      if (found.at(-1)?.[1] === i) found.at(-1)[1] = i + 1;
      else found.push([i, i + 1]);
    });
    return found;
  },
  when: ({ t }) => `Point ${t + 1}`,
  tell({ farthest, size, energy }) {
    if (size === 0) return 'the spring is at rest.';
    return `the spring has been as far out as ${globalThis.Live.fixed(farthest / size, 2)} of its true swing, and its energy is ${globalThis.Live.fixed(energy, 2)} times what it was.`;
  },
});
