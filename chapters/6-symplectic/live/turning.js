// The shuttle's last turn, and a dot where each turn had its farthest point.
globalThis.Live.figure('turning', {
  view: () => ({ x: [-20, 20], y: [-20, 20] }),
  draw(pen, run, { method }, part) {
    pen.grid([-10, 0, 10], [-10, 0, 10]);
    const { now, trace } = run;
    pen.dots(trace['farthest x'], trace['farthest y'], 1.2, 'context');
    pen.line(now['true x'], now['true y'], { colour: 'exact', width: 1.4, dash: [7, 5] });
    pen.line(now['turn x'], now['turn y'], { colour: method, width: 1.8 });
    pen.dot(0, 0, 5, 'context');
    pen.body(run.blend('x', part), run.blend('y', part), 5, method);
  },
  tell(now) {
    const far = Math.hypot(now['farthest x'], now['farthest y']);
    if (Number.isNaN(far))
      return `no turn yet, ${globalThis.Live.fixed(Math.hypot(now.x, now.y), 1)}\u202fm from the planet.`;
    return `${now.turns} ${now.turns === 1 ? 'turn' : 'turns'}, the last one ${globalThis.Live.fixed(far, 1)}\u202fm out instead of 16.`;
  },
});
