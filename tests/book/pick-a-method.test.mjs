// The page to pick a method: each way through its answers ends in a method that is what the answers ask for, and in the steps
// that it needs; with a mouse, a finger, a keyboard, without scripts and on paper.   node tests/book/pick-a-method.test.mjs build SOURCE
import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { readRecords } from '../../book/weave/csv.mjs';
import { accessibility } from './accessibility.mjs';
import { build, folder, parse } from './book.mjs';
import { addressOf, openTab, pageOf, visit } from './browser.mjs';
import { inspect } from './inspect.mjs';

const phone = await openTab('dark');
const desk = await openTab();
// Loaded anew, where only what stands behind the # would change.
async function afresh(tab, address) {
  await tab.goto('about:blank');
  await visit(tab, address);
}
const source = process.argv[3] ?? '.';
const page = 'pick-a-method.html';
const $ = parse(page);
const text = e => $(e).text().replace(/\s+/g, ' ').trim();

// What the methods say of themselves: { function, spring_limit, symplectic, ... }.
const methods = readRecords(join(build, 'cards/register/methods.csv'));

// What was measured of it: { drag-limit: 'any step', ... }
const cardOf = name =>
  Object.fromEntries(readRecords(join(folder, 'data/cards', `${name}.csv`)).map(row => [row.name, row.measured]));

// Each end of a way: the answers that lead there, the method, all that stands there.
const ends = $('.choice:has(> div > .take)')
  .get()
  .map(choice => {
    const answers = [choice, ...$(choice).parents('.choice').get()].reverse().map(e => text($(e).children('summary')));
    const name = $(choice).find('.take').attr('data-function');
    return {
      id: $(choice).attr('id'),
      way: answers.join(' > '),
      name,
      method: methods.find(m => m.function === name),
      card: cardOf(name),
      says: text(choice),
      headers: $(choice)
        .find('.method a[download]')
        .map((_, a) => $(a).attr('href'))
        .get(),
      code: $(choice).find('pre').text(),
      // Rows of the table: steps a swing, and for some a turn of an orbit.
      rows: $(choice)
        .find('.rates tbody tr')
        .get()
        .map(row =>
          $(row)
            .find('[data-steps]')
            .get()
            .map(cell => Number($(cell).attr('data-steps'))),
        ),
    };
  });

// What an answer, or a word at its end, asks of the method there.
const RULES = [
  [/known force.*constant/i, ({ method }) => method.free_fall_after_ten_steps === '50'],
  [
    /known force.*drag/i,
    ({ card }) => card['drag-limit'] === 'any step' && Number(card['terminal-speed']).toFixed(6) === '1.000000',
  ],
  [
    /known force.*spring/i,
    ({ card }) => card.order === 'exact' && card['drag-order'] === 'exact' && card['spring-limit'] === 'any step',
  ],
  [/touches.*switch/i, ({ card, method }) => card.evaluations === '1' && !(Number(method.order) > 2)],
  [
    /touches.*damper/i,
    ({ card }) => card['drag-limit'] === 'any step' && Number(card['terminal-speed']).toFixed(6) === '1.000000',
  ],
  [/touches.*nothing brakes/i, ({ method }) => method.symplectic === 'yes' && method.spring_limit === '2'],
  [
    /for ever/i,
    ({ card, method }) => method.symplectic === 'yes' && method.reversible === 'yes' && card.energy === 'kept',
  ],
  [/where it is counts/i, ({ method }) => Number(method.order) >= 4],
  [
    /watches/i,
    ({ method, name }) => name === 'dopri5_adaptive' || (Number(method.order) >= 4 && Number(method.drag_order) >= 4),
  ],
  [
    /more steps than I can pay/i,
    ({ card }) => card['spring-limit'] === 'any step' && card['drag-limit'] === 'any step',
  ],
  [
    /bears any step|Any step holds/,
    ({ card }) => card['spring-limit'] === 'any step' && card['drag-limit'] === 'any step',
  ],
];

test('the answers have ends, and each end a rule of its own', () => {
  assert.ok(ends.length >= 13, `${ends.length} ends`);
  for (const [words] of RULES)
    assert.ok(
      ends.some(({ way, says }) => words.test(way + says)),
      `nothing says ${words}`,
    );
  for (const { way } of ends)
    assert.ok(
      RULES.some(([words]) => words.test(way)),
      `no rule for ${way}`,
    );
  assert.equal($('.take').length, ends.length);
});

