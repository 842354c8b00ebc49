// Numbers as the book writes them.
(function () {
  'use strict';
  const Live = (globalThis.Live ??= {});
  const raised = digits =>
    digits.replace(/\d|-/g, sign => '\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079'[sign] ?? '\u207b');

  // With so many digits in all, and no more than it takes.
  Live.digits = (value, most) => String(Number(value.toPrecision(most))).replace('-', '\u2212');
  // With so many digits behind the point; what is huge as a power of ten.
  Live.fixed = function (value, digits) {
    if (Math.abs(value) >= 1e6) {
      const [mantissa, power] = value.toExponential(1).split('e+');
      return `${mantissa.replace('-', '\u2212')} \u00d7 10${raised(power)}`;
    }
    const [whole, ...rest] = Math.abs(value).toFixed(digits).split('.');
    const text = [whole.length > 4 ? whole.replace(/\B(?=(\d{3})+$)/g, '\u202f') : whole, ...rest].join('.');
    return value < 0 && /[1-9]/.test(text) ? `\u2212${text}` : text;
  };
  Live.metres = function (value) {
    const [size, unit] = [
      [1, 'm'],
      [1e-2, 'cm'],
      [1e-3, 'mm'],
      [1e-6, 'µm'],
    ].find(([size]) => value >= size) ?? [1e-9, 'nm'];
    const number = value / size;
    return `${number < 9.95 ? number.toPrecision(2) : Live.fixed(number, 0)}\u202f${unit}`;
  };
})();
