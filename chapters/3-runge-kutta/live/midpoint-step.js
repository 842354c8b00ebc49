// One step of the midpoint method, which looks twice.
globalThis.Live.oneStep('midpoint-step');
