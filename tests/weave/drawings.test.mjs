// gnuplot's drawings in fewer letters: nothing that a reader sees is another.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { pathOfDots, pathOfPolygons, shortPath } from '../../book/weave/svg-path.mjs';
import { adoptSvg } from '../../book/weave/svg.mjs';

// The subpaths of a path of relative steps, as lists of points.
function points(d) {
  let [x, y] = [0, 0];
  return d
    .split('m')
    .slice(1)
    .map(part => {
      const numbers = part.match(/-?(?:\d+\.?\d*|\.\d+)/g).map(Number);
      const subpath = [];
      for (let i = 0; i < numbers.length; i += 2) subpath.push([(x += numbers[i]), (y += numbers[i + 1])]);
      if (part.endsWith('z')) [x, y] = subpath[0];
      return subpath;
    });
}
const absolute = list => list.map(([x, y], i) => `${i ? 'L' : 'M'}${x},${y}`).join(' ');

// From a point to the nearest piece of a line.
function away([x, y], line) {
  const pieces = line.slice(1).map((to, i) => [line[i], to]);
  return Math.min(
    ...pieces.map(([[ax, ay], [bx, by]]) => {
      const square = (bx - ax) ** 2 + (by - ay) ** 2;
      const along = square ? Math.max(0, Math.min(1, ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / square)) : 0;
      return Math.hypot(x - ax - along * (bx - ax), y - ay - along * (by - ay));
    }),
  );
}

test('a line in steps goes where the line went, with the points that make its shape', () => {
  const wave = Array.from({ length: 2000 }, (_, i) => [0.3 * i, 100 + 80 * Math.sin(i / 60)]);
  const [drawn] = points(shortPath(absolute(wave)));
  assert.ok(drawn.length < 300, `${drawn.length} points`);
  assert.ok(drawn.length > 50, `${drawn.length} points`);
  for (const point of wave) assert.ok(away(point, drawn) < 0.2, `${point}`);
  assert.deepEqual(drawn.at(-1).map(Math.round), wave.at(-1).map(Math.round));
});

test('a corner stays, a jump stays, a closed line ends where it began, and curves are left alone', () => {
  const near = (got, wanted) =>
    wanted.flat(2).forEach((value, i) => assert.ok(Math.abs(got.flat(2)[i] - value) < 0.051));
  const square = [
    [10, 10],
    [50, 10],
    [50, 50],
    [10, 50],
  ];
  near(
    points(
      shortPath(
        `${absolute(square)} Z ${absolute([
          [5, 5],
          [7, 9],
        ])}`,
      ),
    ),
    [
      square,
      [
        [5, 5],
        [7, 9],
      ],
    ],
  );
  const arc = 'M10,10 A5,5 0 0 1 20,20';
  assert.equal(shortPath(arc), arc);
  near(
    points(
      pathOfDots([
        [1, 2],
        [-3, 4.5],
      ]),
    ),
    [
      [
        [1, 2],
        [1, 2],
      ],
      [
        [-3, 4.5],
        [-3, 4.5],
      ],
    ],
  );
  near(points(pathOfPolygons(['1,1 2,1 2,2', '5,5 6,5 6,6'])), [
    [
      [1, 1],
      [2, 1],
      [2, 2],
    ],
    [
      [5, 5],
      [6, 5],
      [6, 6],
    ],
  ]);
});

const drawing = body =>
  adoptSvg(
    `<svg viewBox="0 0 100 50"><defs><circle id='gpPt5' cx='0' cy='0' r='1'/><use xlink:href='#gpPt5' id='gpPt6'/></defs>${body}</svg>`,
    {
      id: 'figure-x-wide',
      title: 'X',
      description: 'X',
    },
  );
const tip = (x, words) =>
  `<g onmousemove="gnuplot_svg.showHypertext(evt,'${words}')"><title> </title><use xlink:href='#gpPt6' transform='translate(${x},7) scale(2.00)' color='rgb(  0,   0,   1)'/></g>`;

test('points that say something become values, and one path of dots', () => {
  const {
    html,
    points: values,
    shape,
  } = drawing(`<g stroke="currentColor">${tip(3, 'a: -0.0 m')}${tip(9, 'b: -2 m')}</g>`);
  assert.deepEqual(values, [
    { at: [3, 7], says: 'a: 0.0\u202fm' },
    { at: [9, 7], says: 'b: \u22122\u202fm' },
  ]);
  assert.equal(shape, '100/50');
  assert.equal(html.match(/<path/g).length, 1);
  assert.match(html, /d="m3 7 0 0m6 0 0 0" style="stroke:var\(--plot-1\);stroke-width:4.4"/);
  assert.doesNotMatch(html, /onmousemove|data-tip/);
});

test('polygons that run round opposite ways leave no hole where they lie over each other, and see-through ones stay apart', () => {
  const polygon = (list, more = '') => `<polygon ${more}points='${list}' fill='rgb(  0,   0,   2)'/>`;
  const [one, other] = ['0,0 10,0 10,10 0,10', '5,5 5,15 15,15 15,5'];
  const { html } = drawing(polygon(one) + polygon(other));
  const areas = points(html.match(/d="(m[^"]*)"/)[1]).map(list =>
    list.reduce((sum, [x, y], i) => sum + x * list[(i + 1) % list.length][1] - list[(i + 1) % list.length][0] * y, 0),
  );
  assert.equal(areas.length, 2);
  assert.equal(Math.sign(areas[0]), Math.sign(areas[1]));
  const seeThrough = drawing(polygon(one, "fill-opacity='0.5' ") + polygon(other, "fill-opacity='0.5' ")).html;
  assert.equal((seeThrough.match(/<polygon|<path/g) ?? []).length, 2);
});
