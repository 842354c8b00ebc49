// The cat within a step, and arrows along which its points move.
globalThis.Live.figure('shears', {
  view: () => ({ x: [-2.1, 2.1], y: [-1.7, 1.45] }),
  draw(pen, { now }, { method }) {
    pen.grid([-2, -1, 0, 1, 2], [-2, -1, 0, 1, 2]);
    const half = this.half(now, method),
      drifts = half === 'drift';
    now['from x'].forEach((x, i) => {
      const [v, toX, toV] = ['from v', 'to x', 'to v'].map(name => now[name][i]);
      const path = { kick: [x, v, x, toV], drift: [x, toV, toX, toV], both: [x, v, toX, toV] };
      pen.arrow(...path[half], { colour: drifts ? 'second' : 'first', width: 1 });
    });
    pen.area(now.x, now.v, { colour: method, faint: 0.25 });
    pen.line([...now.x, now.x[0]], [...now.v, now.v[0]], { colour: method, width: 1.8 });
  },
  // Whether two edges of the outline have a point in common, other than the corner of two neighbours.
  crosses({ x, v }) {
    const side = (a, b, c) => (x[b] - x[a]) * (v[c] - v[a]) - (v[b] - v[a]) * (x[c] - x[a]);
    for (let i = 0; i < x.length; ++i) {
      const next = (i + 1) % x.length;
      for (let k = i + 2; k < x.length; ++k) {
        const last = (k + 1) % x.length;
        if (last === i) continue;
        if (side(i, next, k) * side(i, next, last) < 0 && side(k, last, i) * side(k, last, next) < 0) return true;
      }
    }
    return false;
  },
  half: ({ t }, method) => (method === 'euler' ? 'both' : (t + 1e-9) % 1 < 0.5 ? 'kick' : 'drift'),
  when: ({ t }) => (t > 4 - 1e-9 ? 'After 4 steps' : `Step ${Math.floor(t + 1e-9) + 1}`),
  tell(now, { method, own }) {
    const what = {
      kick: ['the kick moves each strip up or down', 'each point goes up or down'],
      drift: ['the drift moves each strip to the side', 'and then to the side'],
      both: ['both at once, from the old values', 'both at once'],
    };
    const area = `area is ${globalThis.Live.fixed(now.area, 1)}\u202f% of what it was.`;
    if ((method === 'euler' || own !== 'none') && this.crosses(now))
      return 'the outline crosses itself, and has no area any more.';
    return now.t > 4 - 1e-9 ? `its ${area}` : `${what[this.half(now, method)][own === 'none' ? 0 : 1]}. The ${area}`;
  },
});
