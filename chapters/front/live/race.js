// The true flight, with the throw, and beside it the eight that try to follow it, a field for each.
globalThis.Live.figure('race', {
  across: 31, // from field to field [m]
  down: 30,
  view() {
    return { x: [-18.5, 12.5 + 2 * this.across], y: [-12.5 - 2 * this.down, 17] };
  },
  methods: () => globalThis.Live.descriptions.race.chart.curves.filter(({ label }) => label),
  draw(pen, run, { 'throw x': throwX, 'throw y': throwY }, part) {
    const { handle } = globalThis.Live.descriptions.race;
    this.field(pen, run, part, 0, 'true', 'exact', 'the true flight');
    pen.arrow(handle.x.at, 0, handle.x.at + handle.x.per * throwX, handle.y.per * throwY, { width: 1.4 });
    this.methods().forEach(({ colour, label }, i) => this.field(pen, run, part, i + 1, colour, colour, label));
  },
  field(pen, run, part, place, name, colour, label) {
    const x = this.across * (place % 3),
      y = -this.down * Math.floor(place / 3);
    const { numbers } = globalThis.Live.descriptions.race;
    const shift = (values, by) => values.map(value => value + by);
    const path = ['path x', 'path y'].map((of, i) => shift([...run.now[of]], [x, y][i]));
    const [xs, ys] = ['x', 'y'].map((of, i) => shift(run.past(`${name} ${of}`, part), [x, y][i]));
    const turn = run.trace.t.findIndex(t => t > run.now.t - run.now.turn);
    pen.within([x - 18, x + 12], [y - 12, y + 12], { colour: 'grid', width: 1 }, () => {
      pen.line(...path, { colour: 'exact', width: 1.2, dash: [5, 5] });
      pen.dot(x, y, (pen.metre * numbers.planet) / 2, 'context');
      if (name !== 'true') {
        pen.line(xs, ys, { colour, width: 1, faint: 0.25 });
        pen.line(xs.slice(turn), ys.slice(turn), { colour, width: 1.8 });
        pen.circle(x + run.blend('true x', part), y + run.blend('true y', part), 4.5 / pen.metre, {
          colour: 'exact',
          width: 1.2,
        });
      }
      pen.dot(x + run.blend(`${name} x`, part), y + run.blend(`${name} y`, part), 4, colour);
    });
    if (run.now.crashed[place - 1]) pen.text(x + 11.5, y - 12 + 9 / pen.metre, 'crashed', { align: 'right', size: 11 });
    pen.text(x - 18, y + 12 + 9 / pen.metre, label, { colour: name === 'true' ? 'soft' : colour, align: 'left' });
  },
  tell(now) {
    const error = ({ colour }) => now[`${colour} error`];
    const [nearest] = this.methods().sort((one, other) => error(one) - error(other));
    if (now.t === 0) return 'all start at the dot.';
    if (error(nearest) === Infinity) return 'all have crashed.';
    return `${nearest.label} has kept nearest, at most ${globalThis.Live.metres(error(nearest))} from the true shuttle.`;
  },
});
