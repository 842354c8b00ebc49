// Seven leaves side by side. The picture falls with the true one, so that the others drift through it.
globalThis.Live.figure('terminal', {
  view: () => ({ x: [0, 7], y: [-4, 4.3], free: true }),
  curves: () => globalThis.Live.descriptions.terminal.chart.curves,
  draw(pen, run, _, part) {
    const truth = run.blend('true', part);
    const lines = [-3, -2, -1, 0, 1, 2, 3].map(y => y + Math.ceil(truth) - truth);
    for (const y of lines) pen.line([0, 7], [y, y], { colour: 'grid', width: 1 });
    pen.line([0, 7], [0, 0], { colour: 'exact', width: 1.2, dash: [7, 5] });
    this.curves().forEach(({ value, colour, label }, i) => {
      const x = i + 0.5;
      const y = run.blend(value.replace(' speed', ''), part) - truth;
      const [across, up] = [16 / pen.metre, 7 / pen.metreUp];
      if (Math.abs(y) > 2.8) pen.arrow(x, 2.3 * Math.sign(y), x, 2.8 * Math.sign(y), { colour, width: 2 });
      else pen.area([x - across, x, x + across, x], [y, y + up, y, y - up], { colour });
      const narrow = pen.metre < 75; // pixels of a lane
      const short = narrow ? label.replace(/(exp|expl|impl)(onential|icit)/, '$1.') : label;
      short.split(' ').forEach((word, line) => pen.text(x, 3.95 - 0.42 * line, word, { colour }));
      const speed = globalThis.Live.fixed(run.now[value] * run.now.end, 2);
      pen.text(x, -3.6, narrow ? speed : `${speed}\u202fm/s`, { colour });
    });
  },
  tell(now) {
    if (now.t === 0) return 'all start at rest.';
    const right = this.curves().filter(
      ({ value }) => value !== 'true speed' && Math.abs(now[value] / now['true speed'] - 1) < 0.005,
    );
    const names = right.map(({ label }) => label).join(', ');
    return `the true leaf falls at ${globalThis.Live.fixed(now['true speed'] * now.end, 2)}\u202fm/s. Within half a per cent of that: ${names || 'none'}.`;
  },
});
