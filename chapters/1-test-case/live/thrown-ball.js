// The true path of a ball, and the places where its steps put it.
globalThis.Live.figure('thrown-ball', {
  view: () => ({ x: [-0.8, 21.8], y: [-4.2, 6.8] }),
  draw(pen, run, { method, 'throw x': throwX, 'throw y': throwY }, part) {
    pen.grid([0, 5, 10, 15, 20], [0, 5]);
    const path = [...run.now.path];
    pen.line(
      path.filter((_, i) => i % 2 === 0),
      path.filter((_, i) => i % 2 === 1),
      { colour: 'exact', width: 1.4, dash: [7, 5] },
    );
    const x = run.past('x', part),
      y = run.past('y', part);
    pen.line(x, y, { colour: method, width: 1.2, faint: 0.6 });
    pen.dots(x, y, x.length > 100 ? 1.6 : 3, method);
    const { x: across, y: up } = globalThis.Live.descriptions['thrown-ball'].handle;
    pen.arrow(0, 0, across.per * throwX, up.per * throwY, { colour: 'ink', width: 1.4 });
    pen.body(run.blend('x', part), run.blend('y', part), 6, method);
  },
  tell: ({ error }) =>
    `${error < 1e-9 ? 'right to rounding' : `${globalThis.Live.fixed(100 * error, 1)}\u202fcm from the true place`}.`,
});
