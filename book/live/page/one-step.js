// One step on paper: where a method looks, what it finds there, and where it ends. Time is counted in looks.
(function () {
  'use strict';
  const Live = (globalThis.Live ??= {});
  const ARROW = 0.3; // seconds that the velocity at a look is followed in the picture

  Live.oneStep = name => {
    const [method] = Object.keys(Live.descriptions[name].methods);
    const { list } = Live;
    const count = now => list(now['look x']).length;
    const isDone = now => now.t > count(now);
    let omega, start;

    Live.figure(name, {
      view: () => ({ x: [-1.2, 13.2], y: [-1.8, 12.6] }),
      // Where the step should end: along the circle.
      take(x, y) {
        const angle = Math.atan2(y, x) - Math.atan2(start[1], start[0]);
        return angle > 0 && { step: angle / omega };
      },
      draw(pen, { now }, { 'start x': x, 'start y': y }) {
        [omega, start] = [now.omega, [x, y]];
        pen.grid([0, 5, 10], [0, 5, 10]);
        pen.circle(0, 0, Math.hypot(x, y), { colour: 'context', width: 1 });
        pen.line(now['true x'], now['true y'], { colour: 'exact', width: 2 });
        pen.circle(now['true x'].at(-1), now['true y'].at(-1), 8 / pen.metre, { colour: 'exact', width: 1.4 });
        for (let k = 0; k < Math.min(now.t, count(now)); ++k) this.look(pen, now, start, k);
        pen.dot(0, 0, 4, 'context');
        if (isDone(now)) this.end(pen, start, [now['end x'], now['end y']]);
      },
      // The step, with the tower as a triangle, and the circle on which the drone is now.
      end(pen, from, to) {
        pen.line([from[0], 0, to[0]], [from[1], 0, to[1]], { colour: 'context', width: 1 });
        pen.circle(0, 0, Math.hypot(...to), { colour: 'context', width: 1, dash: [2, 5] });
        pen.arrow(...from, ...to, { colour: method, width: 2.4 });
        pen.dot(...to, 5, method);
      },
      // The guess that leads there, and the velocity that is found.
      look(pen, now, [fromX, fromY], k) {
        const [x, y, u, v] = ['look x', 'look y', 'look u', 'look v'].map(of => list(now[of])[k]);
        pen.line([fromX, x], [fromY, y], { colour: 'context', width: 1.2, dash: [3, 4] });
        pen.arrow(x, y, x + ARROW * u, y + ARROW * v, { colour: method, width: 1.6 });
        pen.dot(x, y, 3.5, method);
        if (count(now) > 1) pen.text(x + 0.35, y - 0.25, String(k + 1), { colour: method });
      },
      when: now => (now.t === 0 ? 'Start' : isDone(now) ? 'End' : `Look ${now.t} of ${count(now)}`),
      tell(now) {
        if (now.t === 0) return 'the drone moves along its circle.';
        if (isDone(now)) return `${Live.metres(now.error)} from where the drone should be.`;
        const [t, u, v, a] = ['look t', 'look u', 'look v', 'look a'].map(of => list(now[of])[now.t - 1]);
        return `${Live.digits(t, 3)}\u202fs into the step the speed is ${Live.fixed(Math.hypot(u, v), 2)}\u202fm/s, and the pull ${Live.fixed(a, 2)}\u202fm/s².`;
      },
      // A look belongs to the lines up to the one that asks for it, and the end to those behind the last.
      lit(now, lines) {
        const asks = lines.flatMap((line, i) => (/\bacceleration\(/.test(line) ? [i] : []));
        if (now.t === 0) return [0, -1];
        if (isDone(now)) return [asks.at(-1) + 1, lines.length - 1];
        return [
          (asks[now.t - 2] ?? -1) + 1,
          asks[now.t - 1],
          `${Live.fixed(list(now['look a'])[now.t - 1], 2)}\u202fm/s²`,
        ];
      },
    });
  };
})();
