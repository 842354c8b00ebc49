// One step of RK4, which looks four times.
globalThis.Live.oneStep('four-looks');
