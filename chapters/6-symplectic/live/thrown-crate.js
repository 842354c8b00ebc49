// Three crates, which were one when they were thrown.
globalThis.Live.figure('thrown-crate', {
  view: () => ({ x: [-4.6, 4.6], y: [-2.8, 1.9] }),
  curves: () => globalThis.Live.descriptions['thrown-crate'].chart.curves,
  draw(pen, run, { aside, up }, part) {
    const { x, y } = globalThis.Live.descriptions['thrown-crate'].handle;
    this.curves().forEach(({ value, colour, label }, i) => {
      const at = 3.1 * (i - 1);
      const name = value.replace(' energy', '');
      const xs = run.blend(`${name} x`, part).map(x => at + x),
        ys = run.blend(`${name} y`, part);
      this.box(pen, xs, ys, colour);
      pen.text(at, -1.95, label, { colour });
      const bar = (width, look) => pen.box([at - 0.5, at - 0.5 + width], [-2.5, -2.25], look);
      bar(1, { colour: 'context', faint: 0.3 });
      bar(Math.min(2, run.now[value]), { colour });
    });
    pen.arrow(0, 0, x.per * aside, y.per * up, { colour: 'ink', width: 1.4 });
  },
  // Its eight corners, and a line between two whose numbers differ in one digit, written with two.
  box(pen, xs, ys, colour) {
    for (let i = 0; i < 8; ++i)
      for (const bit of [1, 2, 4])
        if (!(i & bit)) pen.line([xs[i], xs[i | bit]], [ys[i], ys[i | bit]], { colour, width: 2 });
  },
  tell(now) {
    const words = this.curves().map(({ value, label }) => `${label} ${Math.round(100 * now[value])}\u202f%`);
    return `of the energy of the throw they have: ${words.join(', ')}.`;
  },
});
