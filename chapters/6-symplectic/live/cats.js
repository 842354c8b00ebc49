// The cat where it is, and where it was every second and a half.
globalThis.Live.figure('cats', {
  view: () => ({ x: [-2.9, 2.9], y: [-2.15, 2.4] }),
  draw(pen, run, { method }, part) {
    pen.grid([-2, -1, 0, 1, 2], [-2, -1, 0, 1, 2]);
    const x = run.blend('x', part),
      v = run.blend('v', part);
    const { 'behind x': behindX, 'behind v': behindV } = run.now;
    for (let from = 0; from < behindX.length; from += x.length) {
      const outline = from ? { colour: method, width: 1, faint: 0.5 } : { colour: 'exact', width: 1 };
      this.cat(pen, behindX.subarray(from, from + x.length), behindV.subarray(from, from + x.length), outline, {
        colour: method,
        faint: from && 0.08,
      });
    }
    this.cat(pen, x, v, { colour: method, width: 1.6 }, { colour: method, faint: 0.25 });
  },
  cat(pen, x, v, outline, fill) {
    pen.area(x, v, fill);
    pen.line([...x, x[0]], [...v, v[0]], outline);
  },
  tell: ({ area }) => `area ${globalThis.Live.fixed(area, 1)}\u202f% of what it was.`,
});
