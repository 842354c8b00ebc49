// Four machines that play one jump. Beside each jumper stands a bucket of the time that has passed since the last step,
// and beside the bucket the steps of the last frame, in the same measure.
globalThis.Live.figure('four-machines', {
  machines: ['a', 'b', 'c', 'd'],
  wide: 1, // of one machine's place [m]
  tall: 9, // of a second in a bucket [m]
  deep: 7 / 60, // how much time a bucket holds [s]: a late frame and what was left over
  view: () => ({ x: [-0.02, 4.3], y: [-0.33, 1.84], free: true }),
  draw(pen, run, settings, part) {
    const now = part < 1 ? run.before : run.now;
    Object.assign(this, { now, t: run.blend('t', part), goesOn: !run.ended });
    pen.line([0, 4.3], [0, 0], { colour: 'context' });
    pen.line([0, 4.3], [now.ledge, now.ledge], { colour: 'limit', width: 2 });
    pen.text(4.29, now.ledge + 22 / pen.metreUp, 'ledge', { colour: 'limit', align: 'right' });
    this.machines.forEach((name, i) => this.machine(pen, now, settings, name, i));
  },
  machine(pen, now, settings, name, i) {
    const { Live } = globalThis;
    const left = i * this.wide,
      middle = left + 0.28,
      up = pixels => pixels / pen.metreUp;
    const late = [name, 'all'].includes(settings.late);
    pen.line([middle - 0.2, middle + 0.2], [now.highest[i], now.highest[i]], { colour: 'euler', width: 2 });
    pen.dot(middle, now.y[i] + up(11), 11, 'euler');
    pen.text(middle, 1.74, `${Live.fixed(now.highest[i], 3)}\u202fm`, { colour: 'euler' });
    pen.text(left + 0.48, -up(18), `${name.toUpperCase()}, ${settings[name]}\u202fHz`, { colour: 'ink' });
    if (late) pen.text(left + 0.48, -up(36), `late at ${Live.fixed(settings.at, 2)}\u202fs`, { colour: 'limit' });
    this.bucket(pen, now, settings, i, left + 0.56);
  },
  bucket(pen, now, { method }, i, left) {
    const { tall, deep, t } = this,
      right = left + 0.16;
    const passed = t - now.shown[i],
      fill = Math.min(deep, now.saved[i] + passed) * tall;
    pen.box([left, right], [0, fill], { colour: 'first', faint: 0.5 });
    if (method === 'fixed')
      for (let n = 1; n < 7; ++n)
        pen.line([left, right], [(n * tall) / 60, (n * tall) / 60], { colour: 'grid', width: 1 });
    pen.line([left, left, right, right], [deep * tall, 0, 0, deep * tall], { colour: 'context', width: 1.4 });
    for (let n = 0; n < now.spent[i]; ++n) {
      const step = now['step length'][i] * tall;
      pen.box([right + 0.05, right + 0.16], [n * step + 0.012, (n + 1) * step], { colour: 'euler', faint: 0.7 });
    }
  },
  // A late frame begins now, or where it was while nothing moves.
  take(x) {
    const late = this.machines[Math.floor(x / this.wide)];
    return late && { late, ...(this.goesOn && { at: this.t }) };
  },
  // Of the picture that is drawn, while a newer state is on its way.
  tell() {
    const { highest, stands } = this.now;
    const names = this.machines.map(name => name.toUpperCase()),
      on = names.filter((_, i) => stands[i]);
    const heights = names.map((name, i) => `${name} ${globalThis.Live.fixed(highest[i], 3)}`);
    return `on the ledge ${on.length ? on.join(', ') : 'nobody'}. Highest: ${heights.join(', ')}\u202fm.`;
  },
});
