// Three cloths that hang side by side, and the blow that hits them all.
globalThis.Live.figure('three-cloths', {
  cloths: [
    ['backward_euler', 'Backward Euler'],
    ['bdf2', 'BDF2'],
    ['symplectic_euler', 'Substeps'],
  ],
  apart: 1.22, // [m]
  // How far a metre to the right is drawn, and one away from the eye: to the right and upwards.
  across: 0.9,
  away: [0.45, 0.28],
  view: () => ({ x: [-1.78, 1.92], y: [-1.42, 0.28] }),
  middle(i) {
    return (i - 1) * this.apart;
  },
  draw(pen, run, settings, part) {
    const { fixed } = globalThis.Live;
    this.cloths.forEach(([method, name], i) => {
      const chosen = settings.method === method,
        middle = this.middle(i);
      this.net(pen, run, method, middle, part, chosen ? 1.8 : 1.1);
      const words = method === 'symplectic_euler' ? `${run.now.substeps} substeps` : name;
      pen.text(middle, 20 / pen.metre, words, { colour: method });
      const left = run.blend(`${method} energy`, part);
      const share = Math.abs(left) < 100 ? `${fixed(100 * left, 0)}\u202f%` : 'lost';
      pen.text(middle, -1.3, share, { colour: method });
      this.arrow(pen, settings, middle);
    });
  },
  // Rows and columns, each as one line that turns at the edges, as a weaver's does.
  net(pen, run, method, middle, part, width) {
    const x = run.blend(method, part),
      { side } = run.now;
    const at = Array.from({ length: side * side }, (_, i) => [
      middle + this.across * x[3 * i] - this.away[0] * x[3 * i + 2],
      x[3 * i + 1] - this.away[1] * x[3 * i + 2],
    ]);
    const turned = (line, i) => (line % 2 ? side - 1 - i : i);
    const thread = place => {
      const points = at.map((_, n) => at[place(Math.floor(n / side), turned(Math.floor(n / side), n % side))]);
      pen.line(
        points.map(([right]) => right),
        points.map(([, up]) => up),
        { colour: method, width },
      );
    };
    thread((row, i) => row * side + i);
    thread((column, i) => i * side + column);
    for (const corner of [at[0], at[side - 1]]) pen.dot(...corner, 3.5, 'ink');
  },
  // From before the cloth to where it hits it.
  arrow(pen, { speed, 'hit x': x, 'hit y': y }, middle) {
    const long = 0.1 + 0.08 * speed,
      [right, up] = this.away;
    const tip = middle + this.across * x;
    pen.arrow(tip - long * right, y - long * up, tip, y, { colour: 'ink', width: 1.6 });
  },
  take(x, y) {
    const i = Math.max(0, Math.min(2, Math.round(x / this.apart) + 1));
    return { 'hit x': (x - this.middle(i)) / this.across, 'hit y': y };
  },
  tell(now) {
    const left = this.cloths.map(([method, name]) => {
      const share = Math.max(0, now[`${method} energy`]); // bulged, a cloth hangs a little lower than flat
      return `${name} ${share < 100 ? `${globalThis.Live.fixed(100 * share, 0)}\u202f%` : 'more than all'}`;
    });
    return `of the energy of the blow they have: ${left.join(', ')}.`;
  },
});
