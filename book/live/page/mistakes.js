// A mistake in the place of a figure's method: chips under the code make it, and the run without it stays in sight, faintly.
(function () {
  'use strict';
  const Live = (globalThis.Live ??= {});
  const NONE = 'none';

  Live.Mistakes = class {
    // `figure` has a stage, settings and a method; `open` makes a run in a module of its own.
    constructor(figure, open) {
      Object.assign(this, { figure, open });
      this.chips = figure.stage.querySelector('.chips');
      this.words = figure.stage.querySelector('.examined');
    }
    get made() {
      const { own } = this.figure.values;
      return own === NONE ? null : own;
    }
    // A mistake in a method that is no longer chosen is taken back, and those of others are not offered.
    fit() {
      const { settings, method } = this.figure;
      if (this.made && !this.made.startsWith(`${method}/`)) settings.values = { own: NONE };
      const labels = [...this.chips.querySelectorAll('[data-of]')];
      for (const label of labels) label.hidden = label.dataset.of !== method;
      this.chips.hidden = labels.every(label => label.hidden);
    }
    // The run without the mistake, in step with the one that has it; nothing until its module is there.
    async prepare() {
      const [run, whole] = await (this.opening ??= Promise.all([this.open(), this.open()]));
      Object.assign(this, { run, ahead: new Live.Ahead(whole) });
    }
    get right() {
      return { ...this.figure.values, own: NONE };
    }
    inStep(run) {
      const asked = JSON.stringify(this.right);
      if (asked !== this.asked || run.taken < this.run.taken) {
        this.run.start(this.right);
        this.asked = asked;
      }
      if (run.taken === this.run.taken + 1) this.run.step();
      else if (run.taken > this.run.taken) this.run.goTo(this.right, run.now.t);
      return this.run;
    }
    // As a chart has what was before a change.
    get before() {
      return { trace: this.ahead.of(this.right).trace, words: 'without the mistake' };
    }
    // What trying it has shown.
    tell() {
      this.words.textContent = this.made ? sentence(this.figure.run.module.examine()) : '';
    }
  };

  const isWhole = order => Math.abs(order - Math.round(order)) < 0.1;
  const digits = order => (isWhole(order) ? Math.round(order) : order.toFixed(1));
  const power = value => Math.ceil(Math.log10(value));

  function sentence({ order, rightOrder, is, apart }) {
    const measured =
      order > 0.5
        ? digits(order) === digits(rightOrder)
          ? `Order ${digits(order)}, as without the mistake.`
          : `Order ${digits(order)} in place of ${digits(rightOrder)}.`
        : 'With shorter steps it comes no nearer to the truth: it has no order.';
    const named = is && ` Its steps are those of ${is}, ${apart > 0 ? `to 1e${power(apart)}` : 'to the last bit'}.`;
    return measured + named;
  }
})();
