// Euler's method holds the spring below the line.
globalThis.Live.dotOnThePlane('spring-limit', { right: 3.1, top: 2.2, lost: [2, 1.6], held: [0.92, 0.25], names: {} });
