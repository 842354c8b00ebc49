// Ten methods and six things as a table; below it the one that is chosen, beside the truth.
globalThis.Live.figure('level', {
  // How wide the names of the methods are, where a thing is one wide.
  get left() {
    return this.narrow ? 2.5 : 1.9;
  },
  low: 6, // rows for the picture of the thing
  view(_, width) {
    this.narrow = width < 520; // pixels
    return { x: [0, this.left + 6], y: [0, 12.6 + this.low], free: true };
  },
  choices: of => globalThis.Live.descriptions.level.controls.find(({ name }) => name === of).choices,
  // The cell of a thing and a method.
  take(x, y) {
    const thing = Object.keys(this.choices('thing'))[Math.floor(x - this.left)];
    const method = Object.keys(this.choices('method'))[Math.floor(11 + this.low - y)];
    return thing && method && { thing, method };
  },
  draw(pen, run, chosen, part) {
    const size = this.narrow ? 10 : 13;
    this.table(pen, run.now, chosen, size);
    this.ghost(pen, run, chosen, part);
  },
  ghost(pen, run, { method }, part) {
    const top = this.low - 0.4;
    pen.within([0.05, this.left + 5.95], [0.1, top], { colour: 'grid', width: 1 }, () =>
      this.play(pen, run, method, part, { right: this.left + 6, top }),
    );
  },
  table(pen, { errors, bills, tolerance }, chosen, size) {
    const things = Object.entries(this.choices('thing'));
    const row = i => 11 + this.low - i - 0.5;
    const cell = (i, j) => [
      [this.left + j, this.left + j + 1],
      [row(i) - 0.5, row(i) + 0.5],
    ];
    things.forEach(([, label], j) =>
      pen.text(this.left + j + 0.5, row(-1) + (size < 13 && j % 2 ? 0.6 : 0), label, { size }),
    );
    Object.entries(this.choices('method')).forEach(([method, label], i) => {
      const name = globalThis.Live.nameInList(method, label, chosen);
      pen.text(this.left - 0.1, row(i), name, { colour: method, align: 'right', size });
      things.forEach(([thing], j) => {
        const error = errors[10 * j + i];
        const misses = !(error <= tolerance);
        if (misses) pen.box(...cell(i, j), { colour: 'area' });
        if (thing === chosen.thing && method === chosen.method) pen.frame(...cell(i, j), { colour: method, width: 2 });
        pen.text(this.left + j + 0.5, row(i), this.amount(error), { colour: misses ? 'limit' : 'ink', size });
      });
    });
    pen.text(this.left - 0.1, row(10), 'fewest a frame', { align: 'right', size });
    things.forEach((_, j) =>
      pen.text(this.left + j + 0.5, row(10), bills[j] < 1000 ? String(bills[j]) : 'none', { size }),
    );
  },
  amount(error) {
    if (!(error < 1000)) return 'gone';
    if (error < 1e-5) return this.narrow ? '0' : '< 10\u202fµm';
    return globalThis.Live.metres(error);
  },
  // A place in the plane is drawn there, and a height or a stretch against time.
  play(pen, { now, seconds }, method, part, { right, top }) {
    const { path, truth, coordinates } = now;
    const frames = truth.length / coordinates;
    const reach = [...truth].reduce((most, value) => Math.max(most, Math.abs(value)), 0);
    const [middle, scale] = [top / 2, (0.42 * top) / reach];
    const across = (scale * pen.metreUp) / pen.metre; // as long sideways as upwards
    const at = (list, n) =>
      coordinates > 1
        ? [right / 2 + across * list[coordinates * n], middle + scale * list[coordinates * n + 1]]
        : [0.2 + ((right - 0.4) * n) / (frames - 1), middle + scale * list[n]];
    const points = list => Array.from({ length: frames }, (_, n) => at(list, n));
    const draw = (list, until, look) => {
      const shown = points(list).slice(0, until);
      pen.line(
        shown.map(([x]) => x),
        shown.map(([, y]) => y),
        look,
      );
    };
    const n = Math.min(frames - 1, Math.round((now.t / seconds) * (frames - 1)));
    draw(truth, frames, { colour: 'exact', width: 1.2, dash: [5, 5] });
    draw(path, n + 1, { colour: method, width: 1.8 });
    pen.circle(...at(truth, n), 7 / pen.metre, { colour: 'exact', width: 1.2 });
    pen.dot(...at(path, n), 5, method);
  },
  tell({ error }, { thing, method, own }) {
    const label = globalThis.Live.nameInSentence(method, this.choices('method')[method], { own });
    if (!(error < 1000)) return `${label} has lost the ${thing}.`;
    return `${label} has the ${thing} ${this.amount(error).replace('<', 'less than')} from its true place.`;
  },
});
