// The search box. The index is fetched with the first key, as a script, since a page on disk can fetch nothing else.
(function () {
  'use strict';
  const box = document.querySelector('.search input');
  const list = document.querySelector('.search ul');
  const status = document.querySelector('.search [role=status]');
  let ready;
  const load = src =>
    new Promise((done, failed) => {
      const script = document.createElement('script');
      script.src = src;
      script.onload = done;
      script.onerror = failed;
      document.head.append(script);
    });
  const getReady = () =>
    (ready ??= Promise.all([load('minisearch.js'), load('search-index.js')]).then(() => load('find.js')));

  function element(tag, text, className) {
    const e = document.createElement(tag);
    if (text) e.textContent = text;
    if (className) e.className = className;
    return e;
  }

  // A piece of the text around the first word found, with all found words marked; its beginning, if they stand in the title
  function excerpt({ text, terms }) {
    const words = terms.filter(term => text.toLowerCase().includes(term));
    const small = element('small');
    const at = words.length ? Math.max(0, text.toLowerCase().indexOf(words[0]) - 40) : 0;
    const start = at ? text.indexOf(' ', at) + 1 : 0;
    const pattern = new RegExp(`(${words.map(w => w.replace(/[^\w\s]/g, '\\$&')).join('|') || '$^'})`, 'i');
    small.append(at ? '… ' : '');
    const end = text.length <= start + 110 ? text.length : text.lastIndexOf(' ', start + 110);
    text
      .slice(start, end)
      .split(pattern)
      .forEach((part, i) => small.append(i % 2 ? element('mark', part) : part));
    small.append(end < text.length ? ' …' : '');
    return small;
  }

  // Where nothing is found, these are near.
  const ELSEWHERE = [
    ['Pick a method', 'pick-a-method.html'],
    ['Glossary', 'glossary.html'],
    ['Snippets', 'snippets.html'],
  ];
  function nothing() {
    const item = element('li', 'Nothing found. Look at ', 'none');
    ELSEWHERE.forEach(([words, href], i) => {
      const a = element('a', words);
      a.href = href;
      item.append(i ? (i < ELSEWHERE.length - 1 ? ', ' : ' or ') : '', a);
    });
    item.append('.');
    return item;
  }

  function itemOf(hit) {
    const a = element('a');
    a.href = hit.url;
    a.append(element('span', hit.title), element('small', hit.place, 'place'), excerpt(hit));
    const item = element('li');
    item.append(a);
    return item;
  }

  async function search() {
    const query = box.value.trim();
    list.hidden = query.length < 2;
    status.textContent = '';
    if (list.hidden) {
      list.replaceChildren();
      return;
    }
    await getReady();
    if (query !== box.value.trim()) return;
    const hits = window.findInBook(query);
    list.replaceChildren(...(hits.length ? hits.map(itemOf) : [nothing()]));
    status.textContent = hits.length
      ? `${hits.length} ${hits.length === 1 ? 'place' : 'places'} found`
      : 'Nothing found';
  }

  // Down and up lead through the hits and back into the box; Enter in the box goes to the first.
  function move(event) {
    const links = [...list.querySelectorAll('a')];
    const at = links.indexOf(document.activeElement);
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (step && links.length && (at >= 0 || step > 0)) {
      event.preventDefault();
      (links[at + step] ?? (step < 0 ? box : links.at(-1))).focus();
    }
    if (event.key === 'Enter' && document.activeElement === box && links.length) {
      event.preventDefault();
      links[0].click();
    }
  }

  if (box) {
    box.addEventListener('focus', getReady, { once: true });
    box.addEventListener('input', search);
    box.closest('.search').addEventListener('keydown', move);
    addEventListener('keydown', event => {
      if (event.key === '/' && !document.activeElement.matches('input, textarea, [contenteditable=true]')) {
        event.preventDefault();
        box.closest('details').open = true;
        box.focus();
      }
      if (event.key === 'Escape' && box.closest('.search').contains(document.activeElement)) {
        box.value = '';
        search();
        box.focus();
      }
    });
  }
})();
