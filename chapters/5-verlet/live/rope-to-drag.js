// A rope that hangs from the reader's hand. The circle is as far as two metres reach.
globalThis.Live.figure('rope-to-drag', {
  view: () => ({ x: [-3.1, 3.1], y: [-2.75, 2.65] }),
  draw(pen, run, _, part) {
    const x = run.blend('x', part),
      y = run.blend('y', part);
    pen.circle(x[0], y[0], 2, { colour: 'exact', width: 1.2, dash: [7, 5] });
    pen.line(x, y, { colour: 'stormer_verlet', width: 2 });
    pen.dots(x, y, 2.6, 'stormer_verlet');
  },
  tell({ stretch }, { iterations, substeps }) {
    const size = Math.abs(stretch).toFixed(1);
    return `${size}\u202f% too ${stretch < 0 ? 'short' : 'long'}, with ${20 * iterations * substeps} pulls a frame.`;
  },
});
