// RK4 and the reader's, what lies between them under a lens, and how their errors fall with the step.
(function () {
  'use strict';
  const { Live } = globalThis;
  const BOTH = [
    ['your', 'second', 3.4],
    ['right', 'rk4', 1.4],
  ];
  // Where the picture has room for the names and for the lens, and what its axes go by; on a line, height over time.
  const SCENES = {
    drone: { view: { x: [-12, 12], y: [-12, 12] }, names: [-12, 11.5], lens: [0, 0], across: [], up: [] },
    parachute: {
      view: { x: [-0.1, 2.15], y: [-10.4, 0.6], free: true },
      names: [0.06, -8.8],
      lens: [1.6, -2],
      across: [0, 1, 2],
      up: [-10, -5, 0],
    },
    rocket: {
      view: { x: [-0.2, 4.3], y: [-6, 98], free: true },
      names: [2.65, 12],
      lens: [1.15, 66],
      across: [0, 2, 4],
      up: [0, 20, 40, 60, 80],
    },
  };
  const VISIBLE = 0.01; // to a player [m]
  const log = Math.log10;
  const faults = ({ third, fourth, moving, clock, weights }) =>
    [third === 'first', fourth !== 'third', moving === 'old', clock === 'stands', weights === 'equal'].filter(Boolean)
      .length;
  const words = (now, whose) => `order ${Live.fixed(now[`${whose} order`], 1)}`;
  const yours = values =>
    ['yours, without a fault', 'yours, one fault'][faults(values)] ?? `yours, ${faults(values)} faults`;

  Live.figure('stage-bug', {
    view: ({ scene }) => SCENES[scene].view,
    draw(pen, { now }, values) {
      const { names, across, up } = SCENES[values.scene];
      const until = list => list.slice(0, now.step + 1);
      pen.grid(across, up, { x: t => `${t}\u202fs`, y: y => `${Live.digits(y, 3)}\u202fm` });
      pen.line(now['way x'], now['way y'], { colour: 'exact', width: 1.2, dash: [5, 5] });
      for (const [whose, colour, width] of BOTH) {
        const [x, y] = [until(now[`${whose} x`]), until(now[`${whose} y`])];
        pen.line(x, y, { colour, width });
        if (values.rate <= 8) pen.dots(x, y, width, colour);
        pen.body(x.at(-1), y.at(-1), whose === 'your' ? 7 : 4, colour);
      }
      BOTH.forEach(([, colour], i) => {
        const label = i ? 'RK4' : yours(values);
        const fits = pen.x(names[0]) + pen.context.measureText(label).width < pen.canvas.clientWidth;
        const [x, align] = fits ? [names[0], 'left'] : [pen.view.x[1], 'right'];
        pen.text(x, names[1] - (18 * i) / pen.metreUp, label, { colour, align });
      });
      this.lens(pen, now, values, until);
    },
    // How far each was from the truth so far, on a scale on which the larger of the two just fits.
    lens(pen, now, { scene }, until) {
      const [x, y] = SCENES[scene].lens,
        across = 0.2 * pen.canvas.clientWidth;
      const fits = (0.9 * across) / pen.metreUp / Math.max(now['your off'], now['right off']);
      const times = [5, 2, 1].map(of => of * 10 ** Math.floor(log(fits))).find(of => of <= fits);
      if (!(times > 1)) return;
      const scale = times * pen.metreUp;
      pen.dot(x, y, across, 'paper');
      pen.circle(x, y, across / pen.metre, { colour: 'context', width: 1 });
      for (const [whose, colour, width] of BOTH) {
        const off = way => Array.from(until(now[`${whose} ${way}`]), (place, i) => place - now[`true ${way}`][i]);
        const xs = off('x').map(right => x + (right * scale) / pen.metre),
          ys = off('y').map(up => y + (up * scale) / pen.metreUp);
        pen.line(xs, ys, { colour, width: width / 2 });
        pen.dot(xs.at(-1), ys.at(-1), whose === 'your' ? 7 : 4, colour);
      }
      pen.circle(x, y, 10 / pen.metre, { colour: 'exact', width: 1.2 });
      pen.text(x, y - (across + 14) / pen.metreUp, `enlarged ${Live.fixed(times, 0)} times`);
    },

    // Powers of ten: of steps a second to the right, of metres upwards.
    chartView: { x: [-0.35, 2.6], y: [-12.6, 2], free: true },
    chart(pen, { now }, { rate, ...values }) {
      const { x, y } = this.chartView;
      pen.grid([0, 1, 2], [-9, -6, -3, 0], {
        x: power => String(10 ** power),
        y: power => Live.metres(10 ** power).replace('.0', ''),
      });
      pen.line([log(rate), log(rate)], y, { colour: 'ink', width: 1 });
      pen.line(x, [log(VISIBLE), log(VISIBLE)], { colour: 'limit', width: 1.6, dash: [3, 4] });
      pen.text(x[0] + 3 / pen.metre, log(VISIBLE) + 10 / pen.metreUp, Live.metres(VISIBLE).replace('.0', ''), {
        colour: 'limit',
        align: 'left',
      });
      for (const [whose, colour, width] of BOTH) {
        const points = Array.from(now[`${whose} errors`], (error, i) => [i * log(2), log(error)]);
        const seen = points.filter(point => Number.isFinite(point[1]));
        const [xs, ys] = [0, 1].map(k => seen.map(point => point[k]));
        pen.line(xs, ys, { colour, width });
        pen.dots(xs, ys, width, colour);
        pen.dot(log(rate), log(now[`${whose} off`]), whose === 'your' ? 7 : 4, colour);
        // Above the upper line and below the lower one, and not where the rate stands.
        const [at, height, align] = whose === 'your' ? [0.06, 12, 'left'] : [-0.06, -12, 'right'];
        const i = rate > 8 ? 2 : 6;
        if (whose === 'right' || words(now, 'your') !== words(now, 'right'))
          pen.text(i * log(2) + at, log(now[`${whose} errors`][i]) + height / pen.metreUp, words(now, whose), {
            colour,
            align,
          });
      }
    },
    held(power) {
      const { values } = Live.descriptions['stage-bug'].controls.find(({ name }) => name === 'rate');
      const off = value => Math.abs(log(value) - power);
      return { rate: values.reduce((near, value) => (off(value) < off(near) ? value : near)) };
    },

    // An index that names no slope of the header is another one; a stage that moves with the old velocity goes along v.
    edits({ third, fourth, moving, clock, weights }) {
      const along = { first: 1, second: 2, third: 3 };
      const velocity = from => (moving === 'old' || from === 'first' ? 'v' : `v${along[from]}`);
      const time = (line, word) => [line, word, clock === 'stands' ? 't' : word, 'clock'];
      const weight = line => [
        [line, '6', weights === 'equal' ? '4' : '6', 'weights'],
        [line, '2', weights === 'equal' ? '1' : '2', 'weights'],
      ];
      return [
        time('const Vec a2', 't_middle'),
        ['const Vec v3', 'a2', `a${along[third]}`, 'third'],
        ['const Vec a3', 'v2', velocity(third), 'moving'],
        time('const Vec a3', 't_middle'),
        ['const Vec v4', 'a3', `a${along[fourth]}`, 'fourth'],
        ['const Vec a4', 'v3', velocity(fourth), 'moving'],
        time('const Vec a4', 't_end'),
        ...weight('x = x'),
        ...weight('v = v'),
      ];
    },
    tell(now, values) {
      const [off, right] = [now['your off'], now['right off']].map(Live.metres);
      const seen = now['your off'] < VISIBLE ? 'no player sees it' : 'a player sees it';
      const [order, wanted] = [words(now, 'your'), words(now, 'right')];
      const unseen = faults(values) ? ', as RK4 has: this scene finds nothing wrong' : '';
      return `yours is up to ${off} off, RK4 ${right}: ${seen}. Yours has ${order}${order === wanted ? unseen : `, RK4 ${wanted}`}.`;
    },
  });
})();
