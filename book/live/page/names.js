// What the lines of a chart are called, at their ends.
(function () {
  'use strict';
  const Live = (globalThis.Live ??= {});
  const APART = 18; // of two names that would lie on each other [px]

  // `ends` are { x, y, words, colour }. A name stands above its line's end, or below if it would lie on another line there; of two
  // that would meet the lower one gives way.
  Live.nameLines = function ({ ctx, bbox }, ends, box) {
    const pixel = devicePixelRatio;
    const names = [...new Map(ends.map(end => [end.words, end])).values()].sort((a, b) => a.y - b.y);
    const isCrossed = at => ends.some(({ y }) => Math.abs(y - at) < 6 * pixel);
    let free = bbox.top + 8 * pixel;
    for (const name of names) {
      const above = name.y - 9 * pixel;
      name.at = Math.max(isCrossed(above) ? name.y + 9 * pixel : above, free);
      free = name.at + APART * pixel;
    }
    let floor = bbox.top + bbox.height - 8 * pixel;
    for (const name of names.reverse()) {
      name.at = Math.min(name.at, floor);
      floor = name.at - APART * pixel;
    }
    ctx.save();
    Object.assign(ctx, {
      font: `500 ${12 * pixel}px "Book Sans", sans-serif`,
      textAlign: 'right',
      textBaseline: 'middle',
      lineJoin: 'round',
      lineWidth: 4 * pixel,
      strokeStyle: Live.colour(box, 'paper'),
    });
    for (const { x, at, words, colour } of names) {
      ctx.strokeText(words, x - 4 * pixel, at);
      ctx.fillStyle = colour;
      ctx.fillText(words, x - 4 * pixel, at);
    }
    ctx.restore();
  };
})();
