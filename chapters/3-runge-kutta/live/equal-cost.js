// Four drones, a field for each, around the same tower.
globalThis.Live.figure('equal-cost', {
  fields: [
    ['euler', 'Euler', 0, 1],
    ['symplectic_euler', 'Symplectic Euler', 1, 1],
    ['midpoint', 'Midpoint', 0, 0],
    ['rk4', 'RK4', 1, 0],
  ],
  side: 32, // from field to field [m]
  view() {
    return { x: [0, 2 * this.side], y: [0, 2 * this.side] };
  },
  draw(pen, run, { method, orbit }) {
    for (const [name, label, column, row] of this.fields) {
      const left = column * this.side + 0.5,
        right = left + this.side - 1,
        bottom = row * this.side + 0.5,
        top = bottom + this.side - 4;
      const looked = name === method;
      pen.within([left, right], [bottom, top], { colour: looked ? name : 'grid', width: looked ? 2 : 1 }, () =>
        this.field(pen, run, name, orbit, (left + right) / 2, (bottom + top) / 2),
      );
      pen.text(left, top + 1.5, label, { colour: name, align: 'left' });
    }
  },
  // The ellipse reaches from 16 m at one side of its tower to 4 m at the other.
  field(pen, run, name, orbit, middle, height) {
    const tower = orbit === 'ellipse' ? middle + 6 : middle;
    pen.ellipse(middle, height, 10, orbit === 'ellipse' ? 8 : 10, { colour: 'exact', width: 1.2, dash: [5, 5] });
    pen.line(
      run.trace[`${name} x`].map(x => tower + x),
      run.trace[`${name} y`].map(y => height + y),
      { colour: name, width: 1.2, faint: 0.8 },
    );
    pen.dot(tower, height, 3, 'context');
    pen.dot(tower + run.now[`${name} x`], height + run.now[`${name} y`], 5, name);
    pen.circle(tower + run.now[`${name} true x`], height + run.now[`${name} true y`], 8 / pen.metre, {
      colour: 'exact',
      width: 1.2,
    });
  },
  take(x, y) {
    const found = this.fields.find(
      ([, , column, row]) => Math.floor(x / this.side) === column && Math.floor(y / this.side) === row,
    );
    return found && { method: found[0] };
  },
  tell(now, { method }) {
    const [, label] = this.fields.find(([name]) => name === method);
    return `after ${now.steps} ${now.steps === 1 ? 'step' : 'steps'}, ${label} has been up to ${globalThis.Live.metres(now[`${method} worst`])} from where the drone should be.`;
  },
});
