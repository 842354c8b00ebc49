// Values over time. The axes are fixed, so that a small thing looks small; where a curve leaves them is marked.
(function () {
  'use strict';
  const Live = (globalThis.Live ??= {});
  const FONT = '12px "Book Sans", sans-serif';

  Live.Chart = class {
    // `methods` has what the methods are called.
    constructor(box, { curves, from, to, log, marks, time = 'time [s]', colours = {} }, methods, seconds) {
      const paths = curves.filter(curve => curve.path);
      curves = curves.filter(curve => !curve.path);
      Object.assign(this, { box, methods, curves, paths, colours, from, to, log, exits: [], seconds, until: seconds });
      const paint = name => () => Live.colour(box, name);
      const numbers = (_, marks) => marks.map(mark => (mark === null ? '' : Live.digits(mark, 6)));
      const axis = {
        values: numbers,
        stroke: paint('soft'),
        grid: { stroke: paint('grid'), width: 1 },
        ticks: { show: false },
        font: FONT,
      };
      // Of the marks of a logarithmic axis, the powers of ten.
      const powers = (_, marks) =>
        marks.map(mark => (Math.abs(Math.log10(mark) - Math.round(Math.log10(mark))) < 1e-9 ? mark : null));
      const logarithmic = log && { filter: powers, grid: { ...axis.grid, filter: powers } };
      // [[value, name]], where the numbers alone would be hard to read.
      const named = marks && {
        splits: () => marks.map(([value]) => value),
        values: () => marks.map(([, name]) => name),
        filter: (_, all) => all,
        grid: { ...axis.grid, filter: (_, all) => all },
      };
      this.plot = new globalThis.uPlot(
        {
          ...this.size,
          legend: { show: false },
          cursor: { show: false },
          padding: [8, 20, 0, 0],
          scales: {
            x: { time: false, range: () => [this.until - this.seconds, this.until] },
            y: { range: [from, to], distr: log ? 3 : 1 },
          },
          axes: [
            { ...axis, size: 24, label: time, labelSize: 20, labelFont: FONT },
            { ...axis, size: marks ? this.widest(marks) : 44, ...logarithmic, ...named },
          ],
          series: [{}, ...curves.map(curve => this.seriesOf(curve))],
          hooks: {
            drawClear: [plot => this.drawFaint(plot)],
            draw: [
              plot => this.drawPaths(plot),
              plot => this.exits.forEach((exit, i) => this.markExit(plot, exit, i === 0 && this.exitsInWords)),
              plot => Live.nameLines(plot, this.ends(plot), this.box),
            ],
          },
        },
        [[], ...curves.map(() => [])],
        box,
      );
    }
    // Room for the longest of some names, in pixels.
    widest(marks) {
      const { context } = new Live.Pen(document.createElement('canvas'));
      context.font = FONT;
      return Math.max(44, ...marks.map(([, name]) => context.measureText(name).width + 12));
    }
    seriesOf(curve) {
      const exact = curve.colour === 'exact';
      return {
        stroke: () => this.colourOf(curve),
        width: exact ? 1.2 : 2,
        dash: exact ? [7, 5] : undefined,
        points: { show: false },
      };
    }
    // A curve of the colour "method" has that of the method chosen, or the one that `colours` gives it.
    colourOf({ colour }) {
      return Live.colour(this.box, colour === 'method' ? (this.colours[this.method] ?? this.method) : colour);
    }

    nameOf({ label, colour }) {
      return label ?? (colour === 'method' ? (this.isYours ? 'Yours' : this.methods[this.method]) : undefined);
    }

    get size() {
      return { width: Math.max(120, this.box.clientWidth), height: Math.max(200, this.box.clientHeight) };
    }
    resize() {
      const { width, height } = this.size;
      if (width !== this.plot.width || height !== this.plot.height) this.plot.setSize({ width, height });
    }

    // `ahead` is the trace of the whole run, and `before` that of a run with other settings, { trace, words }; both are faint.
    draw({ trace, now, endless, seconds }, { method = 'first', own = '' }, ahead = trace, before) {
      const isOther = ({ value }) => this.differ(before.trace[value].at(-1), ahead[value].at(-1));
      this.changed = before && this.curves.find(isOther);
      Object.assign(this, { method, trace, ahead, before: this.changed && before });
      this.isYours = own.startsWith('yours/');
      this.lists = this.paths.map(({ path }) => now[path]);
      const whole = name => (trace.t.at(-1) === now.t ? trace[name] : [...trace[name], now[name]]);
      const times = whole('t');
      const seen = ahead === trace ? whole : name => ahead[name];
      this.exits = this.curves
        .filter(({ colour }) => colour !== 'exact')
        .map(curve => this.exitOf(curve, seen('t'), seen(curve.value)))
        .filter(Boolean);
      this.seconds = seconds;
      this.until = endless ? Math.max(seconds, now.t) : seconds;
      this.plot.setData([times, ...this.curves.map(({ value }) => whole(value).map(this.drawn))]);
    }
    // Whether two values are seen to be two.
    differ(one, other) {
      const [a, b] = [this.drawn(one), this.drawn(other)];
      if (a === null || b === null) return a !== b;
      return this.log ? Math.abs(Math.log(a / b)) > 0.02 : Math.abs(a - b) > 0.005 * (this.to - this.from);
    }
    // Beyond a hundred times the chart, a canvas draws nonsense.
    drawn = value => (Number.isNaN(value) ? null : Math.max(-100 * this.to, Math.min(100 * this.to, value)));

    // A curve that begins outside, as an error of nothing does on a logarithmic axis, has first to come in.
    exitOf(curve, times, values) {
      const within = value => value >= this.from && value <= this.to;
      const first = values.findIndex(within);
      const at = values.findIndex((value, i) => i > first && !Number.isNaN(value) && !within(value));
      if (first < 0 || at < 0) return null;
      const up = !(values[at] < this.from);
      if (this.log && !up) return null; // what is too small for a logarithmic axis has come to nothing
      return {
        t: this.crossing(times.slice(at - 1, at + 1), values.slice(at - 1, at + 1), up ? this.to : this.from),
        up,
        curve,
      };
    }
    // Of all that leave, in one sentence.
    get exitsInWords() {
      const names = [...new Set(this.exits.map(({ curve }) => this.nameOf(curve)).filter(Boolean))];
      const last = names.pop();
      if (!last) return 'leaves the chart';
      return names.length ? `${names.join(', ')} and ${last} leave the chart` : `${last} leaves the chart`;
    }
    // When the line between two points, as it is drawn, crosses an edge of the chart.
    crossing(times, values, edge) {
      const [a, b, e] = [...values, edge].map(value => (this.log ? Math.log(value) : value));
      const part = (e - a) / (b - a);
      return times.length === 2 && part >= 0 && part <= 1 ? times[0] + part * (times[1] - times[0]) : times.at(-1);
    }

    drawFaint(plot) {
      const { ahead, before } = this;
      if (before) this.drawTrace(plot, before.trace, { faint: 0.4, dash: [2, 3] });
      if (ahead !== this.trace) this.drawTrace(plot, ahead, { faint: 0.35, dash: [] });
    }
    drawTrace({ ctx, bbox, valToPos }, trace, { faint, dash }) {
      ctx.save();
      ctx.beginPath();
      ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
      ctx.clip();
      ctx.setLineDash(dash.map(length => length * devicePixelRatio));
      ctx.globalAlpha = faint;
      for (const curve of this.curves.filter(({ colour }) => colour !== 'exact')) {
        ctx.beginPath();
        trace[curve.value].forEach((value, i) => {
          const drawn = this.drawn(value);
          if (drawn !== null) ctx.lineTo(valToPos(trace.t[i], 'x', true), valToPos(drawn, 'y', true));
        });
        Object.assign(ctx, { strokeStyle: this.colourOf(curve), lineWidth: 1.5 * devicePixelRatio });
        ctx.stroke();
      }
      ctx.restore();
    }

    // Where the lines end that have a name and stay within the chart: { x, y, words, colour }, in pixels.
    ends({ valToPos }) {
      const at = (t, value, words, colour) =>
        words && value >= this.from && value <= this.to
          ? [{ x: valToPos(t, 'x', true), y: valToPos(value, 'y', true), words, colour }]
          : [];
      const { ahead, before } = this;
      if (!ahead) return [];
      const lasting = this.curves.flatMap(curve =>
        at(ahead.t.at(-1), ahead[curve.value].at(-1), this.nameOf(curve), this.colourOf(curve)),
      );
      const known = this.paths.flatMap((curve, i) =>
        at(this.seconds, this.lists[i]?.at(-1), this.nameOf(curve), this.colourOf(curve)),
      );
      const left = before
        ? at(
            before.trace.t.at(-1),
            before.trace[this.changed.value].at(-1),
            before.words,
            Live.colour(this.box, 'soft'),
          )
        : [];
      return [...lasting, ...known, ...left];
    }

    // What is known at equal times over the whole run, and not only at the steps.
    drawPaths({ ctx, bbox, valToPos }) {
      ctx.save();
      ctx.beginPath();
      ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
      ctx.clip();
      this.lists?.forEach((list, i) => {
        ctx.beginPath();
        list.forEach((value, k) =>
          ctx.lineTo(valToPos((this.seconds * k) / (list.length - 1), 'x', true), valToPos(value, 'y', true)),
        );
        ctx.setLineDash([7, 5].map(length => length * devicePixelRatio));
        Object.assign(ctx, { strokeStyle: this.colourOf(this.paths[i]), lineWidth: 1.2 * devicePixelRatio });
        ctx.stroke();
      });
      ctx.restore();
    }

    markExit(plot, { t, up, curve }, words) {
      const { ctx, bbox } = plot,
        size = 6 * devicePixelRatio;
      const x = plot.valToPos(t, 'x', true),
        tip = up ? bbox.top : bbox.top + bbox.height,
        inwards = up ? 1 : -1;
      ctx.save();
      ctx.fillStyle = this.colourOf(curve);
      ctx.beginPath();
      ctx.moveTo(x, tip);
      ctx.lineTo(x - size, tip + inwards * 1.6 * size);
      ctx.lineTo(x + size, tip + inwards * 1.6 * size);
      ctx.fill();
      if (words) {
        const left = x > bbox.left + bbox.width / 2;
        Object.assign(ctx, {
          font: `500 ${12 * devicePixelRatio}px "Book Sans", sans-serif`,
          textAlign: left ? 'right' : 'left',
          textBaseline: 'middle',
        });
        ctx.fillText(words, x + (left ? -2 : 2) * size, tip + inwards * 1.2 * size);
      }
      ctx.restore();
    }
  };
})();
