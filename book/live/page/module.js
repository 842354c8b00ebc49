// The compiled figures: text and numbers in and out of the WebAssembly module.
(function () {
  'use strict';
  const Live = (globalThis.Live ??= {});

  // What is shown, as a list: one of a single value comes as a number.
  Live.list = value => (typeof value === 'number' ? [value] : value);

  // Base64, since a page on disk can load a script and nothing else; compressed, since pages that nobody sent are not.
  Live.compile = function (base64) {
    const packed = new Blob([Uint8Array.from(atob(base64), c => c.charCodeAt(0))]);
    const unpacked = new Response(packed.stream().pipeThrough(new DecompressionStream('gzip')));
    return unpacked.arrayBuffer().then(WebAssembly.compile);
  };

  const PATIENCE = 2000; // with all steps of a run that a reader has written [ms]
  const SOME = 64;
  const STATE = 10; // numbers of a run, as reader.cpp has them

  // The numbers of a module's memory, which moves when it grows.
  function numbersOf(module) {
    let numbers = new Float64Array(0);
    return () => (numbers.length ? numbers : (numbers = new Float64Array(module.memory.buffer)));
  }
  const copy = (from, at, to, there, count) => {
    for (let i = 0; i < count; ++i) to[there / 8 + i] = from[at / 8 + i];
  };

  // A step that the reader has written, in a module of its own: joined to that of a figure, whose scene it asks for the acceleration.
  class Reader {
    imports = {
      step: (state, t, h) => this.step(state, t, h),
    };
    join(figure) {
      this.figure = figure;
      this.own = numbersOf(figure);
    }
    use(compiled) {
      const { exports } = new WebAssembly.Instance(compiled, { scene: { acceleration: at => this.ask(at) } });
      this.module = exports;
      this.yours = numbersOf(exports);
      this.room = exports.room();
      this.fault = null;
      this.figure.count_reader();
    }
    // For a run from its start.
    begin() {
      this.spent = this.taken = 0;
      this.fault = null;
    }
    // Calls the figure, and counts the time that it takes while steps of the reader's are in it.
    timed(call) {
      this.from = performance.now();
      call();
      if (this.module) this.look();
    }
    // One that goes on for ever, or does what no program may, ends in a trap; where it was, nothing is any more.
    step(state, t, h) {
      if (this.module && !this.fault) {
        copy(this.own(), state, this.yours(), this.room, STATE);
        try {
          this.module.step(t, h);
        } catch {
          this.fault = 'Your step was stopped: it goes on for ever, or does what no program may.';
        }
        copy(this.yours(), this.room, this.own(), state, STATE);
        if (++this.taken % SOME === 0) this.look();
      }
      if (!this.module || this.fault) this.own().fill(NaN, state / 8, state / 8 + 6);
    }
    // At the clock, now and then: the page has to go on.
    look() {
      const now = performance.now();
      this.spent += now - this.from;
      this.from = now;
      if (this.spent > PATIENCE) this.fault = 'Your steps were stopped: a run of them took more than two seconds.';
    }
    ask(at) {
      const room = this.figure.room_to_ask();
      copy(this.yours(), at, this.own(), room, 7);
      this.figure.answer_reader();
      copy(this.own(), room, this.yours(), at, 3);
    }
  }

  Live.newReader = () => new Reader();

  // One figure in an instance, and so in a memory, of its own.
  Live.open = async function (compiled, name) {
    const reader = globalThis.Live.newReader();
    const { exports: module } = await WebAssembly.instantiate(compiled, { reader: reader.imports });
    reader.join(module);
    module._initialize();
    const text = at => {
      const bytes = new Uint8Array(module.memory.buffer, at);
      return new TextDecoder().decode(bytes.subarray(0, bytes.indexOf(0)));
    };
    const list = (count, at) => Array.from({ length: count }, (_, i) => text(at(i)));
    const place = (names, wanted, what) => {
      const i = names.indexOf(wanted);
      if (i < 0) throw new Error(`${name}: there is no ${what} "${wanted}", only ${names.join(', ')}`);
      return i;
    };

    const figures = list(module.figure_count(), module.figure_name);
    module.choose(place(figures, name, 'figure'));
    const settings = list(module.setting_count(), module.setting_name);
    const choices = settings.map((_, i) => list(module.choice_count(i), j => module.choice_name(i, j)));
    let memory, shown, numbers, last;

    // The names stay from start to start; where the values lie may change. What was not shown anew is not copied again.
    function look() {
      if (!shown) [shown, last] = [list(module.shown_count(), module.shown_name), {}];
      if (memory !== module.memory.buffer) numbers = new Float64Array((memory = module.memory.buffer));
      const state = {};
      shown.forEach((of, i) => {
        const changes = module.shown_changes(i);
        if (last[of]?.changes !== changes) {
          const at = module.shown_values(i) / 8,
            size = module.shown_size(i);
          last[of] = { changes, value: size === 1 ? numbers[at] : numbers.slice(at, at + size) };
        }
        state[of] = last[of].value;
      });
      return state;
    }

    return {
      settings: Object.fromEntries(settings.map((setting, i) => [setting, choices[i]])),
      set(setting, value) {
        const i = place(settings, setting, 'setting');
        module.set(i, choices[i].length ? place(choices[i], value, setting) : value);
      },
      start() {
        reader.begin();
        reader.timed(() => module.start());
        shown = undefined;
        return look();
      },
      advance(steps) {
        reader.timed(() => module.advance(steps));
        return look();
      },
      // What stands in the place of a method: its order and that method's, how many times as far off it is, which method of the book
      // takes its steps, if one does, and which shares of what is right a step moves the place and changes the velocity by.
      examine() {
        reader.timed(() => module.examine());
        return {
          order: module.examined_order(),
          rightOrder: module.examined_right_order(),
          is: text(module.examined_is()),
          apart: module.examined_apart(),
          off: module.examined_off(),
          drifts: module.examined_drifts(),
          kicks: module.examined_kicks(),
        };
      },
      useReader: compiledReader => reader.use(compiledReader),
      get readerFault() {
        return reader.fault;
      },
      bodies: module.bodies(),
      work: (which, rounds) => module.work(which, rounds),
      fingerprint: steps => BigInt.asUintN(64, module.fingerprint(steps)).toString(16).padStart(16, '0'),
    };
  };
})();
