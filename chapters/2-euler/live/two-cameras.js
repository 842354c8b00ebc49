// Three machines, and what their cameras have in view: by the frame above, exactly below.
globalThis.Live.figure('two-cameras', {
  fields: [
    ['lerp', 'lerp(camera, target, 0.1)', 2.35],
    ['exact', 'lerp(camera, target, 1 \u2212 exp(\u2212c h))', -3.15],
  ],
  colours: ['first', 'second', 'third'],
  view: () => ({ x: [-7, 7], y: [-5.5, 5.5] }),
  draw(pen, { now }, { slow, fast }) {
    for (const [line, words, middle] of this.fields) {
      const top = middle + 2.3;
      pen.within([-6.9, 6.9], [middle - 2.2, top], { colour: 'grid', width: 1 }, () => {
        pen.dot(now['target x'], middle + now['target y'], 5);
        this.colours.forEach((colour, i) =>
          this.look(pen, now[`${line} x`][i], middle + now[`${line} y`][i], i, colour),
        );
      });
      pen.text(-6.9, top + 0.4, words, { align: 'left', colour: 'ink' });
    }
    [slow, 60, fast].forEach((rate, i) =>
      pen.text(6.9 - (55 * (2 - i)) / pen.metre, 5.05, `${rate}\u202fHz`, { align: 'right', colour: this.colours[i] }),
    );
  },
  // What one camera sees. Those that are at one place lie within each other.
  look(pen, x, y, i, colour) {
    const wide = 1.5 - (4 * i) / pen.metre,
      high = 0.9 - (4 * i) / pen.metre;
    pen.frame([x - wide, x + wide], [y - high, y + high], { colour, width: 2.4 });
  },
  take(x, y) {
    const [, , middle] = this.fields[y > -0.6 ? 0 : 1];
    return { 'hand x': x, 'hand y': y - middle };
  },
  tell(now, { slow, fast }) {
    const far = line => ['slow', 'middle', 'fast'].map(of => globalThis.Live.fixed(now[`${of} ${line}`], 2)).join(', ');
    return `at ${slow}, 60 and ${fast}\u202fHz lerp is ${far('lerp')}\u202fm from the target, the exact step ${far('exact')}\u202fm.`;
  },
});
