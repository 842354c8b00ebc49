// One step of backward Euler, whose slope is that of its end.
globalThis.Live.oneStep('from-the-end');
