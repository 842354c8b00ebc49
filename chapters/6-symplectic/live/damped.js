// Each way to treat the drag holds the spring below its line.
globalThis.Live.dotOnThePlane('damped', {
  right: 2,
  top: 5,
  lost: [0.3, 4.5],
  held: [0.5, 0.3],
  names: {
    euler: [1.1, 2.25],
    symplectic_euler: [1.2, 0.3],
    linear_damping_implicit_last: [0.98, 4.2],
    linear_damping_implicit_first: [1.5, 1.85],
  },
});
