// Twelve methods on one spring: for each its part of the map, with the spring as a dot, and what becomes of the spring.
globalThis.Live.figure('your-spring', {
  view: () => ({ x: [0, 2], y: [0, 6], free: true }),
  low: 0.06, // of its row, where the two pictures of a method begin
  high: 0.65,
  map: { left: 0.03, width: 0.37 }, // of its column
  names: globalThis.Live.descriptions['your-spring'].controls.find(({ name }) => name === 'method').choices,
  // A place in a map is a spring for its method; beside the map it is the method alone.
  take(x, y) {
    const { Live } = globalThis;
    const row = 5 - Math.floor(y);
    const method = Object.keys(this.names)[2 * row + Math.floor(x)];
    const [right, up] = [((x % 1) - this.map.left) / this.map.width, ((y % 1) - this.low) / this.high];
    const inside = right >= 0 && right <= 1 && up >= 0 && up <= 1;
    return { method, ...(inside && Live.springAt(right, up, this.rate)) };
  },
  // Where the picture of a method lies: its own in a column, from the bottom up.
  cell(pen, name, chosen) {
    const i = Object.keys(this.names).indexOf(name),
      left = i % 2,
      low = 5 - Math.floor(i / 2) + this.low;
    const box = (at, width) =>
      globalThis.Live.frame(pen, { left: left + at, low, width, high: this.high }, name === chosen);
    return { left, low, box };
  },
  ghost(pen, run, { method }) {
    this.path(pen, this.cell(pen, method, method).box(0.45, 0.53), method, run);
  },
  draw(pen, run, { omega, zeta, rate, method, own }) {
    const { Live } = globalThis,
      { tables } = Live.descriptions['your-spring'];
    this.rate = rate;
    this.lost = Object.keys(this.names).filter(name => run.trace[name].some(x => !(Math.abs(x) < run.now.far)));
    Object.entries(this.names).forEach(([name, label]) => {
      const { left, low, box } = this.cell(pen, name, method);
      pen.text(left + 0.03, low + 0.81, Live.nameInList(name, label, { own }), { colour: name, align: 'left' });
      if (this.lost.includes(name)) pen.text(left + 0.98, low + 0.81, 'lost', { colour: 'limit', align: 'right' });
      Live.map(
        pen,
        box(this.map.left, this.map.width),
        tables.map,
        { label, colour: name, changed: Live.standsFor(name, { own }) },
        { homega: omega / rate, zeta },
      );
      this.path(pen, box(0.45, 0.53), name, run);
    });
  },
  path(pen, { x, y }, name, { now, trace, seconds }) {
    const most = 1.5,
      height = value => y(0.5 + value / (2 * most));
    pen.line(
      [...now.path].map((_, i) => x(i / (now.path.length - 1))),
      [...now.path].map(height),
      { colour: 'exact', width: 1.2, dash: [4, 3] },
    );
    const out = trace[name].findIndex(value => !(Math.abs(value) <= most));
    const inside = trace[name]
      .slice(0, out < 0 ? undefined : out + 1)
      .map(value => height(Math.max(-most, Math.min(most, value))));
    pen.line(
      trace.t.slice(0, inside.length).map(t => x(t / seconds)),
      inside,
      { colour: name, width: 1.5 },
    );
  },
  tell({ x, 'true x': truth }, { method, own }) {
    const number = value => globalThis.Live.fixed(value, 2),
      lost = this.lost.includes(method);
    const count =
      this.lost.length === 0
        ? 'No method has lost it'
        : `${this.lost.length} of ${Object.keys(this.names).length} methods ${this.lost.length === 1 ? 'has' : 'have'} lost it`;
    const name = globalThis.Live.nameInSentence(method, this.names[method], { own });
    return `${name} ${lost ? 'has lost it' : `has it at ${number(x)}`}, and it should be at ${number(truth)}. ${count}.`;
  },
});
