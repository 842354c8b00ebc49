// The steps in a tick that the reader's own spring needs, below the steps in a swing, in each table of the page for the wall.
(function () {
  'use strict';
  const group = document.querySelector('.your-spring');
  const [swings, omega, ticks] = ['swings', 'omega', 'ticks'].map(name => group.querySelector(`[name=${name}]`));
  const output = group.querySelector('output');
  group.hidden = false;

  const tables = [...document.querySelectorAll('.rates')].map(table => {
    const row = table.tBodies[0].insertRow();
    row.className = 'yours';
    row.innerHTML = '<th scope="row">your steps a tick</th>';
    return [...table.querySelectorAll('[data-steps]')].map(({ dataset }) => ({
      steps: Number(dataset.steps),
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

  // As `steps_a_tick` in chapters/wall/rates.h; a test compares the two.
  const stepsATick = (stepsASwing, a, b) => Math.max(1, Math.ceil((stepsASwing * a) / b));

  function show() {
    const [often, rate] = [positive(swings), positive(ticks)];
    const known = often > 0 && rate > 0;
    output.textContent = known
      ? `One step a tick: hω = ${digits((2 * Math.PI * often) / rate, 2)}, ${digits(rate / often, 2)} steps a swing.`
      : 'Give swings and ticks above zero.';
    for (const cells of tables)
      for (const { steps, cell } of cells) {
        const needed = stepsATick(steps, often, rate);
        cell.textContent = known ? written(needed) : '–';
        cell.className = needed === 1 ? 'one' : '';
      }
  }

  swings.addEventListener('input', () => {
    omega.value = digits(2 * Math.PI * positive(swings), 4);
    show();
  });
  omega.addEventListener('input', () => {
    swings.value = digits(positive(omega) / (2 * Math.PI), 4);
    show();
  });
  ticks.addEventListener('input', show);
  show();

  // A link to an answer opens it, and what it stands in.
  function openTarget() {
    const target = document.querySelector(':target');
    for (let e = target?.closest('details'); e; e = e.parentElement.closest('details')) e.open = true;
  }
  addEventListener('hashchange', openTarget);
  openTarget();
})();
