// Values under numbers and check marks, and at the points of figures: by mouse, by touch and by keyboard.
(function () {
  'use strict';
  const all = (selector, root = document) => [...root.querySelectorAll(selector)];
  const NEAR = 24; // how far from a point it still counts as meant [px]

  const make = (name, attributes) => {
    const element = document.createElement(name);
    for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
    return element;
  };
  const tip = make('div', { class: 'tip', role: 'status', hidden: '' });
  const ring = make('div', { class: 'ring', hidden: '' });
  document.body.append(tip, ring);

  // `spoken`: whoever listens hears it from the element itself.
  function show(words, box, { below = false, spoken = false } = {}) {
    tip.hidden = false;
    tip.setAttribute('role', spoken ? 'none' : 'status');
    tip.textContent = words;
    const left = box.left + box.width / 2 - tip.offsetWidth / 2;
    const top = box.top - tip.offsetHeight - 8;
    tip.style.left = `${Math.max(8, Math.min(innerWidth - tip.offsetWidth - 8, left))}px`;
    tip.style.top = top > 0 && !below ? `${top}px` : `${box.bottom + 8}px`;
  }
  function hide() {
    tip.hidden = true;
    ring.hidden = true;
  }

  // The values of the figure that a drawing stands in: where they are, in its own units, and what they say.
  const read = new WeakMap();
  function pointsOf(svg) {
    if (!read.has(svg)) {
      const data = svg.closest('figure').querySelector('script.values');
      const values = data ? JSON.parse(data.textContent) : { says: [], wide: [] };
      const narrow = svg.closest('.narrow');
      const at = narrow ? values.narrow : values.wide;
      const says = (narrow && values.narrowSays) || values.says;
      read.set(
        svg,
        says.map((words, i) => ({ words, x: at[2 * i], y: at[2 * i + 1] })),
      );
    }
    return read.get(svg);
  }

  // Where a drawing is on the screen, and how many pixels its unit has.
  function placeOf(svg) {
    const { left, top, width } = svg.getBoundingClientRect();
    return { left, top, scale: width / svg.viewBox.baseVal.width };
  }

  function nearest(svg, clientX, clientY) {
    const { left, top, scale } = placeOf(svg);
    let best = null,
      least = NEAR;
    for (const point of pointsOf(svg)) {
      const distance = Math.hypot(left + point.x * scale - clientX, top + point.y * scale - clientY);
      if (distance < least) [best, least] = [point, distance];
    }
    return best;
  }

  function showPoint(svg, point, spoken) {
    const { left, top, scale } = placeOf(svg);
    const [x, y] = [left + point.x * scale, top + point.y * scale];
    ring.hidden = false;
    ring.style.left = `${x}px`;
    ring.style.top = `${y}px`;
    show(point.words, { left: x, width: 0, top: y - 8, bottom: y + 8 }, { spoken });
  }

  function point(event) {
    if (event.type === 'pointermove' && event.pointerType === 'touch') return; // a finger that scrolls
    const owner = event.target.closest?.('[data-tip]');
    const svg = event.target.closest?.('.plot svg');
    const near = svg && nearest(svg, event.clientX, event.clientY);
    hide();
    if (near) showPoint(svg, near);
    else if (owner) showOwner(owner);
  }
  // The sentence of a mark stands above it.
  const showOwner = owner => show(owner.dataset.tip, owner.getBoundingClientRect(), { below: owner.matches('.claim') });

  document.addEventListener('pointermove', point, { passive: true });
  document.addEventListener('pointerdown', point, { passive: true });
  const stops = new WeakMap(); // of a figure's stop what shows its value
  function showHeld(element) {
    if (element.matches('[data-tip]')) showOwner(element);
    else if (element.matches(':focus-visible')) stops.get(element)?.();
  }
  document.addEventListener('focusin', ({ target }) => showHeld(target));
  document.addEventListener('focusout', hide);
  // What the keyboard shows goes along when the page scrolls; what the mouse showed is no longer under it.
  addEventListener(
    'scroll',
    () => {
      hide();
      const { activeElement: held } = document;
      if (held.matches(':focus-visible')) showHeld(held);
    },
    { passive: true },
  );
  addEventListener('keydown', ({ key }) => {
    if (key === 'Escape') hide();
  });

  const STEPS = { ArrowRight: 1, ArrowLeft: -1, PageUp: 10, PageDown: -10, Home: -Infinity, End: Infinity };
  const UPWARDS = { ArrowUp: -1, ArrowDown: 1 };

  // The point that lies next above or below one, and not far beside it; where there is none, the same again.
  function beyond(points, now, way) {
    const from = points[now];
    let best = now,
      least = Infinity;
    points.forEach(({ x, y }, i) => {
      const off = way * (y - from.y) + 4 * Math.abs(x - from.x);
      if (way * (y - from.y) > 0.5 && off < least) [best, least] = [i, off];
    });
    return best;
  }

  // By keyboard a figure is one stop, whose arrows go from point to point.
  function giveStop(svg) {
    const points = pointsOf(svg);
    if (!points.length || svg.nextElementSibling) return;
    const title = svg.closest('figure').querySelector('figcaption b')?.textContent.replace(/\.$/, '') ?? '';
    const stop = make('span', {
      'class': 'points',
      'role': 'slider',
      'tabindex': 0,
      'aria-label': `Values of ${title}`,
      'aria-valuemin': 1,
      'aria-valuemax': points.length,
    });
    let now = 0;
    const say = () => {
      stop.setAttribute('aria-valuenow', now + 1);
      stop.setAttribute('aria-valuetext', points[now].words);
    };
    say();
    stops.set(stop, () => showPoint(svg, points[now], true));
    stop.addEventListener('keydown', event => {
      if (!(event.key in STEPS || event.key in UPWARDS)) return;
      event.preventDefault();
      if (event.key in UPWARDS) now = beyond(points, now, UPWARDS[event.key]);
      else now = Math.max(0, Math.min(points.length - 1, now + STEPS[event.key]));
      say();
      showPoint(svg, points[now], true);
    });
    svg.after(stop);
  }
  for (const svg of all('.plot .wide svg')) giveStop(svg);

  // On a phone the drawing made for it takes its place when it comes near.
  const phone = matchMedia('(max-width: 620px)');
  const comes = new IntersectionObserver(
    entries => {
      for (const { isIntersecting, target } of entries) if (isIntersecting) draw(target);
    },
    { rootMargin: '1200px' },
  );
  function draw(box) {
    comes.unobserve(box);
    const template = box.querySelector('template');
    if (!template) return;
    template.replaceWith(template.content);
    giveStop(box.querySelector('svg'));
  }
  const watch = () => {
    if (phone.matches) for (const box of all('.plot .narrow:has(template)')) comes.observe(box);
  };
  watch();
  phone.addEventListener('change', watch);
  // All of them once there is time, one after the other: a picture of the whole page has them, too.
  addEventListener('load', async () => {
    for (const box of all('.plot :is(.wide, .narrow)')) {
      await new Promise(done => setTimeout(done));
      if (phone.matches) draw(box);
      box.style.contentVisibility = 'visible';
    }
  });

  // The numbers of a paragraph are one stop, too: from its first the arrows go to the next, over all of the page.
  const numbers = all('data.number');
  const homes = new Set();
  for (const number of numbers) {
    const home = number.closest('p, li, td, th, dd, figcaption');
    number.tabIndex = homes.has(home) ? -1 : 0;
    homes.add(home);
    number.addEventListener('keydown', event => {
      const by = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
      const next = by && numbers[numbers.indexOf(number) + by];
      if (!next) return;
      event.preventDefault();
      next.focus();
    });
  }
})();
