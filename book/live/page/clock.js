// Spends the time that frames deliver in steps of the scene.
(function () {
  'use strict';
  const Live = globalThis.Live ??= {};
  const LONGEST = 0.1;  // of a frame [s]; what is over is dropped
  const BUDGET = 8;     // for the steps of a frame [ms]: half of what 60 frames a second leave

  Live.Clock = class {
    constructor(pace) {
      this.pace = pace;
      this.restart();
    }
    restart() {
      this.saved = 0;
      this.last = null;
      this.slow = false;
    }
    // Takes the steps due at `now` [ms].
    frame(now, run) {
      const passed = this.last === null ? 0 : Math.max(0, now - this.last) / 1000;
      this.last = now;
      this.saved += Math.min(passed, LONGEST) * this.pace;
      const end = performance.now() + BUDGET;
      for (; this.saved >= run.now.h && !run.ended; this.saved -= run.now.h) {
        if (performance.now() > end) break;
        run.step();
      }
      this.slow = !run.ended && this.saved >= run.now.h;
      if (this.slow) this.saved = 0;
    }
    // How far the picture is from the last state but one to the last.
    part(run) { return run.ended ? 1 : this.saved / run.now.h; }
  };
})();
