// What the reader sets: sliders and choices, and the link that holds them.
(function () {
  'use strict';
  const Live = (globalThis.Live ??= {});

  // A slider stands at numbers of its own: places in a list of values, or the value in the unit that is shown.
  class Slider {
    constructor(label, control) {
      Object.assign(this, control);
      this.scale ??= 1;
      this.input = label.querySelector('input');
      this.output = label.querySelector('.value');
      this.dot = label.querySelector('.mark');
    }
    get shown() {
      return this.values ? this.values[this.input.valueAsNumber] : this.input.valueAsNumber;
    }
    get value() {
      return this.shown * this.scale;
    }
    set value(wanted) {
      const shown = wanted / this.scale;
      const nearest = (best, value, i) => (Math.abs(value - shown) < Math.abs(this.values[best] - shown) ? i : best);
      this.input.value = this.values ? this.values.reduce(nearest, 0) : shown;
    }
    words(shown = this.shown) {
      return `${Live.digits(shown, 4)}${this.unit ? `\u202f${this.unit}` : ''}`;
    }

    wordsOf(value) {
      return this.words(value / this.scale);
    }

    // `now`, where there is a run already, holds the value to be marked on the slider, where it has one.
    tell(now) {
      const text = this.words() + this.markWords(now);
      this.output.textContent = text;
      this.input.setAttribute('aria-valuetext', text);
    }
    markWords(now) {
      if (!this.mark || !now) return '';
      const at = now[this.mark] / this.scale;
      const place = (at - this.from) / (this.to - this.from);
      this.dot.hidden = !(place >= 0 && place <= 1);
      this.dot.style.setProperty('--place', place);
      if (place < 0) return `, over every ${this.mark}`;
      return `, ${this.shown > at ? 'over' : 'under'} the ${this.mark} of ${this.words(Number(at.toPrecision(3)))}`;
    }
  }

  class Choice {
    constructor(fieldset, control) {
      Object.assign(this, control);
      this.radios = [...fieldset.querySelectorAll('input')];
    }
    get value() {
      return this.radios.find(radio => radio.checked).value;
    }
    set value(wanted) {
      const radio = this.radios.find(({ value }) => value === wanted);
      if (radio) radio.checked = true;
    }
    // The choice behind the one that is made, and behind the last the first.
    get next() {
      const all = Object.keys(this.choices);
      return all[(all.indexOf(this.value) + 1) % all.length];
    }
    words() {
      return this.wordsOf(this.value);
    }
    wordsOf(value) {
      return this.choices[value];
    }
    tell() {}
  }

  // "for": { "thing": "orbit" } is a control of orbits alone; { "late": ["a", "all"] } of two choices.
  const isFor = (control, values) =>
    Object.entries(control.for ?? {}).every(([name, choice]) => [choice].flat().includes(values[name]));

  Live.Settings = class {
    constructor(stage, controls) {
      this.controls = controls.map(control => {
        const element = stage.querySelector(`[data-control="${control.name}"]`);
        const made = control.choices ? new Choice(element, control) : new Slider(element, control);
        return Object.assign(made, { element });
      });
    }
    of(wanted) {
      return this.controls.find(({ name }) => name === wanted);
    }
    get values() {
      return Object.fromEntries(this.controls.map(({ name, value }) => [name, value]));
    }
    set values(wanted) {
      for (const control of this.controls) if (control.name in wanted) control.value = wanted[control.name];
    }
    get words() {
      return this.controls
        .filter(({ element }) => !element.hidden)
        .map(control => `${control.label}: ${control.words()}`)
        .join(', ');
    }
    // What other values were called, of the controls that have been moved since.
    wordsSince(values) {
      return this.controls
        .filter(({ name, value, element }) => !element.hidden && value !== values[name])
        .map(control => control.wordsOf(values[control.name]))
        .join(', ');
    }
    // One that is for another choice than the one made is not seen; which mistakes are, Live.Mistakes says.
    tell(now) {
      const { values } = this;
      for (const control of this.controls) {
        if (!control.chips) control.element.hidden = !isFor(control, values);
        control.tell(now);
      }
    }

    // method=euler&h=0.011, in seconds and the like; what it does not know it leaves as it is.
    get query() {
      return this.controls
        .map(({ name, value }) => `${name}=${typeof value === 'number' ? Number(value.toPrecision(6)) : value}`)
        .join('&');
    }
    set query(text) {
      this.values = this.read(text);
    }
    read(text) {
      const given = new URLSearchParams(text);
      const known = this.controls
        .filter(({ name }) => given.has(name))
        .map(({ name, choices }) => [name, choices ? given.get(name) : Number(given.get(name))]);
      return Object.fromEntries(known.filter(([, value]) => typeof value === 'string' || Number.isFinite(value)));
    }
  };
})();
