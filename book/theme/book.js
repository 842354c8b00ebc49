// What a page of the book can do: light and dark, copying code, showing values. Works from disk, without a server.
(function () {
  'use strict';
  const all = (selector, root = document) => [...root.querySelectorAll(selector)];
  const root = document.documentElement;

  // What a browser forbids to keep lasts for this page.
  function keep(key, value) {
    try {
      if (value === null) localStorage.removeItem(key);
      else localStorage.setItem(key, value);
    } catch {
      /* see above */
    }
  }
  function kept(key) {
    try {
      return localStorage.getItem(key);
    } catch {
      return null;
    }
  }

  function setTheme(theme) {
    if (theme) root.dataset.theme = theme;
    else delete root.dataset.theme;
    keep('theme', theme);
    for (const button of all('.system')) button.hidden = !theme;
    document.dispatchEvent(new Event('themechange'));
  }
  for (const button of all('.theme')) {
    button.addEventListener('click', () => {
      const system = matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light';
      setTheme((root.dataset.theme ?? system) === 'dark' ? 'light' : 'dark');
    });
  }
  for (const button of all('.system')) {
    button.hidden = !root.dataset.theme;
    button.addEventListener('click', () => setTheme(null));
  }

  // A film is a page of its own, and doesn't see what the reader chose here.
  const tellFilms = () => {
    for (const film of all('.film iframe')) film.src = `${film.src.split('#')[0]}#${root.dataset.theme ?? ''}`;
  };
  if (root.dataset.theme) tellFilms();
  document.addEventListener('themechange', tellFilms);

  // Beside the text the menu is always open, which style sheets do in newer browsers.
  if (!CSS.supports('selector(::details-content)'))
    for (const menu of all('.menu')) menu.open = matchMedia('(min-width: 961px)').matches;
  for (const menu of all('.menu'))
    menu.addEventListener('click', ({ target }) => {
      if (target.closest('.within a') && matchMedia('(max-width: 960px)').matches) menu.open = false;
    });

  // Line numbers are drawn by the style sheet, so the text that is copied has none.
  for (const box of all('.listing, .codebox')) {
    const button = document.createElement('button');
    button.type = 'button';
    button.className = 'copy';
    button.textContent = 'Copy';
    button.addEventListener('click', () => {
      copy(codeIn(box.querySelector('pre')));
      button.textContent = 'Copied';
      setTimeout(() => {
        button.textContent = 'Copy';
      }, 1200);
    });
    (box.querySelector('figcaption') ?? box).append(button);
  }

  // Where a change is applied to a listing, the lines that it takes out stand there, too.
  function codeIn(pre) {
    const code = pre.cloneNode(true);
    for (const gone of pre.closest('.listing') ? all('del', code) : []) {
      gone.nextSibling.data = gone.nextSibling.data.replace(/^\n/, '');
      gone.remove();
    }
    return code.textContent;
  }

  function copy(text) {
    if (navigator.clipboard && window.isSecureContext) {
      navigator.clipboard.writeText(text).catch(() => copyBySelection(text));
      return;
    }
    copyBySelection(text);
  }

  function copyBySelection(text) {
    const area = document.createElement('textarea');
    area.value = text;
    area.style.position = 'fixed';
    document.body.append(area);
    area.select();
    document.execCommand('copy');
    area.remove();
  }

  // A formula that is too wide is set smaller. What scrolls sideways all the same fades out where it is cut, and can be
  // reached by keyboard. A page has hundreds of these: some at a time, and all of them read before one is changed, so that nobody waits;
  // and what is folded, when it is opened.
  const scrollers = 'pre, .math-block, .tablescroll';
  const SOME = 24;
  const breath = () => new Promise(done => setTimeout(done));
  const markCut = e => e.classList.toggle('cut', e.scrollWidth - e.clientWidth - e.scrollLeft > 1);
  const tooWide = e => e.scrollWidth > e.clientWidth + 1;
  const scrollersIn = part => all(scrollers, part).filter(e => !e.closest('details:not([open])'));
  function markSome(some) {
    for (const e of some) e.classList.remove('tight');
    for (const e of some.filter(tooWide)) e.classList.add('tight');
    const wide = new Set(some.filter(tooWide));
    for (const e of some) {
      if (wide.has(e)) e.tabIndex = 0;
      else e.removeAttribute('tabindex');
      e.classList.toggle('cut', wide.has(e));
    }
    wide.forEach(markCut);
  }
  let round = 0;
  async function markScrollers() {
    const mine = ++round,
      list = scrollersIn(document);
    for (let i = 0; i < list.length && mine === round; i += SOME) {
      await breath();
      markSome(list.slice(i, i + SOME));
    }
  }
  let marked = document.fonts.ready.then(markScrollers);
  addEventListener('resize', () => {
    marked = markScrollers();
  });
  for (const event of ['toggle', 'shown'])
    document.addEventListener(event, ({ target }) => markSome(scrollersIn(target)), true);
  document.addEventListener(
    'scroll',
    event => {
      if (event.target.matches?.(scrollers)) markCut(event.target);
    },
    { capture: true, passive: true },
  );

  // Where scripts run, a film's last picture only stands behind it.
  for (const picture of all('.film .still')) picture.setAttribute('aria-hidden', 'true');

  // On paper all is open that is printed; on the screen it is again as it was.
  let opened = [];
  addEventListener('beforeprint', () => {
    opened = all('details:not([open])');
    for (const details of opened) details.open = true;
  });
  addEventListener('afterprint', () => {
    for (const details of opened) details.open = false;
  });

  // A page opens where its address says, and goes there again once its live figures run, in case they took more room than was kept for
  // them; but not with a reader who has moved on, or who came back to where they were. From then on it scrolls smoothly.
  const [{ type }] = performance.getEntriesByType('navigation');
  let moved = type === 'reload' || type === 'back_forward';
  for (const means of ['wheel', 'touchstart', 'pointerdown', 'keydown']) {
    addEventListener(
      means,
      () => {
        moved = true;
      },
      { capture: true, passive: true, once: true },
    );
  }
  addEventListener('load', async () => {
    await Promise.allSettled([marked, ...(globalThis.Live?.started ?? [])]);
    const figure = location.hash.match(/^#([\w-]+)\?/)?.[1]; // one with settings, which is no target to the browser
    if (!moved) (document.querySelector(':target') ?? document.getElementById(figure))?.scrollIntoView();
    root.classList.add('arrived');
  });

  // The section in view, at the right, in the menu and in the bar: the last one whose heading has passed the top, at the page's end
  // the last of all. It is where a reader who comes back goes on.
  const links = all('.onpage a, .side .within a');
  const headings = [...new Set(links.map(a => a.hash.slice(1)))].map(id =>
    document.getElementById(decodeURIComponent(id)),
  );
  let shown = null;
  function markSection() {
    const atEnd = scrollY > 0 && scrollY + innerHeight > root.scrollHeight - 2;
    const here =
      headings[atEnd ? headings.length - 1 : headings.findLastIndex(e => e.getBoundingClientRect().top < 120)];
    const link = links.find(a => here && decodeURIComponent(a.hash.slice(1)) === here.id);
    if (link === shown) return;
    shown = link;
    for (const a of links) a.classList.toggle('here', a.hash === link?.hash);
    for (const bar of all('.side .place')) bar.textContent = link?.textContent ?? '';
    if (link && document.body.classList.contains('chapter'))
      keep(
        'place',
        JSON.stringify({ href: `${location.pathname.split('/').at(-1)}${link.hash}`, title: link.textContent }),
      );
  }
  if (links.length) {
    addEventListener('scroll', markSection, { passive: true });
    document.fonts.ready.then(markSection);
  }

  // On the front page, the way back to it.
  function goOn() {
    const { href, title } = JSON.parse(kept('place')) ?? {};
    if (!/^[\w-]+\.html#[\w-]+$/.test(href) || !title) return;
    const line = document.createElement('p');
    line.className = 'go-on';
    const a = document.createElement('a');
    a.href = href;
    a.textContent = title;
    line.append('Go on where you were: ', a);
    document.querySelector('main .lead').after(line);
  }
  if (document.body.classList.contains('index')) goOn();
})();
