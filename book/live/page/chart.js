// One value over time. The axes are fixed, so that a small thing looks small; where the curve leaves them is marked.
(function () {
  'use strict';
  const Live = globalThis.Live ??= {};

  Live.Chart = class {
    // `beside` is the picture of the scene, whose height the chart takes within bounds.
    constructor(box, beside, { value, from, to, level }, seconds) {
      Object.assign(this, { box, beside, value, from, to, level });
      const colour = name => Live.colour(box, name);
      const axis = { stroke: () => colour('soft'), grid: { stroke: () => colour('grid'), width: 1 }, ticks: { show: false }, font: '12px "Book Sans", sans-serif' };
      const series = [{}, { stroke: () => colour(this.method), width: 2, points: { show: false } }];
      if (level !== undefined) series.push({ stroke: () => colour('exact'), width: 1.2, dash: [7, 5], points: { show: false } });
      this.plot = new globalThis.uPlot({
        ...this.size, legend: { show: false }, cursor: { show: false }, padding: [8, 12, 0, 0],
        scales: { x: { time: false, range: [0, seconds] }, y: { range: [from, to] } },
        axes: [{ ...axis, size: 24, label: 'time [s]', labelSize: 20, labelFont: axis.font }, { ...axis, size: 40 }],
        series, hooks: { draw: [plot => this.markExit(plot)] },
      }, [[], [], []].slice(0, series.length), box);
    }
    get size() {
      const height = Math.max(200, Math.min(280, this.beside.clientHeight));
      return { width: Math.max(120, this.box.clientWidth), height };
    }
    resize() {
      const { width, height } = this.size;
      if (width !== this.plot.width || height !== this.plot.height) this.plot.setSize({ width, height });
    }

    draw({ trace, now }, method) {
      this.method = method;
      const far = 100 * (this.to - this.from);  // beyond, a canvas draws nonsense
      const times = trace.t.at(-1) === now.t ? trace.t : [...trace.t, now.t];
      const values = times === trace.t ? trace[this.value] : [...trace[this.value], now[this.value]];
      const left = values.findIndex(value => !(value >= this.from && value <= this.to));
      this.exit = left < 0 ? null : { t: times[left], up: !(values[left] < this.from) };
      const drawn = values.map(value => (Number.isNaN(value) ? null : Math.max(-far, Math.min(far, value))));
      this.plot.setData(this.level === undefined ? [times, drawn] : [times, drawn, times.map(() => this.level)], false);
      this.plot.redraw(false, true);
    }

    markExit(plot) {
      if (!this.exit) return;
      const { ctx, bbox } = plot, size = 6 * devicePixelRatio;
      const x = plot.valToPos(this.exit.t, 'x', true), up = this.exit.up ? 1 : -1;
      const tip = this.exit.up ? bbox.top : bbox.top + bbox.height;
      const before = x > bbox.left + bbox.width / 2;
      ctx.save();
      ctx.fillStyle = Live.colour(this.box, 'limit');
      ctx.beginPath();
      ctx.moveTo(x, tip);
      ctx.lineTo(x - size, tip + up * 1.6 * size);
      ctx.lineTo(x + size, tip + up * 1.6 * size);
      ctx.fill();
      ctx.font = `500 ${12 * devicePixelRatio}px "Book Sans", sans-serif`;
      ctx.textAlign = before ? 'right' : 'left';
      ctx.textBaseline = 'middle';
      ctx.fillText('leaves the chart', x + (before ? -2 : 2) * size, tip + up * 1.2 * size);
      ctx.restore();
    }
  };
})();
