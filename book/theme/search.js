// Search. The index is fetched with the first key, as a script, since a page on disk can fetch nothing else.
(function () {
  'use strict';
  const box = document.querySelector('.search input');
  const list = document.querySelector('.search ul');
  let index;
  const load = src =>
    new Promise((done, failed) => {
      const script = document.createElement('script');
      script.src = src;
      script.onload = done;
      script.onerror = failed;
      document.head.append(script);
    });
  function openIndex() {
    index ??= Promise.all([load('minisearch.js'), load('search-index.js')]).then(() => {
      const search = new window.MiniSearch({
        fields: ['title', 'text'],
        storeFields: ['title', 'place', 'url', 'text'],
        searchOptions: { boost: { title: 3 }, prefix: true, combineWith: 'AND' },
      });
      search.addAll(window.BOOK_SEARCH);
      return search;
    });
    return index;
  }

  function element(tag, text, className) {
    const e = document.createElement(tag);
    if (text) e.textContent = text;
    if (className) e.className = className;
    return e;
  }

  // A piece of the text around the first word found, with all found words marked
  function excerpt({ text, terms }) {
    const words = terms.filter(term => text.toLowerCase().includes(term));
    const small = element('small');
    if (!words.length) return small;
    const at = Math.max(0, text.toLowerCase().indexOf(words[0]) - 40);
    const start = at ? text.indexOf(' ', at) + 1 : 0;
    const pattern = new RegExp(`(${words.map(w => w.replace(/[^\w\s]/g, '\\$&')).join('|')})`, 'i');
    small.append(at ? '… ' : '');
    const end = text.length <= start + 110 ? text.length : text.lastIndexOf(' ', start + 110);
    text
      .slice(start, end)
      .split(pattern)
      .forEach((part, i) => small.append(i % 2 ? element('mark', part) : part));
    small.append(end < text.length ? ' …' : '');
    return small;
  }

  // What is written as typed comes first; only where nothing is, what is written nearly so.
  function find(search, query) {
    const hits = search.search(query);
    return hits.length ? hits : search.search(query, { fuzzy: term => (term.length > 5 ? 0.15 : 0) });
  }

  async function search() {
    const query = box.value.trim();
    list.hidden = query.length < 2;
    if (list.hidden) {
      list.replaceChildren();
      return;
    }
    const hits = find(await openIndex(), query).slice(0, 12);
    if (query !== box.value.trim()) return;
    list.replaceChildren(
      ...hits.map(hit => {
        const a = element('a');
        a.href = hit.url;
        a.append(element('span', hit.title), hit.place ? element('small', hit.place) : '', excerpt(hit));
        const item = element('li');
        item.append(a);
        return item;
      }),
    );
    if (!hits.length) list.append(element('li', 'Nothing found.', 'none'));
  }

  if (box) {
    box.addEventListener('focus', openIndex, { once: true });
    box.addEventListener('input', search);
    addEventListener('keydown', event => {
      if (event.key === '/' && !/input|textarea/i.test(document.activeElement.tagName)) {
        event.preventDefault();
        box.closest('.side').classList.add('open');
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
