// The index of the snippets: every method with what its card says, side by side, and the file to take.
import { stepping, steps, value } from './cards.mjs';
import { aboutTimes, isTime, recordedHtml } from './measured-times.mjs';
import { CHIPMUNK_OPERATOR, RAYLIB_OPERATOR, headerList } from './header-pages.mjs';
import { onShelf } from './namespaces.mjs';
import { brief } from './reference-entries.mjs';
import { escapeHtml, slug } from './text.mjs';

// Of each column: the words over it, those beside the value on a phone, the value.
const COLUMNS = [
  [
    'alone',
    'order',
    row => `${row('order', 1)}${row('order-velocity', 1) === row('order', 1) ? '' : `, ${row('order-velocity', 1)}`}`,
  ],
  ['with drag', 'order with drag', row => row('drag-order', 1)],
  ['', 'evaluations', row => row('evaluations')],
  ['', 'ns a step', row => row('time')],
  ['drag, <i>ch</i>', 'drag: <i>ch</i> up to', row => row('drag-limit')],
  ['spring, <i>hω</i>', 'spring: <i>hω</i> up to', row => row('spring-limit')],
  ['<i>ζ</i> = 0.1', 'with <i>ζ</i> = 0.1 up to', row => row('spring-limit-0.1')],
  ['<i>ζ</i> = 1', 'with <i>ζ</i> = 1 up to', row => row('spring-limit-1')],
  ['', 'energy of a spring', row => row('energy') + howMuch(row)],
];

const HEAD = `<thead>
<tr><th scope="col" rowspan="2">Method</th><th scope="colgroup" colspan="2">Order</th><th scope="col" rowspan="2">Evalu­ations</th><th scope="col" rowspan="2"><abbr title="nanoseconds a step">ns</abbr></th><th scope="colgroup" colspan="4">Stable up to</th><th scope="col" rowspan="2">Energy</th></tr>
<tr>${COLUMNS.filter(([head]) => head)
  .map(([head]) => `<th scope="col">${head}</th>`)
  .join('')}</tr>
</thead>`;

const LEAD = `<p class="lead">Code to copy: things that a game needs, and every method of the book, one header each. The name leads to its page, with all its lines, an example and
all that was measured of it.</p>
<p>Each header stands alone, is MIT-0, and works with the vectors that you have. GCC 12 and 14 and Clang 14 and 19 compile it, as C++17, 20 and 23, and MinGW’s GCC for Windows; MSVC was not tried.</p>`;

const EXCEPTIONS = `<details class="more"><summary>Your vectors, floats, and what needs a word</summary><div>
<p>Tried were raylib, glm, Eigen, Unreal’s <code>FVector</code>, Godot’s <code>Vector3</code>, Chipmunk’s <code>cpVect</code>, ODE’s <code>dVector3</code>, a register of four floats as DirectXMath has them, <code>std::valarray</code>,
<code>std::experimental::simd</code>, and plain structs; those of engines by stubs that have their operators. A few need a word:</p>
<ul>
<li>raylib lacks one operator: <code>${RAYLIB_OPERATOR}</code> Put it where <code>Vector3</code> is, in no namespace of your own, or the headers don’t find it. Chipmunk lacks the same: <code>${CHIPMUNK_OPERATOR}</code></li>
<li>ODE’s <code>dVector3</code> is an array, and no function returns an array. Keep a struct of three <code>dReal</code> with the two operators: fill it from the numbers that
<code>dBodyGetPosition</code> and <code>dBodyGetLinearVel</code> point to, take the step, and give them back by <code>dBodySetPosition</code> and <code>dBodySetLinearVel</code>.</li>
<li>A function with overloads, like glm’s <code>dot</code>, is handed over in a lambda: <code>[](auto a, auto b) { return glm::dot(a, b); }</code></li>
<li>All numbers of a call are of one type, but for the time. With vectors of floats write <code>1 / 60.0f</code>, and take the steps of a <code>shelf::FixedStep&lt;float&gt;</code>: its <code>h</code> is a float and its time stays in double, or
the steps would be uneven after an hour (<code>fixed_step.h</code>).</li>
<li>A thing that flies, and that nothing but gravity moves, takes <code>constant_acceleration.h</code>, which is exact there. What pulls it
back to a place takes <code>velocity_verlet.h</code> or <code>symplectic_euler.h</code>.
<i>Pick a method</i> asks what else there is.</li>
<li>Columns of an Eigen matrix, and <code>Map</code>s, are copied out, moved and copied back: <code>Vector3f x = X.col(i), v = V.col(i);</code>, then the step, then
<code>X.col(i) = x; V.col(i) = v;</code></li>
<li>The headers are standard C++ but for one attribute, which only clang is shown.</li>
<li>Where two machines have to agree to the last bit, let MinGW optimise: without <code>-O</code> it calls a square root of its own, whose last bit is now and then another.</li>
<li>What comes to rest under drag passes through numbers so small that some processors take many times as long for each step. Put to sleep what rests, or take such
numbers for zero, once in each thread: <code>_MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON)</code> and <code>_MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON)</code>, from
<code>xmmintrin.h</code> and <code>pmmintrin.h</code>.</li>
</ul></div></details>`;

