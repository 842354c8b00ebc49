// The times of a figure's methods on the reader's machine, taken beside the page and not in its frames.
(function () {
  'use strict';
  const Live = (globalThis.Live ??= {});

  // Each method in turn, again and again; its time is the median. A turn is long enough for a clock of whole milliseconds.
  function work() {
    const { Live } = globalThis;
    const LONG = 20, // [ms]
      TURNS = 9;
    let opened;
    globalThis.onmessage = async ({ data: { code, name, settings, methods, about } }) => {
      opened ??= await Live.open(code, name);
      for (const [setting, value] of Object.entries(settings)) opened.set(setting, value);
      opened.start();
      const takes = (i, rounds) => {
        const from = performance.now();
        opened.work(i, rounds);
        return performance.now() - from;
      };
      const idle = methods.map((_, i) => Number.isNaN(opened.work(i, 1))); // what is not for this thing
      const rounds = methods.map((_, i) => {
        if (idle[i]) return 0;
        let enough = 64;
        while (takes(i, enough) < LONG) enough *= 2;
        return enough;
      });
      const taken = methods.map(() => []);
      for (let turn = 0; turn < TURNS; ++turn)
        methods.forEach((_, i) =>
          taken[i].push(idle[i] ? NaN : (1e6 * takes(i, rounds[i])) / (rounds[i] * opened.bodies)),
        );
      const median = list => list.sort((a, b) => a - b)[(TURNS - 1) / 2];
      globalThis.postMessage({
        about,
        times: Object.fromEntries(methods.map((method, i) => [method, median(taken[i])])),
      });
    };
  }

  // The book's methods alone are timed.
  const noReader = () => ({ imports: { step() {} }, join() {}, begin() {}, timed: call => call() });

  Live.Stopwatch = class {
    // `description` says by `timed` which setting a time belongs to, and names the methods; `told` is called when there are new ones.
    constructor(code, name, told) {
      const { timed, methods, controls } = Live.descriptions[name];
      const asked = controls.filter(({ page, chips }) => !page && !chips).map(control => control.name);
      Object.assign(this, { code, name, told, timed, methods: Object.keys(methods), asked, taken: {} });
    }
    // From now on, whatever comes up is timed; what has been is timed anew.
    begin(values) {
      if (this.taken[values[this.timed]]) delete this.taken[values[this.timed]];
      if (!this.worker) {
        const text = `globalThis.Live = { open: ${Live.open}, newReader: ${noReader} };\n(${work})();`;
        this.worker = new Worker(URL.createObjectURL(new Blob([text], { type: 'text/javascript' })));
        this.worker.addEventListener('message', ({ data: { about, times } }) => {
          this.taken[about] = times;
          this.told();
        });
      }
      this.ask(values);
    }
    ask(values) {
      const about = values[this.timed];
      if (about in this.taken) return;
      this.taken[about] = null; // on its way
      const settings = Object.fromEntries(this.asked.map(name => [name, values[name]]));
      const { code, name, methods } = this;
      this.worker.postMessage({ code, name, settings, methods, about });
    }
    // { method: time of a step of one body [ns] }; null while they are taken, and nothing where nobody asked.
    of(values) {
      if (this.worker) this.ask(values);
      return this.taken[values[this.timed]];
    }
  };
})();
