// A chart that a figure draws itself, and in which the reader can take hold of one of its settings.
(function () {
  'use strict';
  const Live = (globalThis.Live ??= {});
  const SLACK = 8; // pixels that a finger moves before it means it

  Live.Plot = class {
    // `drawing` has chart(pen, run, settings), and held(x), which says where a setting stands when the pointer is at x.
    constructor(box, drawing, shape, moved) {
      const canvas = box.appendChild(document.createElement('canvas'));
      canvas.className = 'plot';
      canvas.style.aspectRatio = shape.join('/');
      Object.assign(this, { canvas, drawing, pen: new Live.Pen(canvas) });
      const hold = event => moved(drawing.held(this.pen.fromX(event.clientX - canvas.getBoundingClientRect().left)));
      // A finger that goes up or down scrolls the page, and holds nothing.
      let from = null;
      canvas.addEventListener('pointerdown', event => {
        from = event.clientX;
        canvas.setPointerCapture(event.pointerId);
      });
      canvas.addEventListener('pointermove', event => {
        if (!canvas.hasPointerCapture(event.pointerId)) return;
        if (Math.abs(event.clientX - from) < SLACK && event.pointerType === 'touch') return;
        from = Infinity;
        hold(event);
      });
      canvas.addEventListener('click', hold);
    }
    resize() {} // as the style sheet says
    draw(run, settings) {
      this.pen.begin(this.drawing.chartView);
      this.drawing.chart(this.pen, run, settings);
    }
  };
})();
