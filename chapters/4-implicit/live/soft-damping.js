// Three springs with one weight each, as it was asked for and as it is solved.
globalThis.Live.figure('soft-damping', {
  view: () => ({ x: [-3.2, 3.2], y: [-1.9, 2.5] }),
  draw(pen, run, _, part) {
    const { Live } = globalThis;
    pen.line([-3.2, 3.2], [2, 2], { colour: 'context', width: 2 });
    pen.line([-3.2, 3.2], [0, 0], { colour: 'grid', width: 1 });
    Live.descriptions['soft-damping'].chart.curves.forEach(({ value, colour, label }, i) => {
      const x = 2 * (i - 1),
        y = -run.blend(value, part);
      Live.coil(pen, x, 2, y, 0.16);
      pen.box([x - 0.3, x + 0.3], [y - 0.2, y + 0.2], { colour });
      pen.text(x, 2.25, label, { colour });
    });
  },
  tell(now) {
    const { fixed } = globalThis.Live;
    return `one solve a step gives ${fixed(now['got hertz'], 1)} swings a second and a damping ratio of ${fixed(now['got zeta'], 2)}.`;
  },
});
