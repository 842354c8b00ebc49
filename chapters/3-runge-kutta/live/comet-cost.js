// The comet's whole way, what is next to its sun, and what the frames around this one cost.
(function () {
  'use strict';
  const { Live } = globalThis,
    { list } = Live;
  const VIEW = { x: [0, 300], y: [0, 250] };
  const WHOLE = { scale: 1.42, x: 287, y: 212 }; // where the sun stands, and a metre
  const NEAR = { left: 200, right: 298, bottom: 3, top: 165, scale: 8, x: 258, y: 84 };
  const COSTS = { left: 27, right: 190, bottom: 18, top: 165, seconds: 0.4, most: 220 };
  const colourOf = ({ method }) => (method === 'equal' ? 'rk4' : 'dopri5');

  Live.figure('comet-cost', {
    view: () => VIEW,
    draw(pen, run, values, part) {
      const colour = colourOf(values);
      const comet = [run.blend('x', part), run.blend('y', part)];
      pen.ellipse(
        WHOLE.x - 97 * WHOLE.scale,
        WHOLE.y,
        100 * WHOLE.scale,
        Math.sqrt(1 - 0.97 ** 2) * 100 * WHOLE.scale,
        {
          colour: 'exact',
          width: 1,
          dash: [5, 5],
        },
      );
      this.field(pen, run.now, WHOLE, colour, comet, 1.5);
      pen.within([NEAR.left, NEAR.right], [NEAR.bottom, NEAR.top], { colour: 'context', width: 1 }, () =>
        this.field(pen, run.now, NEAR, colour, comet, 2.2),
      );
      const half = 9 / pen.metre;
      pen.text(150, WHOLE.y + half, 'each dot a step', { colour });
      if (list(run.now['missed x']).length)
        pen.text(150, WHOLE.y - half, 'each red dot a rejected try', { colour: 'limit' });
      this.costs(pen, run, colour);
    },
    field(pen, now, { scale, x, y }, colour, comet, size) {
      // Dots that would lie on each other are one.
      const dots = (of, count, pixels, colour) => {
        const [across, up] = [list(now[`${of} x`]), list(now[`${of} y`])];
        const xs = [],
          ys = [];
        let last = [Infinity, Infinity];
        for (let i = 0; i < count; ++i) {
          const at = [x + scale * across[i], y + scale * up[i]];
          if (Math.hypot(at[0] - last[0], at[1] - last[1]) * pen.metre < 2) continue;
          last = at;
          xs.push(at[0]);
          ys.push(at[1]);
        }
        pen.dots(xs, ys, pixels, colour);
      };
      pen.dot(x, y, 4, 'context');
      dots('step', now.steps, size, colour);
      dots('missed', now.missed, size + 0.5, 'limit');
      pen.dot(x + scale * comet[0], y + scale * comet[1], 6, colour);
    },
    // Bars as a staircase, of those that have been and, faintly, of those to come.
    costs(pen, { now }, colour) {
      const { left, right, bottom, top, seconds, most } = COSTS;
      const across = (right - left) / (2 * seconds * Math.round(1 / now.h)),
        middle = (left + right) / 2,
        high = (top - bottom) / most;
      const last = Math.round(now.t / now.h) - 1;
      const bars = (from, to, look) => {
        const xs = [],
          ys = [];
        for (let n = Math.max(0, from); n < Math.min(to, now.costs.length); ++n) {
          const at = middle + (n - last) * across;
          const height = bottom + high * now.costs[n];
          xs.push(at, at, at + 0.8 * across, at + 0.8 * across);
          ys.push(bottom, height, height, bottom);
        }
        pen.area(xs, ys, look);
      };
      const reach = Math.floor((middle - left) / across);
      pen.within([left, right], [bottom, top], { colour: 'grid', width: 1 }, () => {
        for (const cost of [50, 100, 150, 200])
          pen.line([left, right], [bottom + high * cost, bottom + high * cost], { colour: 'grid', width: 1 });
        bars(last - reach, last, { colour });
        bars(last + 1, last + reach, { colour, faint: 0.35 });
        bars(last, last + 1, { colour: 'ink' });
      });
      for (const cost of [0, 50, 100, 150, 200])
        pen.text(left - 2, bottom + high * cost, String(cost), { align: 'right' });
      pen.text(middle, bottom - 10, `frames within ${seconds}\u202fs`);
    },
    tell: now =>
      `this frame asked ${now.cost} times, at most so far ${now.dearest}, all so far ${Live.fixed(now.sum, 0)} times; the comet is ${now.error < 1e-9 ? 'less than a nanometre' : Live.metres(now.error)} off.`,
  });
})();
