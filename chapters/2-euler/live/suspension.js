// The wheel on its spring, and how far it is stretched over time.
globalThis.Live.figure('suspension', {
  view: () => ({ x: [-0.32, 1.53], y: [-0.2, 0.2], free: true }),
  draw(pen, run, { method }, part) {
    pen.grid([0, 0.5, 1], [-0.1, 0, 0.1]);
    const { path } = run.now;
    pen.line(
      [...path].map((_, i) => (run.seconds * i) / (path.length - 1)),
      path,
      { colour: 'exact', width: 1.4, dash: [7, 5] },
    );
    const t = run.past('t', part),
      places = run.past('x', part);
    pen.line(t, places, { colour: method, width: 1.2 });
    pen.dots(t, places, t.length > 200 ? 1.2 : 2.2, method);
    const x = run.blend('x', part);
    globalThis.Live.coil(pen, -0.16, 0.2, x, 0.04);
    pen.body(-0.16, x, 9, method);
  },
  tell({ x, energy }) {
    return `stretch ${globalThis.Live.fixed(100 * x, 1)}\u202fcm, energy ${this.howMuch(energy)} what it was at the start.`;
  },
  howMuch(energy) {
    if (energy > 1000) return 'over a thousand times';
    return energy < 0.01 ? 'less than a hundredth of' : `${energy.toFixed(2)} times`;
  },
});
