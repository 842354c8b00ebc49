// Draws on a canvas in the units of the scene and in the colours of the book.
(function () {
  'use strict';
  const Live = (globalThis.Live ??= {});

  Live.colour = function (element, name) {
    const colour = getComputedStyle(element)
      .getPropertyValue(`--${name.replace(/_/g, '-')}`)
      .trim();
    if (!colour) throw new Error(`book/theme/figure.gp has no line style for ${name}`);
    return colour;
  };

  Live.Pen = class {
    constructor(canvas) {
      this.canvas = canvas;
      this.context = canvas.getContext('2d');
    }
    // Wipes the canvas. `view` is { x: [from, to], y: [from, to] }; a metre is as long upwards as sideways, unless `free`.
    begin({ x, y, free }) {
      const { canvas, context } = this,
        ratio = devicePixelRatio || 1;
      const width = canvas.clientWidth,
        height = canvas.clientHeight;
      canvas.width = Math.round(width * ratio);
      canvas.height = Math.round(height * ratio);
      context.setTransform(ratio, 0, 0, ratio, 0, 0);
      let across = width / (x[1] - x[0]),
        up = height / (y[1] - y[0]);
      if (!free) across = up = Math.min(across, up);
      this.x = value => width / 2 + (value - (x[0] + x[1]) / 2) * across;
      this.y = value => height / 2 - (value - (y[0] + y[1]) / 2) * up;
      this.fromX = pixels => (pixels - width / 2) / across + (x[0] + x[1]) / 2;
      this.fromY = pixels => (height / 2 - pixels) / up + (y[0] + y[1]) / 2;
      this.metre = across;
      this.metreUp = up;
      this.view = { x, y };
      this.faint = 1;
      context.lineJoin = context.lineCap = 'round';
    }
    colour(name) {
      return Live.colour(this.canvas, name);
    }
    // Draws what is not there, or not yet, with so much of its strength, and without words.
    faintly(faint, draw) {
      this.faint = faint;
      draw();
      this.faint = 1;
    }
    stroke({ colour = 'ink', width = 1.5, dash = [], faint = 1 }) {
      const { context } = this;
      Object.assign(context, { strokeStyle: this.colour(colour), lineWidth: width, globalAlpha: faint * this.faint });
      context.setLineDash(dash);
      context.stroke();
      context.setLineDash([]);
      context.globalAlpha = 1;
    }
    // From one place to another, with a head.
    arrow(fromX, fromY, x, y, look = {}) {
      this.line([fromX, x], [fromY, y], look);
      const [right, down] = [this.x(x) - this.x(fromX), this.y(y) - this.y(fromY)];
      const back = 9 / (Math.hypot(right, down) || 1);
      const { context } = this;
      context.beginPath();
      for (const aside of [-0.5, 0.5]) {
        context.moveTo(this.x(x), this.y(y));
        context.lineTo(this.x(x) - back * (right + aside * down), this.y(y) - back * (down - aside * right));
      }
      this.stroke(look);
    }
    // A line through points, given as two lists.
    line(xs, ys, look = {}) {
      const { context } = this,
        far = 1e5; // pixels; beyond, a canvas draws nonsense
      context.beginPath();
      for (let i = 0; i < xs.length; ++i) {
        const x = this.x(xs[i]),
          y = this.y(ys[i]);
        if (!(Math.abs(x) < far && Math.abs(y) < far)) break;
        context.lineTo(x, y);
      }
      this.stroke(look);
    }
    circle(x, y, radius, look = {}) {
      this.ellipse(x, y, radius, radius, look);
    }
    ellipse(x, y, across, up, look = {}) {
      this.context.beginPath();
      this.context.ellipse(this.x(x), this.y(y), across * this.metre, up * this.metre, 0, 0, 2 * Math.PI);
      this.stroke(look);
    }
    // Draws within a field and nothing beyond it, and then its frame.
    within(xs, ys, frame, draw) {
      const { context } = this,
        [left, right] = xs.map(this.x),
        [bottom, top] = ys.map(this.y);
      const box = () => {
        context.beginPath();
        context.rect(left, top, right - left, bottom - top);
      };
      context.save();
      box();
      context.clip();
      draw();
      context.restore();
      box();
      this.stroke(frame);
    }
    // A dot of some pixels.
    dot(x, y, pixels, colour = 'ink') {
      const { context } = this;
      Object.assign(context, { fillStyle: this.colour(colour), globalAlpha: this.faint });
      context.beginPath();
      context.arc(this.x(x), this.y(y), pixels, 0, 2 * Math.PI);
      context.fill();
      context.globalAlpha = 1;
    }
    // A thing as a dot; of one that has left the picture an arrow at the edge says where it is.
    body(x, y, pixels, colour) {
      const { context, canvas } = this;
      const [right, down] = [this.x(x) - canvas.clientWidth / 2, this.y(y) - canvas.clientHeight / 2];
      const [across, high] = [canvas.clientWidth / 2, canvas.clientHeight / 2];
      if (!(Math.abs(right) > across || Math.abs(down) > high)) {
        this.dot(x, y, pixels, colour);
        return;
      }
      const part = Math.min((across - 4) / Math.abs(right), (high - 4) / Math.abs(down));
      context.save();
      context.translate(across + part * right, high + part * down);
      context.rotate(Math.atan2(down, right));
      Object.assign(context, { fillStyle: this.colour(colour), globalAlpha: this.faint });
      context.beginPath();
      for (const [along, aside] of [
        [0, 0],
        [-14, 7],
        [-14, -7],
      ])
        context.lineTo(along, aside);
      context.fill();
      context.restore();
    }
    // Many dots at once, which takes far less time than one after the other.
    dots(xs, ys, pixels, colour = 'ink') {
      const { context } = this;
      Object.assign(context, { fillStyle: this.colour(colour), globalAlpha: this.faint });
      context.beginPath();
      for (let i = 0; i < xs.length; ++i) {
        const [x, y] = [this.x(xs[i]), this.y(ys[i])];
        context.moveTo(x + pixels, y);
        context.arc(x, y, pixels, 0, 2 * Math.PI);
      }
      context.fill();
      context.globalAlpha = 1;
    }
    // What lies within a line that closes on itself.
    area(xs, ys, { colour = 'area', faint = 1 } = {}) {
      const { context } = this;
      context.beginPath();
      for (let i = 0; i < xs.length; ++i) context.lineTo(this.x(xs[i]), this.y(ys[i]));
      Object.assign(context, { fillStyle: this.colour(colour), globalAlpha: faint * this.faint });
      context.fill();
      context.globalAlpha = 1;
    }
    // A rectangle, filled, and its outline.
    box([left, right], [low, high], look) {
      this.area([left, right, right, left], [low, low, high, high], look);
    }
    frame([left, right], [low, high], look) {
      this.line([left, right, right, left, left], [low, low, high, high, low], look);
    }
    text(x, y, words, { colour = 'soft', align = 'center', size = 13 } = {}) {
      const { context } = this;
      if (this.faint < 1) return; // what is faint has no words
      Object.assign(context, {
        font: `500 ${size}px "Book Sans", sans-serif`,
        textAlign: align,
        textBaseline: 'middle',
        fillStyle: this.colour(colour),
      });
      context.fillText(words, this.x(x), this.y(y));
    }
    // Faint lines with their numbers at the left and the lower edge, or with what stands for the numbers.
    grid(xs, ys, { x: nameX, y: nameY } = { x: x => Live.digits(x, 6), y: y => Live.digits(y, 6) }) {
      const { context, canvas } = this;
      if (this.faint < 1) return;
      context.beginPath();
      for (const x of xs) {
        context.moveTo(this.x(x), 0);
        context.lineTo(this.x(x), canvas.clientHeight);
      }
      for (const y of ys) {
        context.moveTo(0, this.y(y));
        context.lineTo(canvas.clientWidth, this.y(y));
      }
      this.stroke({ colour: 'grid', width: 1 });
      Object.assign(context, {
        font: '400 12px "Book Sans", sans-serif',
        fillStyle: this.colour('soft'),
        textBaseline: 'bottom',
        textAlign: 'left',
      });
      for (const x of xs) context.fillText(nameX(x), this.x(x) + 3, canvas.clientHeight - 2);
      for (const y of ys) context.fillText(nameY(y), 3, this.y(y) - 2);
    }
  };
})();
