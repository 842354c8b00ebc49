// The whole run under some settings, faint behind the one that is played: what is to come, and what was before a change.
(function () {
  'use strict';
  const Live = (globalThis.Live ??= {});

  Live.Ahead = class {
    // `run` has a module of its own, so that looking ahead disturbs nothing.
    constructor(run) {
      this.run = run;
    }
    of(values) {
      const asked = JSON.stringify(values);
      if (asked !== this.asked) {
        this.run.start(values);
        this.run.finish();
        this.asked = asked;
      }
      return this.run;
    }
    // What the next change leaves behind: { trace, values }. The run writes its next trace into lists of its own.
    keep(values) {
      return { trace: this.of(values).trace, values };
    }
  };
})();
