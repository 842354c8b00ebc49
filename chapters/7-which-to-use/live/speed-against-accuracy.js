// All methods on one thing: what each gets for a price, the three that are nearest, and what is cheapest within a tolerance.
(function () {
  'use strict';
  const Live = globalThis.Live;
  const NAME = 'speed-against-accuracy';
  const FRAMES = 60; // a second
  const LIKE = { spring: 'suspension', orbit: 'shuttle', air: 'leaf' }; // whose recorded times stand for the reader's own thing
  const KIN = ['dopri5', 'trapezoid', 'linear_damping_implicit_last', 'backward_euler_spring']; // share a colour: dashed and hollow
  const FRAME = 1e6 / FRAMES; // [µs]
  const GRIP = 10; // how near to a line or a dot a pointer takes it [px]
  const EXPLICIT = ['euler', 'symplectic_euler', 'velocity_verlet', 'midpoint', 'yoshida4', 'rk4', 'dopri5']; // for every thing
  const NOTHING = 1e-9; // of an error: what is less is rounding, or as good as that [m]
  const description = () => Live.descriptions[NAME];
  const metres = error => (error === Infinity ? 'gone' : error > NOTHING ? Live.metres(error) : '<\u202f1\u202fnm');
  const millimetres = tolerance => `${Live.digits(1000 * tolerance, 3)}\u202fmm`;
  const micro = time => `${Live.digits(time, 2)}\u202fµs`;

  // The recorded time of a step of each method [ns].
  function recorded(thing) {
    const { thing: things, method, nanoseconds } = description().tables['recorded-steps'];
    const wanted = LIKE[thing] ?? thing;
    return Object.fromEntries(nanoseconds.flatMap((ns, i) => (things[i] === wanted ? [[method[i], ns]] : [])));
  }

  // The header that has a method, and whether its step is exact: right for a thing alone, with nothing else acting.
  const told = column => name => {
    const table = description().tables['recorded-steps'];
    return table[column][table.method.indexOf(name)];
  };
  const headerOf = told('header'),
    isExact = told('exact');

  // Nobody has timed what stands in the place of a method: it takes what the book's explicit method takes that asks as often, or most
  // nearly so. Returns that one's name, and how many times its time.
  function likened(name, now) {
    const asks = now[`${name} evaluations`];
    const off = one => Math.abs(now[`${one} book evaluations`] - asks);
    const like = EXPLICIT.reduce(
      (near, one) => (off(one) < off(near) ? one : near),
      EXPLICIT.includes(name) ? name : EXPLICIT[0],
    );
    return { like, times: asks / now[`${like} book evaluations`] };
  }

  // What each method that is for this thing offers: { steps in a frame, error, time for a thousand [µs] } for each number of steps
  // that was tried.
  function offers({ now, times }, { thing, own = 'none' }) {
    const known = recorded(thing);
    const fitting = Object.entries(description().methods).filter(([name]) => now[`${name} errors`].length);
    return fitting.map(([name, plain]) => {
      const label = Live.nameInList(name, plain, { own }),
        told = Live.nameInSentence(name, plain, { own }),
        stands = Live.standsFor(name, { own }),
        timed = stands ? likened(name, now) : { like: name, times: 1 };
      const error = i => Math.max(NOTHING, now[`${name} errors`][i]);
      const rungs = step =>
        [...now.tried].map((steps, i) => ({ steps, rung: i, error: error(i), time: steps * step * timed.times }));
      const of = all => rungs(all[timed.like]);
      return { name, label, told, stands, like: timed.like, rungs: of(times ?? known), recorded: times && of(known) };
    });
  }

  // Nearest first, of what the price buys; then what it does not buy.
  function rank(all, { price }) {
    const nearest = rungs => rungs.reduce((best, rung) => (rung.error < best.error ? rung : best));
    const ranked = all.map(offer => {
      const bought = offer.rungs.filter(({ time }) => time <= price);
      return { ...offer, bought: bought.length ? nearest(bought) : null };
    });
    const dear = ({ bought }) => Number(!bought),
      far = ({ bought }) => bought?.error ?? 0,
      time = ({ bought, rungs }) => (bought ?? rungs[0]).time;
    return ranked.sort((a, b) => dear(a) - dear(b) || far(a) - far(b) || time(a) - time(b));
  }

  // Of all that is near enough, what takes the least time.
  function cheapest(all, { tolerance }) {
    const near = all.flatMap(({ name, told, rungs }) =>
      rungs.filter(({ error }) => error <= tolerance).map(rung => ({ name, told, ...rung })),
    );
    return near.reduce((least, one) => (!least || one.time < least.time ? one : least), null);
  }
  const inSteps = ({ steps }) => `${steps} step${steps > 1 ? 's' : ''} a frame`;

  // Of a list of coordinates, the places at the ends of frames: [x] on a line, [x, y] in the plane.
  function places({ seconds }, list) {
    const count = Math.round(seconds * FRAMES) + 1,
      size = list.length / count;
    return Array.from({ length: count }, (_, n) => [...list.subarray(n * size, (n + 1) * size)]);
  }

  // What asks the program of this chapter the same.
  function question({ now }, { tolerance }) {
    const reach = Math.max(...places(now, now.truth).map(place => Math.hypot(...place)));
    const turning = `--omega ${Live.digits(Number.isNaN(now.omega) ? (2 * Math.PI) / now.seconds : now.omega, 4)}`;
    const known = quantity => !Number.isNaN(now[quantity]);
    const option = quantity => `${turning} --${quantity} ${Live.digits(now[quantity], 3)}`;
    const scene = known('angle')
      ? `pendulum ${option('angle')}`
      : known('zeta')
        ? `spring ${option('zeta')}`
        : known('eccentricity')
          ? `orbit ${option('eccentricity')}`
          : now.drag > 0
            ? `drag --drag ${now.drag}`
            : 'ball';
    return (
      `build/code/choose/choose --scene ${scene} --hz ${FRAMES} --seconds ${now.seconds} ` +
      `--error-metres ${tolerance} --reach ${Live.digits(reach, 4)}`
    );
  }

  Live.figure(NAME, {
    view: () => ({ x: [0, 1], y: [0, 3], free: true }),
    draw(pen, run, values, part) {
      const { three } = this.found;
      three.forEach((offer, i) => this.row(pen, run, offer, i, part));
      if (!three.length) pen.text(0.5, 2, this.noneFor(values));
    },
    noneFor({ price }) {
      const bought = this.found.all.some(({ rungs }) => rungs.some(({ time }) => time <= price));
      return bought ? `none holds it for ${micro(price)}` : `none is to be had for ${micro(price)}`;
    },
    rowAt: i => ({ low: 2 - i + 0.05, high: 0.74 }),
    motionAt: (i, { low, high }, { omega }) => {
      const left = Number.isNaN(omega) ? 0.01 : 0.37;
      return { left, low, width: 0.99 - left, high };
    },
    // The way of the book's method, where something stands in its place.
    ghost(pen, run, values, part) {
      const { three } = this.found,
        i = three.findIndex(({ stands }) => stands);
      if (i < 0) return;
      const { name, bought } = three[i];
      this.motion(pen, this.motionAt(i, this.rowAt(i), run.now), run, name, bought.rung, part);
    },
    row(pen, run, { name, label, bought, rank, stands }, i, part) {
      const { low, high } = this.rowAt(i);
      pen.text(0.01, low + high + 0.1, bought.dear ? label : `${rank}. ${label}`, { colour: name, align: 'left' });
      pen.text(
        0.99,
        low + high + 0.1,
        `${bought.dear ? 'too dear: ' : ''}${inSteps(bought)}, ${metres(bought.error)}`,
        { align: 'right' },
      );
      const { omega, zeta } = run.now;
      if (!Number.isNaN(omega)) {
        const spring = { homega: omega / FRAMES / bought.steps, zeta };
        const map = Live.frame(pen, { left: 0.01, low, width: 0.32, high });
        Live.map(pen, map, description().tables.map, { label, colour: name, changed: stands }, spring);
      }
      this.motion(pen, this.motionAt(i, { low, high }, run.now), run, name, bought.rung, part);
    },
    // The way so far, on the way that it should be.
    motion(pen, box, { now }, name, rung, part) {
      const { length } = now.truth;
      // Over the time, what moves on a line.
      const points = list => places(now, list).map((place, n) => (place.length > 1 ? place : [n / FRAMES, ...place]));
      const truth = points(now.truth),
        way = points(now[`${name} paths`].subarray(rung * length, (rung + 1) * length)),
        last = truth.length - 1;
      const place = this.scale(pen, box, truth, length > truth.length);
      const at = Math.min(last, Math.max(0, now.t * FRAMES - 1 + part));
      const whole = Math.floor(at),
        next = Math.min(last, whole + 1);
      const between = list => list[whole].map((value, k) => value + (at - whole) * (list[next][k] - value));
      const line = (list, look) => pen.line(...[0, 1].map(k => list.map(point => place(point)[k])), look);
      const { left, low, width, high } = box;
      pen.within([left, left + width], [low, low + high], { colour: 'context', width: 0.8 }, () => {
        line(truth, { colour: 'exact', width: 1.2, dash: [4, 3] });
        line([...way.slice(0, whole + 1), between(way)], { colour: name, width: 2 });
        pen.dot(...place(between(truth)), 6, 'exact');
        pen.dot(...place(between(way)), 4, name);
      });
    },
    // From metres and seconds to the picture; in the plane a metre is as long upwards as sideways.
    scale(pen, { left, low, width, high }, truth, plane) {
      const span = k => [Math.min(...truth.map(point => point[k])), Math.max(...truth.map(point => point[k]))];
      const [x, y] = [span(0), span(1)];
      const room = 0.82;
      let across = (room * width) / (x[1] - x[0]),
        up = (room * high) / (y[1] - y[0]);
      if (plane) {
        const pixels = [pen.x(1) - pen.x(0), pen.y(0) - pen.y(1)];
        const metre = Math.min(across * pixels[0], up * pixels[1]);
        [across, up] = [metre / pixels[0], metre / pixels[1]];
      }
      const middle = [(x[0] + x[1]) / 2, (y[0] + y[1]) / 2];
      return point => [
        left + width / 2 + (point[0] - middle[0]) * across,
        low + high / 2 + (point[1] - middle[1]) * up,
      ];
    },

    // Powers of ten: of microseconds to the right, of metres upwards.
    chartView: { x: [-0.75, 3.4], y: [Math.log10(NOTHING) - 0.8, 1.5], free: true },
    chart(pen, run, values) {
      const { x, y } = this.chartView;
      const price = Math.log10(values.price),
        tolerance = Math.log10(values.tolerance);
      const height = error => Math.min(Math.log10(error), y[1] + 1);
      pen.box([x[0], price], [y[0], tolerance]);
      pen.grid([0, 1, 2, 3], [-9, -6, -3, 0], {
        x: power => (power < 3 ? `${10 ** power}\u202fµs` : '1\u202fms'),
        y: power => Live.metres(10 ** power).replace('.0', ''),
      });
      // The same as shares of a frame, along the upper edge.
      for (const share of [0.01, 0.1, 1, 10]) {
        pen.text(Math.log10((share / 100) * FRAME), y[1] - 0.3, `${share}\u202f%`, { colour: 'ink' });
      }
      const line = (rungs, look) =>
        pen.line(
          rungs.map(({ time }) => Math.log10(time)),
          rungs.map(({ error }) => height(error)),
          look,
        );
      const { all, three } = this.found,
        book = this.book(all, run, values);
      if (book) line(book.rungs, { colour: 'context', width: 1.4 });
      for (const { name, rungs, recorded } of all) {
        if (recorded) line(recorded, { colour: 'context', width: 1 });
        const first = three.some(one => one.name === name);
        line(rungs, { colour: name, width: first ? 2.6 : 1.4, dash: KIN.includes(name) ? [6, 4] : [] });
        for (const { time, error } of rungs) {
          const at = [Math.log10(time), height(error)];
          pen.dot(...at, first ? 3 : 2, name);
          if (KIN.includes(name)) pen.dot(...at, first ? 1.6 : 1, 'paper');
        }
      }
      pen.line([price, price], y, { colour: 'ink', width: 1.6 });
      pen.line(x, [tolerance, tolerance], { colour: 'limit', width: 1.6, dash: [3, 4] });
      const beside = price < 2.5 ? [price + 0.06, 'left'] : [price - 0.06, 'right'];
      pen.text(beside[0], y[1] - 0.8, micro(values.price), { colour: 'ink', align: beside[1] });
      for (const { name, bought, rank } of three) {
        const at = [Math.log10(bought.time), height(bought.error)];
        pen.dot(...at, 9, name);
        if (!bought.dear) pen.text(...at, `${rank}`, { colour: 'paper' });
      }
      this.lines = { price, tolerance };
    },
    // A pointer takes hold of the line of the tolerance where it comes down on it, else of that of the price; a click on a dot picks a method.
    grip(x, y, pen) {
      const across = to => Math.abs(x - to) * pen.metre,
        up = to => Math.abs(y - to) * pen.metreUp;
      const dots = this.found.all.flatMap(({ name, rungs }) =>
        rungs.map(({ time, error }) => ({ name, off: Math.hypot(across(Math.log10(time)), up(Math.log10(error))) })),
      );
      const dot = dots.reduce((near, one) => (one.off < near.off ? one : near));
      this.pressed = dot.off < GRIP ? dot.name : null;
      const isTolerance = up(this.lines.tolerance) < GRIP && across(this.lines.price) > GRIP;
      this.gripped = isTolerance ? 'tolerance' : 'price';
    },
    get upright() {
      return this.gripped === 'tolerance';
    },
    held(right, up, clicked) {
      if (clicked && this.pressed) {
        this.picked = this.pressed;
        return {};
      }
      const { values, scale = 1 } = description().controls.find(({ name }) => name === this.gripped);
      const power = this.gripped === 'price' ? right : up;
      const off = value => Math.abs(Math.log10(value * scale) - power);
      return { [this.gripped]: scale * values.reduce((near, value) => (off(value) < off(near) ? value : near)) };
    },
    gripped: 'price',

    // Finds what is drawn and told until something is set anew. Returns the method to take: the cheapest that is near enough;
    // without one, the nearest.
    answer(stage, run, values) {
      const all = offers(run, values),
        ranked = rank(all, values).map((offer, i) => ({ ...offer, rank: i + 1 })),
        inexactOf = list => list.filter(({ name }) => !isExact(name)),
        cheap = cheapest(inexactOf(all), values);
      const exact = all.find(({ name }) => isExact(name));
      // The exact step would move as the truth does, which is drawn anyway. What the reader picked is one of three.
      const inexact = inexactOf(ranked);
      const shown = inexact.filter(({ bought }) => bought && bought.error < Infinity);
      const other = inexact.find(
        ({ name, stands }) =>
          (this.picked ? name === this.picked : stands) && !shown.slice(0, 2).some(one => one.name === name),
      );
      const third = other ? { ...other, bought: other.bought ?? { ...other.rungs[0], dear: true } } : shown[2];
      const three = [...shown.slice(0, 2), ...(third ? [third] : [])];
      this.found = { all, three, cheap, exact };
      const rows = ranked.map(({ name, label, bought, rungs, stands }, i) => {
        const near = bought && bought.error <= values.tolerance;
        const off = bought ? metres(bought.error) + (near ? ' ✓' : '') : 'too dear';
        const { steps, time } = bought ?? rungs[0];
        const cells = [steps, off, (stands ? '≈\u202f' : '') + micro(time)];
        const key = `<span class="key${KIN.includes(name) ? ' dashed' : ''}" style="--key:var(--${name.replace(/_/g, '-')})"></span>`;
        return `<tr${three.some(one => one.name === name) ? ' class="shown"' : ''}><td>${bought ? i + 1 : ''}</td><th scope="row"><button type="button" data-name="${name}">${key}${label}</button></th>${cells.map(cell => `<td>${cell}</td>`).join('')}</tr>`;
      });
      const whose = { undefined: 'as recorded', null: 'being taken …' }[run.times] ?? 'taken in your browser';
      // The book has a header of its own methods alone.
      const ofTheBook = inexact.filter(({ stands }) => !stands),
        near = cheapest(ofTheBook, values),
        { name } = near ?? ofTheBook[0];
      const link = method => `<a href="headers/${headerOf(method)}" download>${headerOf(method)}</a>`;
      const why = near ? 'the cheapest that is near enough' : 'the nearest, though not near enough';
      const take = exact
        ? `This thing has an exact step: take ${link(exact.name)}. If other forces act as well, take ${link(name)}`
        : `Take ${link(name)}`;
      const list = stage.querySelector('.ranked'),
        focused = list.contains(document.activeElement) && document.activeElement.dataset.name;
      list.innerHTML =
        `<table><caption class="unseen">The methods, nearest first</caption><thead><tr><th scope="col"><span class="unseen">Rank</span></th><th scope="col">Method</th><th scope="col">Steps</th><th scope="col">Off by</th><th scope="col">Time</th></tr></thead>` +
        `<tbody>${rows.join('')}</tbody></table><p>Times: ${whose}${this.estimated(all)}. ✓: within ${millimetres(values.tolerance)}. A name shows its code, which can be changed.</p>`;
      list.onclick = ({ target }) => this.pick(target.closest('button')?.dataset.name);
      if (focused) list.querySelector(`[data-name="${focused}"]`)?.focus();
      stage.querySelector('.advice').innerHTML =
        `<p>${take}, ${why}. Or have all methods tried, from 1 step to 1024:</p>` +
        `<pre><code>${question(run, values)}</code></pre>`;
      return all.some(one => one.name === this.picked) ? this.picked : (exact?.name ?? name);
    },
    estimated(all) {
      const { like } = all.find(({ stands }) => stands) ?? {};
      return like ? `; ≈: as ${description().methods[like]} takes for as many evaluations` : '';
    },
    // What the book's method offers, where something stands in its place.
    book(all, run, values) {
      const stands = all.find(one => one.stands),
        mistakes = Live.opened[NAME]?.mistakes;
      if (!stands || !mistakes?.run) return null;
      return offers({ ...run, now: mistakes.inStep(run).now }, mistakes.right).find(({ name }) => name === stands.name);
    },
    pick(name) {
      if (!name) return;
      this.picked = name;
      Live.opened[NAME].choose({});
    },
    tell(now, values) {
      const {
        three: [first],
        cheap,
        exact,
      } = this.found;
      const other = exact ? `This thing has an exact step, for ${micro(exact.rungs[0].time)}. Of the others, ` : '';
      const nearest = first
        ? `${other}${first.told} is nearest for ${micro(values.price)}: ${inSteps(first.bought)}, off by ${metres(first.bought.error)}.`
        : `${other}${exact ? '' : 'Of all methods '}${this.noneFor(values)}.`;
      const near = millimetres(values.tolerance);
      return cheap
        ? `${nearest} Within ${near}, ${cheap.told} is cheapest: ${inSteps(cheap)}, ${micro(cheap.time)}.`
        : `${nearest} None comes within ${near}.`;
    },
  });
})();
