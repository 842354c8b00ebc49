// The chart as a time line: the reader goes to a moment by mouse, by finger or by the arrow keys.
(function () {
  'use strict';
  const Live = (globalThis.Live ??= {});
  const SLACK = 8; // pixels that a finger moves before it means it
  const KEYS = { ArrowLeft: -0.01, ArrowRight: 0.01, PageDown: -0.1, PageUp: 0.1, Home: -Infinity, End: Infinity };

  // Calls `press` with where a pointer comes down, from the left and from the top, and `hold` with where it is from then on, and with
  // whether it only clicked; a finger that goes up or down scrolls the page, and holds nothing.
  Live.drag = function (element, hold, press = () => {}) {
    let from = null;
    const tell = (of, { clientX, clientY }, clicked = false) => {
      const { left, top } = element.getBoundingClientRect();
      of(clientX - left, clientY - top, clicked);
    };
    element.addEventListener('pointerdown', event => {
      from = event.clientX;
      element.setPointerCapture(event.pointerId);
      tell(press, event);
    });
    element.addEventListener('pointermove', event => {
      if (!element.hasPointerCapture(event.pointerId)) return;
      if (Math.abs(event.clientX - from) < SLACK && event.pointerType === 'touch') return;
      from = Infinity;
      tell(hold, event);
    });
    element.addEventListener('click', event => tell(hold, event, from !== Infinity));
  };

  Live.Scrubber = class {
    // `moved` is called with the time that the reader goes to, which may lie outside the run.
    constructor(chart, moved) {
      const { box, plot } = chart;
      Object.assign(this, { chart, plot });
      this.element = box.parentElement.appendChild(document.createElement('span'));
      this.element.className = 'moment';
      const attributes = {
        'role': 'slider',
        'tabindex': 0,
        'aria-label': 'Time',
        'aria-valuemin': 0,
      };
      for (const [name, value] of Object.entries(attributes)) this.element.setAttribute(name, value);
      plot.over.classList.add('scrubbed');
      Live.drag(plot.over, x => moved(plot.posToVal(x, 'x')));
      this.element.addEventListener('keydown', event => {
        if (!(event.key in KEYS) || event.ctrlKey || event.metaKey || event.altKey) return;
        event.preventDefault();
        moved(this.t + KEYS[event.key] * chart.seconds);
      });
    }
    // Where the run stands, and what that is called.
    place(t, words) {
      const { plot, element } = this;
      this.t = t;
      element.setAttribute('aria-valuemax', this.chart.seconds);
      element.setAttribute('aria-valuenow', t);
      element.setAttribute('aria-valuetext', words);
      const frame = plot.root.parentElement;
      element.style.left = `${frame.offsetLeft + plot.over.offsetLeft + plot.valToPos(t, 'x')}px`;
      element.style.top = `${frame.offsetTop + plot.over.offsetTop}px`;
      element.style.height = `${plot.over.offsetHeight}px`;
    }
  };
})();
