// A live figure: puts the stage in the place of the still picture and runs it as the reader asks.
(function () {
  'use strict';
  const Live = (globalThis.Live ??= {});
  const still = matchMedia('(prefers-reduced-motion: reduce)');
  let compiled;
  const PIECES = 8; // in which a figure makes its first run
  const breath = () => new Promise(next => setTimeout(next)); // between two pieces the page answers
  let turn = Promise.resolve(); // of the figure that is next
  Live.opened = {};
  Live.started = []; // a promise for each figure, kept once it runs or never will

  // `drawing` has view(settings, width), draw(pen, run, settings, part) and tell(now, settings), which returns a sentence; and, if a
  // pointer in the picture sets something, take(x, y, settings), which returns what, and press(x, y, run, settings) for where it came
  // down. ghost(pen, run, settings, part) draws the run without what stands in a method's place, where draw would draw too much.
  // Where the code is lit, lit(now, lines) returns the first and last line and what it finds; edits(values) lists words of the
  // code that a click changes, as Live.Edits has them; when(now) is a time that is not in seconds. One that is
  // "timed" also has chart(pen, run, settings) and answer(stage, run, settings), which comes before all drawing and returns a method.
  Live.figure = function (name, drawing) {
    if (!globalThis.WebAssembly || !globalThis.DecompressionStream) return; // a browser that is too old keeps the still picture
    for (const element of document.querySelectorAll(`[data-live="${name}"]`))
      Live.started.push(start(element, name, drawing));
  };

  // The stage stands at once: what takes its height later would move the text under the reader's eyes.
  async function start(element, name, drawing) {
    const figure = new Figure(element, Live.descriptions[name], drawing);
    try {
      const [code] = await Promise.all([(compiled ??= Live.compile(Live.compiled)), document.fonts.ready]);
      const opened = turn.then(() => figure.open(code, name));
      turn = opened.catch(() => {});
      await opened;
      Live.opened[name] = figure;
    } catch (fault) {
      figure.stage.remove();
      if (!(fault instanceof WebAssembly.CompileError)) throw fault; // nor can an old browser run newer code
    }
  }

  class Figure extends Live.Shown {
    constructor(element, description, drawing) {
      super();
      Object.assign(this, { element, drawing, description, playing: false, frameAsked: 0, modules: [] });
      element.querySelector('.still').before(element.querySelector(':scope > template').content.cloneNode(true));
      const find = selector => element.querySelector(selector);
      this.stage = find('.stage');
      this.readout = find('.readout');
      this.status = find('.unseen');
      this.settings = new Live.Settings(this.stage, description.controls);
      this.pen = new Live.Pen(find('canvas.scene'));
      if (drawing.chart)
        this.chart = new Live.Plot(find('.chart'), drawing, description.chart.shape, values => this.choose(values));
      else if (description.chart)
        this.chart = new Live.Chart(find('.chart'), description.chart, this.methods, description.seconds);
      this.stage.setAttribute('aria-label', element.querySelector('figcaption b').textContent);
      if (description.handle)
        this.handle = new Live.Handle(find('canvas.scene'), description.handle, () => this.hold());
      this.links = new Live.Links(this);
      this.settings.tell();
      this.showCode(this.method);
    }
    // What the methods are called that it has, or has to choose from.
    get methods() {
      const { methods, controls } = this.description;
      return methods ?? controls.find(({ name }) => name === 'method')?.choices ?? {};
    }
    // A step that the reader has written, compiled, and as a link has it.
    useReader(compiled, packed) {
      Object.assign(this, { reader: compiled, packed });
      for (const module of this.modules) module.useReader(compiled);
      if (this.ahead) this.ahead.asked = null; // the same settings, and another run
    }
    get readerFault() {
      return this.mistakes?.isYours ? this.run.module.readerFault : null;
    }
    // The one that is chosen, or whose place is taken, or that is the answer, or the only one.
    get method() {
      return this.values.method ?? this.mistakes?.standsFor ?? this.answered ?? Object.keys(this.methods)[0];
    }
    async open(code, name) {
      const { element, description } = this;
      const find = selector => element.querySelector(selector);
      const run = async () => {
        const module = await Live.open(code, name);
        this.modules.push(module);
        if (this.reader) module.useReader(this.reader);
        return new Live.Run(module, description);
      };
      this.run = await run();
      this.clock = new Live.Clock(description.pace);
      // One that the reader holds meanwhile, or that has no run over time, has no moment to go back to.
      if (this.chart && !description.endless && !this.drawing.chart) {
        this.ahead = new Live.Ahead(await run());
        this.scrubber = new Live.Scrubber(this.chart, t => this.goTo(t));
      }
      if (find('.chips')) this.mistakes = new Live.Mistakes(this, run);
      if (description.timed) this.stopwatch = new Live.Stopwatch(code, element.dataset.live, () => this.retime());
      const { pen, drawing } = this;
      if (drawing.take) {
        pen.canvas.classList.add('taken');
        const at = (x, y) => [pen.fromX(x), pen.fromY(y)];
        Live.drag(
          pen.canvas,
          (x, y) => this.take(drawing.take(...at(x, y), this.values)),
          (x, y) => this.press(...at(x, y)),
        );
      }
      if (drawing.edits)
        this.edits = new Live.Edits(this.stage, drawing.edits, this.settings, values => this.choose(values));
      this.mistakes?.fit();
      if (this.mistakes?.made) await this.mistakes.prepare();
      this.fit();
      await this.showAll();
      this.listen(find);
      this.startWhenSeen();
      element.classList.add('live');
    }

    listen(find) {
      const on = (action, handler) => find(`[data-do=${action}]`).addEventListener('click', handler);
      on('play', () => (this.playing ? this.pause() : this.play()));
      on('step', () => this.step());
      on('reset', () => this.reset());
      if (this.stopwatch) on('time', () => this.time());
      this.stage.addEventListener('input', () => this.change());
      this.stage.addEventListener('change', () => this.release());
      new ResizeObserver(() => {
        this.chart?.resize();
        this.draw();
      }).observe(this.stage);
      for (const source of [matchMedia('(prefers-color-scheme: dark)'), still])
        source.addEventListener('change', () => this.draw());
      document.addEventListener('themechange', () => this.draw());
      document.addEventListener('visibilitychange', () => this.ask());
    }

    // Nothing moves by itself where the reader does not want motion, nor twice.
    startWhenSeen() {
      let started = still.matches;
      Live.watch(this.stage, (visible, mostly) => {
        this.visible = visible;
        if (!started && mostly) {
          started = true;
          this.begin();
          this.play();
        }
        this.ask();
      });
    }

    get values() {
      return { ...this.settings.values, ...this.handle?.values };
    }
    // The same as a link has them.
    get query() {
      const held = Object.entries(this.handle?.values ?? {});
      return [
        this.settings.query,
        ...(this.mistakes?.isYours && this.packed ? [`code=${this.packed}`] : []),
        ...held.map(([name, value]) => `${encodeURIComponent(name)}=${Number(value.toPrecision(6))}`),
      ].join('&');
    }
    read(query) {
      return { ...this.settings.read(query), ...this.handle?.read(query) };
    }
    set(values) {
      this.settings.values = values;
      if (this.handle) this.handle.values = values;
    }

    begin() {
      const { values, run } = this;
      this.begun = values;
      run.start(values);
      this.clock.restart();
      this.tell();
    }
    // What the controls and the methods say of the settings.
    tell() {
      this.settings.tell(this.run.now);
      this.mistakes?.tell();
      this.edits?.show();
      this.answer();
    }
    // What the figure says of its methods, where it has times of them.
    answer() {
      const { values, run, drawing } = this;
      if (!this.stopwatch) {
        this.showCode(this.method);
        return;
      }
      run.times = this.stopwatch.of(values);
      this.answered = drawing.answer(this.stage, run, values);
      this.mistakes?.fit();
      this.showCode(this.method);
      if (this.playing) this.drawChart(); // no frame draws it
    }
    time() {
      this.stopwatch.begin(this.values);
      this.retime();
    }
    retime() {
      this.answer();
      this.draw();
      this.speak();
    }
    // Something that the reader set by another way than its control: in a chart, by a link, by words in the prose.
    choose(values) {
      this.set(values);
      if (this.anew) return this.hold();
      this.change();
      this.release();
    }
    // By a pointer in the picture. In a run without an end it takes hold of what is held there.
    take(values) {
      if (!values) return;
      if (!this.description.endless) return this.choose(values);
      this.set(values);
      this.hold();
    }
    press(x, y) {
      if (!this.drawing.press) return;
      this.set(this.drawing.press(x, y, this.run, this.values));
      this.tell();
    }
    // Whether what is struck in the picture is to be seen from its start.
    get anew() {
      return this.description.anew && !still.matches;
    }
    showCode(method) {
      const own = this.showing ?? this.mistakes?.made ?? '';
      if (method === this.codeShown && own === this.ownShown) return;
      Object.assign(this, { codeShown: method, ownShown: own });
      for (const code of this.stage.querySelectorAll('[data-method]'))
        code.hidden = code.dataset.method !== method || (code.dataset.own ?? '') !== own;
      if (this.run) this.fit();
    }
    // The page looks whether the code that is shown fits.
    fit() {
      this.stage.dispatchEvent(new Event('shown'));
    }
    // The whole run in small pieces, while the page goes on: nobody holds the figure yet.
    async showAll() {
      this.begin();
      for (let share = 1; share <= PIECES; ++share) {
        await breath();
        this.run.finish((share / PIECES) * this.run.seconds);
      }
      await breath();
      this.draw();
      this.speak();
    }
    // To the end, or to where it was held.
    showWhole(until) {
      this.begin();
      this.run.finish(until);
      this.draw();
      this.speak();
    }
    // The moment stays, and what holds it: a run that is played goes on from there, and one seen to its end is seen to it.
    change() {
      this.mistakes?.fit();
      if (this.mistakes?.made && !this.mistakes.run) this.mistakes.prepare().then(() => this.draw());
      const { run, playing, values } = this;
      if (this.ahead && !this.changing) this.before = this.ahead.keep(this.begun);
      this.changing = true;
      const { full, now } = run;
      if (playing && run.endless) {
        run.set(values);
        this.tell();
      } else if (!playing) return this.showWhole(full ? undefined : now.t);
      else {
        this.begin();
        run.finish(now.t);
      }
      this.label();
    }
    // The reader has let go of a control.
    release() {
      this.changing = false;
      if (!this.playing) this.draw();
    }
    goTo(t) {
      this.setPlaying(false);
      this.run.goTo(this.values, t);
      this.draw();
      this.speak();
    }
    // What the reader holds in the picture. In a run without an end it moves within the run, and what hangs from it does not stand
    // still meanwhile; elsewhere it is a setting like others.
    hold() {
      if (this.anew) {
        this.begin();
        return this.setPlaying(true);
      }
      if (!this.description.endless) return this.change();
      this.run.set(this.values);
      if (this.run.taken === 0) this.begin();
      if (!this.playing) this.play();
    }
    play() {
      if (this.run.ended || (!this.playing && this.run.taken === 0)) this.begin();
      this.setPlaying(true);
    }
    pause() {
      this.setPlaying(false);
      this.draw();
      this.speak();
    }
    step() {
      this.setPlaying(false);
      if (this.run.ended) this.begin();
      this.run.step();
      this.draw();
      this.speak();
    }
    reset() {
      this.setPlaying(false);
      this.handle?.reset();
      this.before = undefined;
      this.begin();
      this.draw();
      this.speak();
    }
    setPlaying(playing) {
      this.playing = playing;
      this.stage.querySelector('[data-do=play]').textContent = playing ? 'Pause' : 'Play';
      this.ask();
    }

    // A frame is asked for only while something moves and is seen.
    ask() {
      const wanted = this.playing && this.visible !== false && !document.hidden;
      if (!wanted) {
        cancelAnimationFrame(this.frameAsked);
        this.frameAsked = 0;
        this.clock.last = null;
        return;
      }
      this.frameAsked ||= requestAnimationFrame(now => this.frame(now));
    }
    frame(now) {
      this.frameAsked = 0;
      this.clock.frame(now, this.run);
      this.draw(this.clock.part(this.run));
      if (this.run.ended) {
        this.setPlaying(false);
        this.speak();
      }
      this.ask();
    }
  }
})();
