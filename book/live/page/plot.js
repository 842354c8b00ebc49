// A chart that a figure draws itself, and in which the reader can take hold of one of its settings.
(function () {
  'use strict';
  const Live = (globalThis.Live ??= {});

  Live.Plot = class {
    // `drawing` has chart(pen, run, settings), and held(x, y, clicked), which says where a setting stands when the pointer is there;
    // and grip(x, y, pen), if it is to know where a pointer came down; `upright` while what it took moves up and down, so that a
    // finger does not scroll the page.
    constructor(box, drawing, shape, moved) {
      const canvas = box.appendChild(document.createElement('canvas'));
      canvas.className = 'plot';
      canvas.style.aspectRatio = shape.join('/');
      Object.assign(this, { canvas, drawing, pen: new Live.Pen(canvas) });
      const at = (x, y) => [this.pen.fromX(x), this.pen.fromY(y)];
      Live.drag(
        canvas,
        (x, y, clicked) => moved(drawing.held(...at(x, y), clicked)),
        (x, y) => drawing.grip?.(...at(x, y), this.pen),
      );
      canvas.addEventListener('touchstart', event => drawing.upright && event.preventDefault(), { passive: false });
    }
    resize() {} // as the style sheet says
    draw(run, settings) {
      this.pen.begin(this.drawing.chartView);
      this.drawing.chart(this.pen, run, settings);
    }
  };
})();
