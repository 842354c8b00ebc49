// The page to pick a method: one answer open at a time, and in it the steps in a tick that the reader's own spring needs, below the steps in
// a swing. What is open and what was typed stand in the address, so that a reader who comes back finds both again.
(function () {
  'use strict';
  const group = document.querySelector('.your-spring');
  const inputs = ['swings', 'omega', 'ticks'].map(name => group.querySelector(`[name=${name}]`));
  const [swings, omega, ticks] = inputs;
  const output = group.querySelector('output');
  const choices = [...document.querySelectorAll('.choice')];

  const rows = [...document.querySelectorAll('.rates tbody tr')].map(measured => {
    const row = document.createElement('tr');
    row.className = 'yours';
    row.innerHTML = '<th scope="row">your steps a tick</th>';
    measured.after(row);
    return [...measured.querySelectorAll('td')].map(({ dataset }) => ({
      steps: Number(dataset.steps ?? NaN),
      cell: row.insertCell(),
    }));
  });

  const digits = (value, n) => String(Number(value.toPrecision(n)));
  const written = whole => String(whole).replace(/\B(?=(\d{3})+$)/g, whole < 10000 ? '' : '\u202f');
  const positive = input => {
    const value = input.valueAsNumber;
    const good = value > 0 && value < Infinity;
    input.setAttribute('aria-invalid', String(!good));
    return good ? value : NaN;
  };

  // As `steps_a_tick` in chapters/pick-a-method/rates.h; a test compares the two.
  const stepsATick = (stepsASwing, a, b) => Math.max(1, Math.ceil((stepsASwing * a) / b));

  function show() {
    const [often, rate] = [positive(swings), positive(ticks)];
    const known = often > 0 && rate > 0;
    output.textContent = known
      ? `One step a tick: hω = ${digits((2 * Math.PI * often) / rate, 2)}, ${digits(rate / often, 2)} steps a swing.`
      : 'Give swings and ticks above zero.';
    for (const cells of rows)
      for (const { steps, cell } of cells) {
        const needed = stepsATick(steps, often, rate);
        cell.textContent = needed > 0 ? written(needed) : '–';
        cell.className = needed === 1 ? 'one' : '';
      }
  }

  // The innermost answer that is open, and so is all that it stands in.
  const opened = () =>
    choices.filter(choice => choice.open && !choice.parentElement.closest('details:not([open])')).at(-1);

  // What is asked stands where it counts, above the table of the answer that is open.
  function ask() {
    const table = opened()?.querySelector(':scope > div > .take > .rates');
    group.hidden = !table;
    if (table && table.previousElementSibling !== group) table.before(group);
  }

  function remember() {
    const typed = inputs.some(input => input.value !== input.defaultValue);
    const settings = typed ? `?${new URLSearchParams(inputs.map(({ name, value }) => [name, value]))}` : '';
    const choice = opened();
    if (choice) history.replaceState(history.state, '', `#${choice.id}${settings}`);
  }

  const closeBeside = choice => {
    for (const other of choices)
      if (other !== choice && other.parentElement === choice.parentElement) other.open = false;
  };

  // Opens what the address names, and what that stands in.
  function restore() {
    const [, id, settings] = location.hash.match(/^#([\w-]+)(?:\?(.*))?$/) ?? [];
    const typed = new URLSearchParams(settings);
    for (const input of inputs) if (typed.has(input.name)) input.value = typed.get(input.name);
    const target = id && document.getElementById(id);
    for (let e = target?.closest('.choice'); e; e = e.parentElement.closest('.choice')) {
      e.open = true;
      closeBeside(e);
    }
    show();
    ask();
    return target;
  }

  swings.addEventListener('input', () => {
    omega.value = digits(2 * Math.PI * positive(swings), 4);
  });
  omega.addEventListener('input', () => {
    swings.value = digits(positive(omega) / (2 * Math.PI), 4);
  });
  group.addEventListener('input', () => {
    show();
    remember();
  });

  // An answer that a reader opens shuts the one beside it, and comes to the top if it does not fit below.
  let asked;
  for (const choice of choices)
    choice.querySelector('summary').addEventListener('click', () => {
      asked = choice;
      if (!choice.open) closeBeside(choice);
    });
  document.addEventListener(
    'toggle',
    ({ target }) => {
      if (!choices.includes(target)) return;
      ask();
      remember();
      if (target !== asked || !target.open) return;
      const { top, bottom } = target.getBoundingClientRect();
      if (top < 0 || bottom > innerHeight) target.scrollIntoView();
      asked = null;
    },
    true,
  );

  addEventListener('hashchange', () => {
    restore()?.scrollIntoView();
  });
  restore();
})();
