// A spring as a dot on the plane of its damping ratio and of h omega, with the line up to which each method holds it.
(function () {
  'use strict';
  const Live = (globalThis.Live ??= {});
  const COILS = Array.from({ length: 17 }, (_, i) => i);

  // A spring that hangs from `top`, `across` to each side.
  Live.coil = (pen, x, top, bottom, across) =>
    pen.line(
      COILS.map(i => x + (i % 2 ? across : -across) * (i > 0 && i < 16)),
      COILS.map(i => top + ((bottom - top) * i) / 16),
      { colour: 'context', width: 1.4 },
    );

  // What is 1 but for rounding is 1, and what only looks so is not.
  function words(factor) {
    if (factor < 1e-6) return '0';
    if (Math.abs(factor - 1) < 1e-12 || Math.abs(factor - 1) > 5e-3) return Live.digits(factor, 3);
    return `a little ${factor > 1 ? 'more' : 'less'} than 1`;
  }

  // The plane goes to `right` and `top`; `lost` and `held` are where the words stand, and `names` where those of the lines do.
  Live.dotOnThePlane = function (name, { right, top, lost, held, names }) {
    const { methods, controls, chart } = Live.descriptions[name];
    const labels = methods ?? controls[0].choices;
    const colour = of => chart.colours?.[of] ?? of;
    const thing = 1.14 * right; // where the spring hangs
    const height = x => top * (0.42 - 0.2 * x);

    Live.figure(name, {
      view: () => ({ x: [-0.07 * right, 1.26 * right], y: [-0.09 * top, 1.06 * top], free: true }),
      take: (x, y) => x >= 0 && x <= right && y <= top && { zeta: x, homega: Math.max(0.02, y) },
      draw(pen, run, { method = Object.keys(labels)[0], zeta, homega }, part) {
        const zetas = [...run.now.zetas];
        const edge = of => [...run.now[`${of} edge`]];
        pen.grid(
          [0, 0.5, 1, 1.5, 2, 2.5, 3].filter(x => x <= right),
          [1, 2, 3, 4, 5].filter(y => y <= top),
        );
        pen.within([0, right], [0, top], { colour: 'context', width: 1 }, () => {
          pen.area([0, ...zetas, right], [0, ...edge(method), 0], { colour: colour(method), faint: 0.18 });
          for (const of of Object.keys(labels))
            pen.line(zetas, edge(of), { colour: colour(of), width: of === method ? 2.4 : 1.2 });
        });
        pen.text(...lost, 'explodes', { colour: 'limit' });
        pen.text(...held, 'dies away', { colour: colour(method) });
        for (const [of, at] of Object.entries(names))
          pen.text(...at, labels[of], { colour: colour(of), align: 'left' });
        pen.dot(zeta, homega, 4, colour(method));
        const x = height(run.blend('x', part));
        Live.coil(pen, thing, top, x, 0.04 * right);
        pen.body(thing, x, 9, colour(method));
      },
      // The line and these two are known of the method as it is; of one that was changed only the spring tells.
      tell({ factor, area }, { own = 'none' }) {
        const [long, any] = [factor, Math.abs(area)].map(words);
        const whose = own === 'none' ? '' : ' of the method as it is';
        return `in the long run a step${whose} multiplies what is left by ${long}, and any area by ${any}.`;
      },
    });
  };
})();
