// One method's part of the stability map of chapter 7, and the frames of small pictures beside each other.
(function () {
  'use strict';
  const Live = (globalThis.Live ??= {});
  const WIDEST = 4, // of h omega
    TALLEST = 2; // of zeta

  // From parts of a frame to the picture.
  Live.frame = function (pen, { left, low, width, high }, chosen = false) {
    pen.frame([left, left + width], [low, low + high], {
      colour: chosen ? 'ink' : 'context',
      width: chosen ? 1.6 : 0.8,
    });
    return { x: share => left + width * share, y: share => low + high * share };
  };

  // The spring at a place of the map, as parts of its width and height, under so many steps a second.
  Live.springAt = (right, up, rate) => ({ omega: right * WIDEST * rate, zeta: up * TALLEST });

  // Where the method with this label is stable and, darker, where it is true to life; `columns` are those of the table "map". Nobody
  // has drawn the map of a method that is `changed`.
  Live.map = function (pen, { x, y }, columns, { label, colour, changed }, spring) {
    const find = words => Object.entries(columns).find(([column]) => column.toLowerCase() === words.toLowerCase())[1];
    const heights = columns.ζ.map(zeta => y(zeta / TALLEST));
    const parts = [
      [label, 0.22],
      [`${label} true`, 0.6],
    ];
    for (const [words, faint] of changed ? [] : parts) {
      const limits = find(words);
      const edge = limits.map(limit => x(limit / WIDEST));
      pen.area([x(0), ...edge, x(0)], [y(0), ...heights, y(1)], { colour, faint });
    }
    if (changed) pen.text(x(0.5), y(0.85), 'no map', { size: 11 });
    const at = [x(Math.min(1, spring.homega / WIDEST)), y(Math.min(1, spring.zeta / TALLEST))];
    pen.dot(...at, 5, 'paper');
    pen.dot(...at, 3.5);
  };
})();
