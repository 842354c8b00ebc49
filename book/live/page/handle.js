// Something in the picture that the reader takes hold of: by pointer, by touch, or by the arrow keys.
(function () {
  'use strict';
  const Live = (globalThis.Live ??= {});
  const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowDown: [0, -1], ArrowUp: [0, 1] };
  const within = ({ from, to }, value) => Math.max(from, Math.min(to, value));

  Live.Handle = class {
    // `moved` is called when it has been moved. An axis has what it sets; `at` is where nothing stands in the picture,
    // and `per` how far one of its unit is. It stays where it is along an axis that sets nothing.
    constructor(canvas, description, moved) {
      const axis = of => ({ at: 0, per: 1, from: 0, to: 0, start: 0, ...of });
      Object.assign(this, { canvas, description, moved, across: axis(description.x), up: axis(description.y) });
      this.element = canvas.parentElement.appendChild(document.createElement('span'));
      this.element.className = 'handle';
      const { from, to } = this.across.set ? this.across : this.up;
      const attributes = {
        'role': 'slider',
        'tabindex': 0,
        'aria-label': `${description.name}, moved by ${this.across.set ? 'all four arrow keys' : 'the arrow keys up and down'}`,
        'aria-valuemin': from,
        'aria-valuemax': to,
      };
      for (const [name, value] of Object.entries(attributes)) this.element.setAttribute(name, value);
      this.reset();
      this.listen();
    }
    reset() {
      this.hold(this.across.start, this.up.start);
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
        const { across, up, metre } = this;
        this.move(
          at[0] + (event.clientX - x) / (metre.across * across.per),
          at[1] - (event.clientY - y) / (metre.up * up.per),
        );
      });
      element.addEventListener('lostpointercapture', () => this.letGo());
      element.addEventListener('keydown', event => {
        const arrow = ARROWS[event.key];
        if (!arrow || event.ctrlKey || event.metaKey || event.altKey) return;
        event.preventDefault();
        this.move(this.x + arrow[0] * this.description.by, this.y + arrow[1] * this.description.by);
        this.letGo();
      });
    }
    // As a control says it.
    letGo() {
      this.element.dispatchEvent(new Event('change', { bubbles: true }));
    }
    move(x, y) {
      this.hold(x, y);
      this.moved();
    }
    hold(x, y) {
      const { across, up, element } = this;
      const { unit } = this.description;
      this.x = within(across, x);
      this.y = within(up, y);
      const right = across.set ? `${Live.fixed(this.x, 2)}\u202f${unit} to the right, ` : '';
      element.setAttribute('aria-valuenow', (across.set ? this.x : this.y).toFixed(2));
      element.setAttribute('aria-valuetext', `${right}${Live.fixed(this.y, 2)}\u202f${unit} up`);
    }
    get values() {
      const { across, up, x, y } = this;
      return { ...(across.set && { [across.set]: x }), [up.set]: y };
    }
    set values(wanted) {
      this.hold(wanted[this.across.set] ?? this.x, wanted[this.up.set] ?? this.y);
    }
    // Those of its values that a link has.
    read(text) {
      const given = new URLSearchParams(text);
      const known = Object.keys(this.values).filter(
        name => given.has(name) && Number.isFinite(Number(given.get(name))),
      );
      return Object.fromEntries(known.map(name => [name, Number(given.get(name))]));
    }

    // Puts it where it belongs in the picture that the pen draws.
    place(pen) {
      const { x, y, across, up, element, canvas } = this;
      this.metre = { across: pen.metre, up: pen.metreUp };
      element.style.left = `${canvas.offsetLeft + pen.x(across.at + x * across.per)}px`;
      element.style.top = `${canvas.offsetTop + pen.y(up.at + y * up.per)}px`;
    }
  };
})();
