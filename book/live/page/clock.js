// Spends the time that frames deliver in steps of the scene.
(function () {
  'use strict';
  const Live = (globalThis.Live ??= {});
  const LONGEST = 0.1; // of a frame [s]; what is over is dropped
  const BUDGET = 8; // for the steps of a frame [ms]: half of what 60 frames a second leave

  Live.Clock = class {
    constructor(pace) {
      this.pace = pace;
      this.restart();
    }
    restart() {
      this.saved = 0;
      this.last = null;
      this.dropped = 0;
    }
    // Whether it ran slower than time during the last few frames.
    get slow() {
      return this.dropped > 0.05;
    }
    // Takes the steps due at `now` [ms]; where a step is a frame of the reader's own screen, that one.
    frame(now, run) {
      const passed = this.last === null ? 0 : Math.max(0, now - this.last) / 1000;
      this.last = now;
      if (run.frames) {
        if (passed) run.frame(Math.min(passed, LONGEST) * this.pace);
        this.dropped = 0.9 * this.dropped + Math.max(0, passed - LONGEST);
        return;
      }
      this.saved += Math.min(passed, LONGEST) * this.pace;
      const end = performance.now() + BUDGET;
      // Steps may be of any lengths: one is due when the picture has come to the newest state.
      while (this.saved >= run.gap && !run.ended && performance.now() <= end) {
        this.saved -= run.gap;
        run.step();
      }
      const late = run.ended ? 0 : Math.max(0, this.saved - run.gap);
      this.saved -= late;
      this.dropped = 0.9 * this.dropped + Math.max(0, passed - LONGEST) + late / this.pace;
    }
    // How far the picture is from the last state but one to the last.
    part(run) {
      return run.ended || run.frames || run.gap === 0 ? 1 : this.saved / run.gap;
    }
  };
})();