const METHODS = `<h2 id="methods">Methods</h2>
<p>All of this is measured when the book is built, but for the times, which were recorded.</p>
<details class="more"><summary>How to read the tables</summary><div>
<p>The order is that of the position; where the velocity has another, it stands behind. Evaluations
of the acceleration are counted per step, and the nanoseconds are those of one body on an orbit, each step waiting for the one before. A step of <i>h</i> seconds explodes above its limit: on drag, where the speed falls at the rate <i>c</i>, and
on a spring that swings with <i>ω</i>, without a damper and with the damping ratio <i>ζ</i>. The last column is what becomes of the energy of an undamped
spring, in steps of <i>hω</i> = 0.1: “kept” stands beside how far it strays at most, “grows” and “falls” beside what one step adds or takes. Limits are rounded down.</p>
<p>On a page, “on poses, order 2” is for who moves a thing and turns it in one go: <code>x</code> is then a place with a quaternion, and <code>v</code> a velocity with a spin.
Turns don’t commute, and that costs most methods their order.</p>
<p>A mass <i>m</i> on one spring of stiffness <i>k</i> swings with <i>ω</i> = √(<i>k</i>/<i>m</i>). In a rope of many, count with 2√(<i>k</i>/<i>m</i>), that of
its shortest wave. All of this holds for forces that are linear. A rope that swings explodes under the trapezoid rule with one solve, whatever its row says,
and one that is struck hard gains some energy under backward Euler with one solve.</p>
<p>The headers work under the macros of <code>windows.h</code>. Under <code>-ffast-math</code> they take the same steps but for rounding, and <code>dopri5_adaptive</code>
and the three linear systems still refuse what is not finite. Newton’s methods leave that to the solve: one that you write by hand has to refuse it too. The game’s
clock, <code>FixedStep</code>, makes no promise there about a frame whose length is not a number.</p>
</div></details>`;

function howMuch(row) {
  const [off, step] = [row('energy-off'), row('energy-step')];
  if (off !== NONE) return ` <small>off by ${off}</small>`;
  const size = row('energy') === 'falls' ? step.replace(/^(\D*)−/, '$1') : step;
  return step === NONE ? '' : ` <small>${size} a step</small>`;
}

const THINGS = `<h2 id="things">Things that a game needs</h2>
<p>Each is a function or two over your own types, and no engine: one body at a time. On its page stands an example, and what it promises beside what was measured of each promise; one that
is not kept stops the build. A rounding is 2<sup>−52</sup> of what is named, or 2<sup>−23</sup> in float.</p>`;

const LEFT_OUT = `<h2 id="left-out">What is left out</h2>
<p>Many bodies that rest on each other want a solver for all their contacts. Look at those of Box2D and Jolt, and at Erin Catto’s <i>Iterative Dynamics with Temporal Coherence</i>
(2005), from which most of them come. A crate that comes to rest on its side is here, a stack of crates is not. What friction in a cone asks of such a solver is in Stewart and Trinkle’s <i>An Implicit Time-Stepping Scheme for
Rigid Body Dynamics</i> (1996). For soft bodies whose stiffness is that of a material, there are finite elements: Sifakis and Barbič, <i>FEM Simulation of 3D Deformable
Solids</i> (2012). For those that only have to look right, and fast, projective dynamics: Bouaziz and others, <i>Projective Dynamics</i> (2014).</p>`;

const NONE = '–';

// The headers that a text names, each with a link to its page.
const withLinks = (text, headers) =>
  text.replace(/<code>(\w+\.h)<\/code>/g, (code, name) => {
    const found = headers.find(header => header.name === name);
    return found ? `<a href="${found.href}">${code}</a>` : code;
  });

// Each function that steps with what its card says, one table for each kind of thing that they are for.
export function snippetsPage(book) {
  const members = new Map(stepping(book.api).map(member => [member.name, member]));
  const cards = [...book.cards.values()].filter(({ name }) => members.has(name));
  const kinds = [...new Set(cards.map(card => card.suits))].map(kind => ({
    id: `for-${slug(kind)}`,
    title: `For ${kind}`,
    cards: cards.filter(card => card.suits === kind),
  }));
  const tables = kinds.map(
    ({ id, title, cards: own }) =>
      `<h2 id="${id}">${escapeHtml(title)}</h2>\n<table class="methods">${HEAD}` +
      `<tbody>\n${own.map(card => methodRow(book, card, members.get(card.name))).join('\n')}\n</tbody></table>`,
  );
  const headers = [...book.api.headers.values()];
  const shelf = headers.filter(onShelf).sort((a, b) => a.name.localeCompare(b.name, 'en'));
  const things = shelf.length ? [THINGS, headerList(book, shelf)] : [];
  const beside = headers.filter(header => !onShelf(header) && !header.functions.some(steps));
  const systems = { id: 'linear-systems', title: 'Linear systems for the implicit methods' };
  if (beside.length) tables.push(`<h2 id="${systems.id}">${systems.title}</h2>\n${headerList(book, beside)}`);
  const timed = aboutTimes(
    book.times,
    cards.flatMap(card => card.rows.filter(({ name }) => name === 'time').map(({ measured }) => measured)),
  );
  return {
    href: 'snippets.html',
    title: 'Snippets',
    kind: 'snippets',
    body: [LEAD, ...things, METHODS, ...tables, timed, withLinks(EXCEPTIONS, headers), LEFT_OUT].join('\n'),
    sections: [],
  };
}

function methodRow(book, card, member) {
  const row = (name, shown) => {
    const found = card.rows.find(r => r.name === name);
    if (!found) return NONE;
    return isTime(found.measured) ? recordedHtml(book.times, found.measured) : value(found, shown);
  };
  const file = member.file.replace(/.*\//, '');
  const cells = COLUMNS.map(([, words, cell]) => `<td><span class="head">${words}</span> ${cell(row)}</td>`);
  return (
    `<tr><th scope="row"><a href="${member.href}"><code>${escapeHtml(member.name)}</code></a> ` +
    `<span>${brief(book, member)} <a href="headers/${file}" download>file</a></span></th>${cells.join('')}</tr>`
  );
}
