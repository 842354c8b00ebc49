// Two ropes with weights in one hand, and the peg below it.
globalThis.Live.figure('two-ropes', {
  ropes: [
    ['iterated', 'first', 'iterations'],
    ['stepped', 'second', 'substeps'],
  ],
  view: () => ({ x: [-2, 2], y: [-2.55, 0.95] }),
  draw(pen, run, { weight, pulls }, part) {
    const [pegX, pegY, radius] = run.now.peg;
    const around = Array.from({ length: 49 }, (_, i) => (i * Math.PI) / 24);
    pen.area(
      around.map(angle => pegX + radius * Math.cos(angle)),
      around.map(angle => pegY + radius * Math.sin(angle)),
      { colour: 'context' },
    );
    pen.circle(run.blend('iterated x', part)[0], run.blend('iterated y', part)[0], 2, {
      colour: 'exact',
      width: 1.2,
      dash: [7, 5],
    });
    this.ropes.forEach(([rope, colour, spent], i) => {
      const x = run.blend(`${rope} x`, part),
        y = run.blend(`${rope} y`, part);
      pen.line(x, y, { colour, width: 2.2 });
      pen.dots(x, y, 2.4, colour);
      pen.body(x.at(-1), y.at(-1), 4 + 1.5 * Math.sqrt(weight), colour);
      pen.text(-1.97, 0.8 - (18 * i) / pen.metre, `${pulls} ${pulls === 1 ? spent.slice(0, -1) : spent}`, {
        colour,
        align: 'left',
      });
    });
  },
  take: (x, y) => ({ 'hand x': x, 'hand y': y }),
  tell(now, { pulls }) {
    const [iterated, stepped] = this.ropes.map(([rope]) => globalThis.Live.fixed(now[`${rope} stretch`], 1));
    const times = pulls === 1 ? '' : 's';
    return `stretched by ${iterated}\u202f% in ${pulls} iteration${times}, by ${stepped}\u202f% in ${pulls} substep${times}.`;
  },
});
