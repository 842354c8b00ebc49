// Something in the picture that the reader takes hold of: by pointer, by touch, or by the arrow keys.
(function () {
  'use strict';
  const Live = (globalThis.Live ??= {});
  const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowDown: [0, -1], ArrowUp: [0, 1] };
  const within = ({ from, to }, value) => Math.max(from, Math.min(to, value));

  Live.Handle = class {
    // `moved` is called with the names of two settings and their values.
    constructor(canvas, description, moved) {
      Object.assign(this, { canvas, description, moved });
      this.element = canvas.parentElement.appendChild(document.createElement('span'));
      this.element.className = 'handle';
      const attributes = {
        'role': 'slider',
        'tabindex': 0,
        'aria-label': `${description.name}, moved by all four arrow keys`,
        'aria-valuemin': description.x.from,
        'aria-valuemax': description.x.to,
      };
      for (const [name, value] of Object.entries(attributes)) this.element.setAttribute(name, value);
      this.reset();
      this.listen();
    }
    reset() {
      this.hold(this.description.x.start, this.description.y.start);
    }

    listen() {
      const { element } = this;
      element.addEventListener('pointerdown', event => {
        element.setPointerCapture(event.pointerId);
        this.from = { x: event.clientX, y: event.clientY, at: [this.x, this.y] };
      });
      element.addEventListener('pointermove', event => {
        if (!element.hasPointerCapture(event.pointerId)) return;
        const { x, y, at } = this.from;
        this.move(at[0] + (event.clientX - x) / this.metre, at[1] - (event.clientY - y) / this.metre);
      });
      element.addEventListener('keydown', event => {
        const arrow = ARROWS[event.key];
        if (!arrow || event.ctrlKey || event.metaKey || event.altKey) return;
        event.preventDefault();
        this.move(this.x + arrow[0] * this.description.by, this.y + arrow[1] * this.description.by);
      });
    }
    move(x, y) {
      this.hold(x, y);
      this.moved(this.values);
    }
    hold(x, y) {
      this.x = within(this.description.x, x);
      this.y = within(this.description.y, y);
      this.element.setAttribute('aria-valuenow', this.x.toFixed(2));
      this.element.setAttribute(
        'aria-valuetext',
        `${Live.fixed(this.x, 2)}\u202f${this.description.unit} to the right, ${Live.fixed(this.y, 2)}\u202f${this.description.unit} up`,
      );
    }
    get values() {
      return { [this.description.x.set]: this.x, [this.description.y.set]: this.y };
    }

    // Puts it where it belongs in the picture that the pen draws.
    place(pen) {
      this.metre = pen.metre;
      this.element.style.left = `${this.canvas.offsetLeft + pen.x(this.x)}px`;
      this.element.style.top = `${this.canvas.offsetTop + pen.y(this.y)}px`;
    }
  };
})();
