// Five trucks with their trailers, which jerk by a millimetre.
globalThis.Live.figure('bar-lost', {
  view: () => ({ x: [-2.2, 12.6], y: [-0.4, 9.9] }),
  curves: () => globalThis.Live.descriptions['bar-lost'].chart.curves,
  draw(pen, { now }) {
    this.curves().forEach(({ value, colour, label }, i) => {
      const low = 2 * (4 - i),
        out = 1000 * now[value.replace(' distance', '')]; // in millimetres
      pen.text(-1.9, low + 1.5, colour === 'exact' ? 'true' : label, { colour, align: 'left' });
      pen.line([-2.2, 12.6], [low - 0.05, low - 0.05], { colour: 'grid', width: 1 });
      const torn = this.torn(now, i);
      const end = torn ? 5.2 + 7.4 * Math.sign(out) : 5.8 + out;
      pen.line([1.8, end], [low + 0.6, low + 0.6], { colour: 'context', width: 2 });
      if (torn) {
        pen.arrow(end - Math.sign(out), low + 0.6, end, low + 0.6, { colour, width: 2 });
        pen.text(12.6, low + 1.5, this.far(now[value]), { colour, align: 'right' });
      } else this.wagon(pen, 6.8 + out, low, colour);
      this.wagon(pen, 0.9, low, 'context');
    });
  },
  // Two metres long, on two wheels.
  wagon(pen, x, low, colour) {
    pen.box([x - 1, x + 1], [low + 0.3, low + 1], { colour, faint: 0.8 });
    for (const wheel of [x - 0.6, x + 0.6]) pen.dot(wheel, low + 0.2, 0.2 * pen.metre, colour);
  },
  // Beyond the Sun the chart has names.
  far(distance) {
    const { Live } = globalThis;
    const named = Live.descriptions['bar-lost'].chart.marks.filter(([mark]) => mark > 1e9 && mark < distance);
    if (named.length) return `past ${named.at(-1)[1]}`;
    return distance < 1000 ? Live.metres(distance) : `${Live.fixed(distance / 1000, 0)}\u202fkm`;
  },
  // The last one is the true one, which holds. What has been torn stays so.
  torn: ({ torn }, i) => torn[i] === 1,
  tell(now) {
    const lost = this.curves().filter((_, i) => this.torn(now, i));
    if (!lost.length) return 'all five are there.';
    return `${lost.map(({ label }) => label).join(', ')} ${lost.length === 1 ? 'has' : 'have'} torn the bar.`;
  },
});
