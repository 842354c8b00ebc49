// One step of Euler's method, along the tangent.
globalThis.Live.oneStep('tangent');
