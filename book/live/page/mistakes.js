// A mistake in the place of a figure's method: chips under the code make it, and the run without it stays in sight, faintly.
(function () {
  'use strict';
  const Live = (globalThis.Live ??= {});
  const NONE = 'none',
    YOURS = 'yours/';
  const methodOf = own => (own.startsWith(YOURS) ? own.slice(YOURS.length) : own.split('/')[0]);

  Live.Mistakes = class {
    // `figure` has a stage, settings and a method; `open` makes a run in a module of its own.
    constructor(figure, open) {
      Object.assign(this, { figure, open });
      this.chips = figure.stage.querySelector('.chips');
      this.words = figure.stage.querySelector('.examined');
      this.canEdit = 'compiler' in document.documentElement.dataset;
      if (this.canEdit) this.offerToEdit();
    }
    get made() {
      const { own } = this.figure.values;
      return own === NONE ? null : own;
    }
    // The method in whose place it stands.
    get standsFor() {
      return this.made && methodOf(this.made);
    }
    offerToEdit() {
      const button = document.createElement('button');
      Object.assign(button, { type: 'button', className: 'edit', textContent: 'Edit' });
      button.addEventListener('click', async () => {
        this.notice = '';
        (await globalThis.loadEditing()).figure(this.figure);
      });
      this.chips.append(button);
      if (this.figure.links.brought)
        this.notice = 'This link brings a step of its own, which runs once you press Edit.';
    }
    // Whether the lines of the method may be written anew.
    get isEditable() {
      const { stage, method } = this.figure;
      return this.canEdit && stage.querySelector(`[data-method="${method}"][data-edit]`) !== null;
    }
    // Whether it is the reader's own step that is made.
    get isYours() {
      return this.made?.startsWith(YOURS);
    }
    // A mistake in a method that is no longer chosen is taken back, and those of others are not offered.
    fit() {
      const { settings, method } = this.figure;
      if (this.made && this.standsFor !== method) settings.values = { own: NONE };
      const labels = [...this.chips.querySelectorAll('[data-of]')];
      for (const label of labels) label.hidden = label.dataset.of !== method;
      if (this.canEdit) this.chips.querySelector('.edit').hidden = !this.isEditable;
      this.chips.hidden = !this.isEditable && labels.every(label => label.hidden);
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
      return { trace: this.ahead.of(this.right).trace, words: this.isYours ? 'the book’s' : 'without the change' };
    }
    // Why a mistake does what it does.
    get why() {
      return this.figure.description.controls.find(({ chips }) => chips).why[this.made];
    }
    // What trying it has shown, once for each method: no other setting counts.
    tell() {
      const { made, figure } = this;
      if (!made) return void (this.words.textContent = this.notice ?? '');
      if (made !== this.tried || figure.reader !== this.triedBy) {
        const found = figure.run.module.examine();
        this.found = figure.readerFault ?? [sentence(found, this.isYours), this.why].filter(Boolean).join(' ');
        Object.assign(this, { tried: made, triedBy: figure.reader });
      }
      this.words.textContent = this.found;
    }
  };

  // Whether something stands in the place of a method, by the settings; and what is called by its name then, in a list and in a sentence.
  Live.standsFor = (method, { own = NONE }) => own !== NONE && methodOf(own) === method;
  const named = changed => (method, label, values) => {
    if (!Live.standsFor(method, values)) return label;
    return values.own.startsWith(YOURS) ? 'Yours' : changed(label);
  };
  Live.nameInList = named(() => 'Changed');
  Live.nameInSentence = named(label => `${label} as changed`);

  const isWhole = order => Math.abs(order - Math.round(order)) < 0.1;
  const digits = order => (isWhole(order) ? Math.round(order) : order.toFixed(1));
  const power = value => Math.ceil(Math.log10(value));

  // Of an order that is right: whether the errors are, too.
  const asFarOff = ({ is, off }) =>
    is || !(Math.abs(off - 1) > 0.05) ? '' : `, and in the same short steps ${Live.digits(off, 2)} times as far off`;

  // Why there is none.
  function cause({ drifts, kicks }) {
    const isWrong = share => Number.isFinite(share) && Math.abs(share - 1) > 1e-3;
    const times = share => `${Live.digits(share, 2)} times what it should`;
    if (isWrong(drifts)) return ` Where nothing pushes, a step of 0.1\u202fs moves the place by ${times(drifts)}.`;
    if (isWrong(kicks)) return ` Under a constant push, a step of 0.1\u202fs changes the velocity by ${times(kicks)}.`;
    return '';
  }

  function sentence(found, isYours) {
    const { order, rightOrder, is, apart } = found;
    const measured =
      order > 0.5
        ? digits(order) === digits(rightOrder)
          ? `Order ${digits(order)}, as ${isYours ? `the book’s${asFarOff(found)}` : 'without the change'}.`
          : `Order ${digits(order)} in place of ${digits(rightOrder)}.`
        : `With shorter steps it comes no nearer to the truth: it has no order.${isYours ? cause(found) : ''}`;
    const named = is && ` Its steps are those of ${is}, ${apart > 0 ? `to 1e${power(apart)}` : 'to the last bit'}.`;
    return measured + named;
  }
})();
