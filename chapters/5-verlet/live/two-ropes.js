// Two ropes with weights in one hand, and the peg below it.
globalThis.Live.figure('two-ropes', {
  ropes: [
    ['iterated', 'first', 'iterations'],
    ['stepped', 'second', 'substeps'],
  ],
  view: () => ({ x: [-2, 2], y: [-2.55, 0.95] }),
  reach: 0.15, // of a press on a rope [m]
  draw(pen, run, { weight, pulls, held, cut, press }, part) {
    const [pegX, pegY, radius] = run.now.peg;
    const around = Array.from({ length: 49 }, (_, i) => (i * Math.PI) / 24);
    pen.area(
      around.map(angle => pegX + radius * Math.cos(angle)),
      around.map(angle => pegY + radius * Math.sin(angle)),
      { colour: 'context' },
    );
    const at = ['x', 'y'].map(axis => run.blend(`iterated ${axis}`, part)[held]);
    const [first, last] = cut === 0 ? [0, 20] : held < cut ? [0, cut - 1] : [cut, 20]; // of the part in the hand
    const reach = Math.max(held - first, last - held) / 10;
    pen.circle(...at, reach, { colour: 'exact', width: 1.2, dash: [7, 5] });
    pen.text(-1.97, 0.8 - 36 / pen.metre, press === 'cut' ? 'press a link to cut it' : 'press a point to take it', {
      align: 'left',
    });
    this.ropes.forEach(([rope, colour, spent], i) => {
      const x = run.blend(`${rope} x`, part),
        y = run.blend(`${rope} y`, part);
      for (const from of [0, cut]) {
        const to = from < cut ? cut : x.length;
        pen.line(x.slice(from, to), y.slice(from, to), { colour, width: 2.2 });
      }
      pen.dots(x, y, 2.4, colour);
      pen.body(x.at(-1), y.at(-1), 4 + 1.5 * Math.sqrt(weight), colour);
      pen.text(-1.97, 0.8 - (18 * i) / pen.metre, `${pulls} ${pulls === 1 ? spent.slice(0, -1) : spent}`, {
        colour,
        align: 'left',
      });
    });
  },
  // Where somebody presses on a rope, the nearest point is taken, or the nearest link is cut.
  press(x, y, { now }, { press }) {
    const cuts = press === 'cut';
    const near = this.ropes.flatMap(([rope]) => {
      const points = [...now[`${rope} x`]].map((px, i) => [px, now[`${rope} y`][i]]);
      const middles = points.slice(1).map(([px, py], i) => [(px + points[i][0]) / 2, (py + points[i][1]) / 2]);
      return (cuts ? middles : points).map(([px, py], i) => [Math.hypot(px - x, py - y), i]);
    });
    const [off, i] = near.reduce((best, one) => (one[0] < best[0] ? one : best));
    return off > this.reach ? {} : cuts ? { cut: i + 1 } : { held: i };
  },
  take: (x, y, { press }) => (press === 'cut' ? {} : { 'hand x': x, 'hand y': y }),
  tell(now, { pulls }) {
    const [iterated, stepped] = this.ropes.map(([rope]) => globalThis.Live.fixed(now[`${rope} stretch`], 1));
    const times = pulls === 1 ? '' : 's';
    return `stretched by ${iterated}\u202f% in ${pulls} iteration${times}, by ${stepped}\u202f% in ${pulls} substep${times}.`;
  },
});
