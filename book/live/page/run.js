// One run of a figure from its start to its end, and the trace that it leaves.
(function () {
  'use strict';
  const Live = (globalThis.Live ??= {});
  const MOST = 2000; // points of a trace, where no figure asks for more: more than a chart has pixels

  Live.Run = class {
    // `frames` is the setting that takes the length of a frame, where each step is a frame of the reader's own screen.
    constructor(module, { seconds, endless, frames, controls, points = MOST }) {
      const inThePage = controls.filter(({ page }) => page).map(({ name }) => name);
      Object.assign(this, { module, seconds, endless, frames, points, inThePage });
    }
    // What concerns the page alone stays there.
    set(values) {
      for (const [name, value] of Object.entries(values))
        if (!this.inThePage.includes(name)) this.module.set(name, value);
    }
    start(values) {
      this.set(values);
      this.now = this.before = this.module.start();
      this.seconds = this.now.seconds ?? this.seconds;
      this.stride = Math.ceil(this.seconds / this.now.h / this.points);
      this.taken = 0;
      this.trace = Object.fromEntries(
        Object.entries(this.now)
          .filter(([, value]) => typeof value === 'number')
          .map(([name]) => [name, []]),
      );
      this.note();
    }
    // Whether the next step would end behind the end; a little over, since t is rounded.
    get full() {
      return this.isDone(this.seconds);
    }
    isDone(until) {
      return this.now.t + this.now.h > until * (1 + 1e-9);
    }
    get ended() {
      return this.full && !this.endless;
    }
    // How much time lies between the last two states.
    get gap() {
      return this.now.t - this.before.t;
    }
    step() {
      this.before = this.now;
      this.now = this.module.advance(1);
      if (++this.taken % this.stride === 0) this.note();
    }
    frame(length) {
      this.module.set(this.frames, length);
      this.step();
    }
    // Goes to the end at once, or to some time; with other settings, the end may lie before it.
    finish(wanted = this.seconds) {
      const until = Math.min(wanted, this.seconds);
      while (!this.isDone(until)) {
        const left = Math.floor((until * (1 + 1e-9) - this.now.t) / this.now.h);
        const steps = Math.max(1, Math.min(this.stride - (this.taken % this.stride), left));
        this.now = this.before = this.module.advance(steps);
        this.taken += steps;
        if (this.taken % this.stride === 0) this.note();
      }
    }
    // To a moment within the run, on or back.
    goTo(values, t) {
      if (t < this.now.t) this.start(values);
      this.finish(Math.max(0, t));
    }
    // One without an end keeps its last seconds.
    note() {
      for (const [name, list] of Object.entries(this.trace)) list.push(this.now[name]);
      while (this.endless && this.trace.t[1] < this.now.t - this.seconds)
        for (const list of Object.values(this.trace)) list.shift();
    }
    // A trace up to what the picture shows: the newest state is still to come while it is on the way there.
    past(name, part) {
      const list = this.trace[name];
      return part < 1 && this.trace.t.at(-1) === this.now.t ? list.slice(0, -1) : list;
    }
    // A value between the last two states, `part` of the way to the newer; of a list, each of its values.
    blend(name, part) {
      const between = (from, to) => from + part * (to - from);
      const before = this.before[name],
        now = this.now[name];
      return typeof now === 'number' ? between(before, now) : now.map((value, i) => between(before[i], value));
    }
  };
})();
