// The drone, its circle and its fence.
globalThis.Live.figure('drone-spiral', {
  view: () => ({ x: [-17, 17], y: [-17, 17] }),
  numbers: () => globalThis.Live.descriptions['drone-spiral'].numbers,
  draw(pen, run, { method }, part) {
    const { circle, fence } = this.numbers();
    pen.grid([-10, 0, 10], [-10, 0, 10]);
    pen.circle(0, 0, circle, { colour: 'exact', width: 1.4, dash: [7, 5] });
    pen.circle(0, 0, fence, { colour: 'limit', width: 2, dash: [2, 6] });
    pen.line(run.past('x', part), run.past('y', part), { colour: method, width: 1.4 });
    const { t } = run.trace;
    const everyTwoSeconds = t
      .map((_, i) => i)
      .filter(i => Math.floor(t[i] / 2 + 1e-9) > Math.floor(t[i - 1] / 2 + 1e-9));
    pen.dots(
      everyTwoSeconds.map(i => run.trace.x[i]),
      everyTwoSeconds.map(i => run.trace.y[i]),
      2.5,
      method,
    );
    const x = run.blend('x', part),
      y = run.blend('y', part);
    pen.line([0, x], [0, y], { colour: 'context', width: 1 });
    pen.dot(0, 0, 4, 'context');
    pen.body(x, y, 6, method);
  },
  tell({ distance }) {
    return `${globalThis.Live.fixed(distance, 2)}\u202fm from the tower${distance > this.numbers().fence ? ', over the fence' : ''}.`;
  },
});
