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

  // One figure in an instance, and so in a memory, of its own.
  Live.open = async function (compiled, name) {
    const { exports: module } = await WebAssembly.instantiate(compiled, {});
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
        module.start();
        shown = undefined;
        return look();
      },
      advance(steps) {
        module.advance(steps);
        return look();
      },
      // What stands in the place of a method: its order and that method's, and which method of the book takes its steps, if one does.
      examine() {
        module.examine();
        return {
          order: module.examined_order(),
          rightOrder: module.examined_right_order(),
          is: text(module.examined_is()),
          apart: module.examined_apart(),
        };
      },
      bodies: module.bodies(),
      work: (which, rounds) => module.work(which, rounds),
      fingerprint: steps => BigInt.asUintN(64, module.fingerprint(steps)).toString(16).padStart(16, '0'),
    };
  };
})();
