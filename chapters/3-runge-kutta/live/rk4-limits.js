// Each method holds the spring below its line.
globalThis.Live.dotOnThePlane('rk4-limits', {
  right: 3.1,
  top: 3.3,
  lost: [2.1, 2.4],
  held: [1, 0.25],
  names: { euler: [0.35, 1], midpoint: [0.36, 2.27], rk4: [1.28, 2.6] },
});
