// A chart that a figure draws itself, and in which the reader can take hold of one of its settings.
(function () {
  'use strict';
  const Live = (globalThis.Live ??= {});

  Live.Plot = class {
    // `drawing` has chart(pen, run, settings), and held(x), which says where a setting stands when the pointer is at x.
    constructor(box, drawing, shape, moved) {
      const canvas = box.appendChild(document.createElement('canvas'));
      canvas.className = 'plot';
      canvas.style.aspectRatio = shape.join('/');
      Object.assign(this, { canvas, drawing, pen: new Live.Pen(canvas) });
      Live.drag(canvas, x => moved(drawing.held(this.pen.fromX(x))));
    }
    resize() {} // as the style sheet says
    draw(run, settings) {
      this.pen.begin(this.drawing.chartView);
      this.drawing.chart(this.pen, run, settings);
    }
  };
})();
