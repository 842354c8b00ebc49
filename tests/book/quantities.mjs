// The values that a tick label states, in base units: "10^{-3}", "0.5", "−π/2", "12 000", "10 cm", "1 m, 1 m/s".
const UNITS = {
  'mm': 1e-3,
  'cm': 1e-2,
  'km': 1e3,
  'µm': 1e-6,
  'μm': 1e-6,
  'nm': 1e-9,
  'pm': 1e-12,
  'µs': 1e-6,
  'μs': 1e-6,
  'ns': 1e-9,
  'ms': 1e-3,
  'min': 60,
  'kHz': 1e3,
  'MHz': 1e6,
  'kJ': 1e3,
  'MJ': 1e6,
  'mm/s': 1e-3,
  'cm/s': 1e-2,
  'km/s': 1e3,
  'km/h': 1 / 3.6,
  '%': 0.01,
  '°': Math.PI / 180,
};
const RAISED = { '⁻': '-', '⁰': 0, '¹': 1, '²': 2, '³': 3, '⁴': 4, '⁵': 5, '⁶': 6, '⁷': 7, '⁸': 8, '⁹': 9 };
const QUANTITY = /^([-+]?)(\d+(?:\.\d+)?(?:e[-+]?\d+)?)?(?:[×·](1e[-+]?\d+))?(π)?(?:\/(\d+))?(.*)$/u;

// A label without a number, such as a name, states nothing: [].
export function quantities(label) {
  return label.split(/[,;] /).map(quantity).filter(Boolean);
}

function quantity(written) {
  const plain = written
    .replace(/−/g, '-')
    .replace(/10([⁻⁰¹²³⁴-⁹]+)/g, (_, raised) => `10^{${[...raised].map(c => RAISED[c]).join('')}}`)
    .replace(/10\^\{([-+]?\d+)\}/g, '1e$1')
    .replace(/\s/g, '')
    .replace(/(\d),(?=\d{3}(\D|$))/g, '$1');
  const [, sign, number, power = 1, pi, divisor = 1, unit] = plain.match(QUANTITY);
  if (number === undefined && !pi) return null;
  const factor = UNITS[unit] ?? 1;
  const value = ((Number(number ?? 1) * power * (pi ? Math.PI : 1)) / divisor) * factor;
  return { value: sign === '-' ? -value : value, unit: factor };
}
