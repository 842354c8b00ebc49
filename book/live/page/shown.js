// What a live figure shows and says of its run, at the moment where it stands.
(function () {
  'use strict';
  const Live = (globalThis.Live ??= {});

  // A figure has all that is used here; it draws when something has moved or been set.
  Live.Shown = class {
    draw(part = 1) {
      const { values, run, pen, drawing } = this;
      pen.begin(drawing.view(values, pen.canvas.clientWidth));
      if (this.changing && this.whole) pen.faintly(0.35, () => drawing.draw(pen, this.whole, values, 1));
      this.drawGhost(part);
      drawing.draw(pen, run, values, part);
      this.handle?.place(pen);
      if (!this.stopwatch || !this.playing) this.drawChart(); // an answer stays while it is played
      if (drawing.lit) this.light();
      this.say(this.sentence + (this.playing && this.clock.slow ? ' Slower than real time on this machine.' : ''));
    }
    drawGhost(part) {
      const { mistakes, drawing, pen, run } = this;
      if (!mistakes?.made || !mistakes.run) return;
      const draw = drawing.ghost ?? drawing.draw;
      pen.faintly(0.35, () => draw.call(drawing, pen, mistakes.inStep(run), mistakes.right, part));
    }
    // The longest sentence so far keeps its room, or the text below would jump by a line while the figure plays.
    say(words) {
      const { readout, pen } = this;
      const width = pen.canvas.clientWidth; // before the words, which would have the page laid out anew for it
      readout.textContent = words;
      if (words.length <= this.longest && width === this.wide) return;
      if (width !== this.wide) readout.style.minHeight = '';
      this.longest = words.length;
      this.wide = width;
      readout.style.minHeight = `${readout.offsetHeight}px`;
    }
    // The lines of the code that are at work, and what the last of them finds.
    light() {
      const shown = [...this.stage.querySelectorAll('.listing:not([hidden]) .line')];
      const lines = shown.filter(line => !line.querySelector('del')); // those that a mistake takes out are at work no more
      const [from, to, found = ''] = this.drawing.lit(
        this.run.now,
        lines.map(line => line.textContent),
      );
      lines.forEach((line, i) => {
        line.classList.toggle('lit', i >= from && i <= to);
        line.dataset.found = i === to ? found : '';
      });
    }
    // What the run that is shown will come to.
    get whole() {
      return this.ahead && (this.run.full ? this.run : this.ahead.of(this.values));
    }
    drawChart() {
      const { run, values } = this;
      this.chart?.draw(run, values, this.whole?.trace, this.beforeIt);
      this.scrubber?.place(run.now.t, this.when);
    }
    // What the chart compares the run with: the one without a mistake, or the one before a change.
    get beforeIt() {
      const { mistakes, before } = this;
      if (mistakes?.made && mistakes.ahead) return mistakes.before;
      const words = before && ['before', this.settings.wordsSince(before.values)].filter(Boolean).join(': ');
      return before && { trace: before.trace, words };
    }
    get when() {
      const { now } = this.run;
      return this.drawing.when?.(now) ?? `${now.t.toFixed(2)}\u202fs`;
    }
    get sentence() {
      return `${this.when}: ${this.drawing.tell(this.run.now, this.values)}`;
    }
    // For those who do not see it: once things have come to rest, not in every frame.
    speak() {
      clearTimeout(this.speaking);
      this.speaking = setTimeout(() => {
        this.status.textContent = this.sentence;
      }, 400);
      this.label();
    }
    label() {
      for (const picture of this.stage.querySelectorAll('[role=img]')) {
        const axis = picture.parentElement.querySelector('.axis').textContent;
        picture.setAttribute('aria-label', `${axis}. ${this.settings.words}. ${this.sentence}`);
      }
    }
  };
})();