for (const end of ends) {
  test(`${end.way}: ${end.name}`, () => {
    for (const [words, holds] of RULES)
      if (words.test(`${end.way} ${end.says}`)) assert.ok(holds(end), `${words} leads to ${end.name}`);
    for (const header of end.headers) assert.ok(existsSync(join(folder, header)), `${header} is not there`);
    assert.ok(end.method || end.name === 'dopri5_adaptive', `${end.name} is in no list of methods`);
    const calls = [...end.code.matchAll(/integrate::(\w+)\(/g)].map(([, called]) => called);
    if (calls.length) {
      assert.ok(calls.includes(end.name), `the lines call ${calls}`);
      if (end.method) assert.equal(end.headers[0].split('/').at(-1), end.method.header);
    } else {
      assert.match(end.way, /between two bodies|linear drag/); // no header does that, and none is to be copied
      assert.deepEqual(end.headers, []);
    }
    for (const header of end.headers)
      assert.ok(end.code.includes(`#include "${header.split('/').at(-1)}"`), `${header} in the lines`);
    const counted = !/nothing else|tolerance|constraints/i.test(end.way);
    const orbits = /for ever/.test(end.way) ? [3, 3] : [];
    assert.deepEqual(
      end.rows.map(row => row.length),
      counted ? [4, ...orbits] : [],
    );
    for (const row of end.rows) for (const [i, steps] of row.entries()) assert.ok(steps >= (row[i - 1] ?? 0));
    // The longer the ellipse, the more steps
    for (const [i, row] of end.rows.entries())
      if (i > 0) for (const [k, steps] of row.entries()) assert.ok(steps > end.rows[i - 1].at(k - 3));
  });
}

test('lines that stand before the first tick say so', () => {
  for (const { id, code } of ends) {
    const lines = code.split('\n');
    for (const [i, line] of lines.entries())
      if (/_start\(|_path\(|SparseSystem|FixedStep/.test(line))
        assert.ok(
          lines
            .slice(0, i + 1)
            .some((before, k) => /\/\/ once/.test(before) && (k === i || !/^for/.test(lines[k + 1]))),
          `${id}: ${line}`,
        );
  }
});

test('what an answer is for stands in it before it is opened', () => {
  for (const e of $('.choice:has(.choice) > summary').get()) assert.match(text(e), /: \w+.*, \w+/);
});

test('the limits are those of the traits, twice over', () => {
  for (const {
    name,
    method,
    rows: [steps],
  } of ends.filter(end => end.rows.length)) {
    if (method?.spring_limit === 'always') assert.equal(steps[0], 0, name);
    else if (/^[\d.]+$/.test(method?.spring_limit ?? '')) {
      const least = (4 * Math.PI) / Number(method.spring_limit);
      assert.ok(
        steps[0] >= least && steps[0] < 1.25 * least,
        `${name}: ${steps[0]} steps to stand, and ${least} by its limit`,
      );
    }
  }
});

test('method, rate and lines in three taps from the start page, on a phone', async () => {
  for (const { id, headers } of ends) {
    await visit(phone, 'index.html');
    const door = phone.locator('main a[href="pick-a-method.html"]').first();
    assert.ok((await door.boundingBox()).y + 20 < 664, 'the door is on the first screen, below the browser’s own bars');
    await door.tap();
    await phone.waitForURL(url => url.pathname.endsWith(page), { waitUntil: 'load' });
    const end = phone.locator(`#${id}`);
    await phone.locator(`.choice:has(> div > #${id}) > summary`).tap();
    await end.locator('> summary').tap();
    for (const part of ['.method strong', ...(headers.length ? ['.method a[download]'] : []), 'pre'])
      assert.ok(await end.locator(part).first().isVisible(), part);
    if (await end.locator('.rates').count()) assert.match(await end.locator('.yours').first().innerText(), /\d/);
    await phone.evaluate(() => document.fonts.ready.then(() => {})); // or they are given up when the tab goes on
    assert.deepEqual(phone.faults, []);
  }
});

test('its old address leads there', async () => {
  await desk.goto(addressOf('wall.html'));
  await desk.waitForURL(url => url.pathname.endsWith(page));
});

test('the menu leads there from every page', async () => {
  await visit(desk, 'glossary.html');
  await desk.locator('nav.side a[href="pick-a-method.html"]').click();
  await desk.waitForLoadState('load');
  assert.equal(pageOf(desk), page);
});

test('with all open nothing is cut off or out of reach of a screen reader', async () => {
  for (const tab of [desk, phone]) {
    await visit(tab, page);
    await tab.evaluate(() => document.querySelectorAll('main details').forEach(e => (e.open = true)));
    assert.deepEqual([...tab.faults, ...(await tab.evaluate(inspect))], []);
    assert.deepEqual(await accessibility(tab), []);
  }
});

test('by keyboard alone: two answers, swings, ticks, and the lines on the clipboard', async () => {
  await visit(desk, page);
  await desk.locator('#content').evaluate(e => {
    e.tabIndex = -1;
    e.focus();
  });
  const focused = () =>
    desk.evaluate(() => document.activeElement.getAttribute('name') ?? document.activeElement.textContent.trim());
  const tabTo = async wanted => {
    for (let i = 0; i < 60; ++i) {
      await desk.keyboard.press('Tab');
      if ((await focused()) === wanted) return;
    }
    assert.fail(`no way to ${wanted}`);
  };
  await tabTo(text('#watched > summary'));
  await desk.keyboard.press('Enter');
  await tabTo(text('#closely > summary'));
  await desk.keyboard.press('Space');
  await desk.locator('#closely .your-spring').waitFor();
  await tabTo('swings');
  await desk.keyboard.press('Control+A');
  await desk.keyboard.type('10');
  await tabTo('ticks');
  await desk.keyboard.press('Control+A');
  await desk.keyboard.type('30');
  const end = ends.find(({ id }) => id === 'closely');
  const cells = await desk.locator('#closely .yours td').allInnerTexts();
  assert.deepEqual(
    cells.map(Number),
    end.rows[0].map(steps => Math.max(1, Math.ceil(steps / 3))),
  );
  await tabTo('Copy');
  await desk.keyboard.press('Enter');
  await desk.locator('#closely button', { hasText: 'Copied' }).waitFor();
  assert.equal((await desk.evaluate(() => navigator.clipboard.readText())).trim(), end.code.trim());
});

test('the steps a tick are those that the program works out', async () => {
  await visit(desk, page);
  const rows = readRecords(join(build, 'chapters/pick-a-method/data/shown.csv'));
  assert.ok(rows.length >= 20);
  await desk.evaluate(() => document.querySelectorAll('main details').forEach(e => (e.open = true)));
  for (const row of rows) {
    await desk.locator('[name=swings]').fill(row.swings);
    await desk.locator('[name=ticks]').fill(row.ticks);
    for (const { id } of ends.filter(end => end.name === row.function && end.rows.length)) {
      const cells = await desk.locator(`#${id} .yours`).first().locator('td').allInnerTexts();
      const wanted = ['stands', 'to 10 %', 'to 1 %', 'to 0.1 %'].map(column => Number(row[column]));
      assert.deepEqual(
        cells.map(cell => Number(cell.replace(/\u202f/g, ''))),
        wanted,
        `${row.function} at ${row.swings} and ${row.ticks}`,
      );
    }
  }
});

test('omega and swings follow each other, and nonsense gets no number', async () => {
  await visit(desk, `${page}#place`);
  const [swings, omega] = ['swings', 'omega'].map(name => desk.locator(`[name=${name}]`));
  await omega.fill('62.83');
  assert.equal(Number(await swings.inputValue()).toFixed(2), '10.00');
  await swings.fill('1');
  assert.equal(await omega.inputValue(), '6.283');
  for (const bad of ['', '0', '-3']) {
    await swings.fill(bad);
    assert.equal(await swings.getAttribute('aria-invalid'), 'true');
    assert.match(await desk.locator('.yours td').first().textContent(), /^–$/);
  }
});

test('a link to an end opens it, also from the page itself', async () => {
  for (const { id } of ends) {
    await afresh(desk, `${page}#${id}`);
    assert.ok(await desk.locator(`#${id} pre`).isVisible(), id);
  }
  await afresh(desk, `${page}#undamped`);
  await desk.locator('#undamped a[href$="#uneven"]').click();
  await desk.locator('#uneven pre').waitFor();
  assert.ok(await desk.locator('#touches pre').first().isHidden());
});

test('an orbit is given its own steps in a tick', async () => {
  await afresh(desk, `${page}#place`);
  await desk.locator('[name=swings]').fill('2');
  const [, circle] = ends.find(({ id }) => id === 'place').rows;
  const cells = await desk.locator('#place .yours').nth(1).locator('td').allInnerTexts();
  assert.deepEqual(cells, ['–', ...circle.map(steps => String(Math.ceil(steps / 30)))]);
});

test('swings and ticks are asked for where they count', async () => {
  await afresh(phone, page);
  const group = phone.locator('.your-spring');
  assert.ok(await group.isHidden());
  for (const { id, rows } of ends) {
    const outer = phone.locator(`.choice:has(> div > #${id})`);
    if ((await outer.getAttribute('open')) === null) await outer.locator('> summary').tap();
    await phone.locator(`#${id} > summary`).tap();
    await phone.locator(`#${id} pre`).waitFor();
    await phone.waitForFunction(
      shown => document.querySelector('.your-spring').checkVisibility() === shown,
      rows.length > 0,
    );
    assert.equal(await phone.locator(`#${id} .your-spring`).count(), rows.length ? 1 : 0);
  }
});

test('one answer is open at a time, and what a reader opens comes into sight', async () => {
  await afresh(phone, page);
  for (const id of ['touches', 'stiff', 'for-ever']) {
    const summary = phone.locator(`#${id} > summary`);
    // As low on the screen as it can be
    await summary.evaluate(e => scrollBy(0, e.getBoundingClientRect().bottom - innerHeight));
    await summary.tap();
    await phone.waitForFunction(name => {
      const { top, bottom } = document.getElementById(name).getBoundingClientRect();
      return top >= 0 && (bottom <= innerHeight || top < 60);
    }, id);
    assert.deepEqual(await phone.locator('.choice[open]').evaluateAll(all => all.map(e => e.id)), [id]);
  }
});

test('who comes back finds the answer open, and swings and ticks as they were typed', async () => {
  await afresh(desk, page);
  await desk.locator('#watched > summary').click();
  await desk.locator('#closely > summary').click();
  await desk.locator('[name=omega]').fill('123.4');
  await desk.locator('[name=ticks]').fill('30');
  const cells = await desk.locator('#closely .yours td').allInnerTexts();
  const address = desk.url();
  assert.match(address, /#closely\?/);
  await desk.locator('#closely .method > a').first().click();
  await desk.waitForLoadState('load');
  assert.notEqual(pageOf(desk), page);
  await desk.goBack();
  const fresh = await openTab();
  await fresh.goto(address);
  for (const tab of [desk, fresh]) {
    assert.equal(await tab.locator('[name=omega]').inputValue(), '123.4');
    assert.ok(await tab.locator('#closely pre').isVisible());
    assert.deepEqual(await tab.locator('#closely .yours td').allInnerTexts(), cells);
  }
});

test('closed it is two and a half screens of a phone, and what is tapped is 24 pixels high', async () => {
  await afresh(phone, page);
  const screens = await phone.evaluate(() => document.documentElement.scrollHeight / innerHeight);
  assert.ok(screens <= 2.5, `${screens} screens`);
  await phone.evaluate(() => document.querySelectorAll('main details').forEach(e => (e.open = true)));
  const small = await phone.evaluate(() => {
    const hit = (e, x, y) => document.elementFromPoint(x, y)?.closest('a, summary, button') === e;
    return [...document.querySelectorAll('.claim, .method a, .choice summary')]
      .filter(e => {
        e.scrollIntoView({ block: 'center' });
        const { left, right, top, bottom } = e.getBoundingClientRect();
        const [x, y] = [(left + right) / 2, (top + bottom) / 2];
        return !hit(e, x, y - 11) || !hit(e, x, y + 11);
      })
      .map(e => e.outerHTML.slice(0, 90));
  });
  assert.deepEqual(small, []);
});

test('without scripts the answers fold out all the same, and the steps a swing are there', async () => {
  const plain = await openTab('light', { javaScriptEnabled: false });
  await plain.goto(addressOf(page));
  assert.ok(await plain.locator('.your-spring').isHidden());
  for (const { id, rows } of ends) {
    const outer = plain.locator(`.choice:has(> div > #${id})`);
    if ((await outer.getAttribute('open')) === null) await outer.locator('> summary').click();
    await plain.locator(`#${id} > summary`).click();
    assert.ok(await plain.locator(`#${id} pre`).isVisible(), id);
    assert.equal(await plain.locator(`#${id} [data-steps]:visible`).count(), rows.flat().length);
  }
});

test('the page prints on one sheet, all open, and is then as it was', async () => {
  for (const more of [{}, { javaScriptEnabled: false }]) {
    const printer = await openTab('light', more);
    await printer.goto(addressOf(page), { waitUntil: 'load' });
    const pdf = await printer.pdf({ preferCSSPageSize: true });
    assert.equal(pdf.toString('latin1').match(/\/Type\s*\/Page\b/g).length, 1, JSON.stringify(more));
    if (more.javaScriptEnabled === false) {
      await printer.emulateMedia({ media: 'print' });
      for (const { id } of ends)
        assert.ok((await printer.locator(`#${id} pre`).boundingBox())?.height > 10, `${id} is not printed`);
    } else assert.equal(await printer.locator('details[open]').count(), 0);
  }
});

test('whoever picks rope, crate, bounce, camera, wheel or joint is led to the header that has it', () => {
  const wanted = {
    'links': 'link',
    'touches': ['bounce', 'orientation', 'contact'],
    'between': 'damper',
    'spring': 'smooth-damp',
    'one-stiff': 'soft-constraint',
    'uneven': 'fixed-step',
  };
  for (const [id, headers] of Object.entries(wanted))
    for (const header of [headers].flat())
      assert.ok($(`#${id} > div > p a[href="shelf-${header}.html"]`).length, `${id} does not lead to ${header}`);
  assert.equal($('#net a[href="#links"]').length, 1);
});
