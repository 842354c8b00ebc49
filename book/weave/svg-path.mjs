// The lines of a drawing in few letters: of gnuplot's points those that a reader can tell apart, as steps from one to the next.

const TENTHS = 10; // the grid on which points lie, in parts of a unit
const UNSEEN = 0.8; // how far a point may lie beside the line that leaves it out, in tenths

// d: of M, L and Z alone, which is what gnuplot draws with; what has other letters stays as it is.
export function shortPath(d) {
  const subpaths = readPath(d);
  return subpaths ? writePath(subpaths) : d;
}

// polygons: the points attributes of some of one colour.
export const pathOfPolygons = polygons => writePath(polygons.map(points => ({ points: onGrid(points), closed: true })));

// Of circles of one size that are filled, the middles [x, y]: lines of no length, whose round ends are the circles.
export const pathOfDots = middles =>
  writePath(middles.map(middle => ({ points: [middle.map(tenths), middle.map(tenths)] })));

const tenths = number => Math.round(number * TENTHS);

function onGrid(text) {
  const numbers = (text.match(/-?[\d.]+(?:e-?\d+)?/g) ?? []).map(Number).map(tenths);
  return Array.from({ length: numbers.length / 2 }, (_, i) => [numbers[2 * i], numbers[2 * i + 1]]);
}

function readPath(d) {
  if (!/^\s*M/.test(d) || /[^MLZz\d\s.,eE-]/.test(d)) return null;
  return d
    .split('M')
    .slice(1)
    .map(part => ({ points: withoutUnseen(onGrid(part), UNSEEN), closed: /z\s*$/i.test(part) }));
}

// Without the points that lie less than `unseen` beside the line that leaves them out. Douglas and Peucker's way (1973), with a list in
// place of calls within calls: some lines have thousands of points.
export function withoutUnseen(points, unseen) {
  const kept = new Set([0, points.length - 1]);
  const open = [[0, points.length - 1]];
  while (open.length) {
    const [from, to] = open.pop();
    let far = unseen,
      at = 0;
    for (let i = from + 1; i < to; ++i) {
      const off = distance(points[i], points[from], points[to]);
      if (off > far) [far, at] = [off, i];
    }
    if (!at) continue;
    kept.add(at);
    open.push([from, at], [at, to]);
  }
  return points.filter((_, i) => kept.has(i));
}

// From a point to the piece of line between two others.
function distance([x, y], [ax, ay], [bx, by]) {
  const [dx, dy] = [bx - ax, by - ay],
    square = dx * dx + dy * dy;
  const along = square ? Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / square)) : 0;
  return Math.hypot(x - ax - along * dx, y - ay - along * dy);
}

function writePath(subpaths) {
  let [x, y] = [0, 0];
  const step = ([toX, toY]) => {
    const written = `${short(toX - x)} ${short(toY - y)}`;
    [x, y] = [toX, toY];
    return written;
  };
  return subpaths
    .map(({ points: [first, ...rest], closed }) => {
      const written = `m${[first, ...rest].map(step).join(' ')}${closed ? 'z' : ''}`;
      if (closed) [x, y] = first;
      return written;
    })
    .join('')
    .replace(/ -/g, '-');
}

const short = number => String(number / TENTHS).replace(/^(-?)0\./, '$1.');
