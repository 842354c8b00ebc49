// "Change it": a press shows what the changed program does. The build has compiled and run it; the page only shows it, here and
// where the program stands: its listings with the changed lines, what it prints, and its film with the old one as a ghost.
(function () {
  'use strict';
  const all = (selector, root = document) => [...root.querySelectorAll(selector)];
  const element = (name, className, ...content) => {
    const made = document.createElement(name);
    if (className) made.className = className;
    made.append(...content);
    return made;
  };
  const link = (to, words) => {
    const a = element('a', '', words);
    a.href = `#${to.id}`;
    return a;
  };
  const press = (words, act) => {
    const button = element('button', 'apply', words);
    button.type = 'button';
    button.addEventListener('click', act);
    return button;
  };

  function name(button, words, title) {
    button.textContent = words;
    button.setAttribute('aria-label', `${words}: ${title}`);
  }

  const applied = new Map(); // program -> { button, undo } of the change that is shown

  function takeBack(program) {
    const change = applied.get(program);
    applied.delete(program);
    for (const undo of change?.undo ?? []) undo();
    document.body.dispatchEvent(new Event('shown'));
  }

  // Puts `made` in the place of `old`, and gives what takes it back.
  function exchange(old, made) {
    old.replaceWith(made);
    return () => made.replaceWith(old);
  }
  function put(made, after) {
    after.after(made);
    return () => made.remove();
  }

  function filmOf(old, box, title) {
    const film = old.cloneNode(true);
    for (const still of all('.still', film)) still.remove();
    const frame = film.querySelector('iframe');
    frame.src = `${box.dataset.film}#${document.documentElement.dataset.theme ?? ''}`;
    frame.title = title;
    return film;
  }

  function apply(box, button) {
    const { program } = box.dataset;
    takeBack(program);
    const title = box.querySelector('.label').firstChild.textContent;
    const undo = [];
    const say = after => {
      const back = press(
        'Take it back',
        () => (takeBack(program), after.closest('figure')?.querySelector('a')?.focus()),
      );
      undo.push(put(element('p', 'changed', 'Changed: ', link(box, title), '. ', back), after));
    };
    const places = [];
    box.querySelector('details').open = true;
    const film = document.querySelector(`.film:has([data-program="${program}"])`);
    undo.push(put(filmOf(film, box, title), all('.diff', box).at(-1)));
    const shown = filmOf(film, box, title);
    undo.push(exchange(film, shown));
    say(shown);
    places.push(shown.closest('figure'));
    for (const template of all('template', box)) {
      const listing = document.getElementById(template.dataset.for);
      const code = element('code');
      code.append(template.content.cloneNode(true));
      undo.push(exchange(listing.querySelector('code'), code));
      say(listing.querySelector('pre'));
      places.push(listing);
    }
    const prints = box.querySelector('.codebox:not(.diff) code').cloneNode(true);
    for (const old of all(`[data-printed-by="${program}"]`)) {
      undo.push(exchange(old.querySelector('code'), prints.cloneNode(true)));
      say(old.querySelector('pre'));
    }
    undo.push(put(whereElse(places), all('.film', box).at(-1)));
    name(button, 'Take it back', title);
    undo.push(() => name(button, 'Apply', title));
    applied.set(program, { button, undo: undo.reverse() });
    for (const place of [box, ...places]) place.dispatchEvent(new Event('shown'));
  }

  function whereElse(places) {
    const links = places.map(place =>
      link(place, place.querySelector('figcaption').textContent.match(/(Figure|Listing) [\d.]*\d/)[0]),
    );
    const listed = links.flatMap((a, i) => [i === 0 ? '' : i === links.length - 1 ? ' and ' : ', ', a]);
    const words = [...listed, links.length === 1 ? ' shows' : ' show', ' the changed program, too. The faint picture is the program as it was.']; // prettier-ignore
    const line = element('p', 'where', ...words);
    line.setAttribute('role', 'status');
    return line;
  }

  // A guess comes first: what a change does is folded until it is applied, or until somebody wants to know.
  function foldOutcome(box) {
    const outcome = element('div');
    const last = all('.diff', box).at(-1);
    while (last.nextElementSibling?.matches(':not(template)')) outcome.append(last.nextElementSibling);
    const fold = element('details', '', element('summary', '', 'What it does'), outcome);
    last.after(fold);
  }

  for (const box of all('.change[data-film]')) {
    foldOutcome(box);
    const button = press('Apply', () => {
      if (applied.get(box.dataset.program)?.button === button) takeBack(box.dataset.program);
      else apply(box, button);
    });
    name(button, 'Apply', box.querySelector('.label').textContent);
    box.querySelector('.label').append(button);
  }
})();
