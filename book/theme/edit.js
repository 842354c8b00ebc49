// The buttons Edit of a film and Write it here of an exercise, where the book has a compiler for the page: nothing of it is loaded
// before one is pressed.
(function () {
  'use strict';
  let loading;

  // What a page needs to edit, loaded when somebody wants to.
  globalThis.loadEditing = () =>
    (loading ??= new Promise((done, failed) => {
      const script = document.createElement('script');
      Object.assign(script, { src: 'compiler/editor.js', onload: () => done(globalThis.Editing), onerror: failed });
      document.head.append(script);
    }));

  const pressTo = (words, label, act) => {
    const button = document.createElement('button');
    Object.assign(button, { type: 'button', className: 'edit', textContent: words });
    button.setAttribute('aria-label', label);
    button.addEventListener('click', act);
    return button;
  };

  const placeBehind = element => {
    const place = document.createElement('p');
    place.className = 'write-here';
    element.after(place);
    return place;
  };

  // What is kept of an exercise (compiler/page/kept-code.js, progress.js): the words to press, and how it was judged last.
  function begun(exercise, id) {
    try {
      const judged = JSON.parse(localStorage.getItem('judged'))?.[id];
      const words = localStorage.getItem(`code ${exercise}`) === null ? 'Write it here' : 'Go on writing';
      return [words, judged ? ` ${judged.score} of ${judged.points} points` : ''];
    } catch {
      return ['Write it here', ''];
    }
  }

  // A film and the program that a link brings for it, as film-editor.js has packed it.
  const [, broughtFor, program] = location.hash.match(/^#([\w-]+)\?program=([\w-]+)$/) ?? [];

  function welcome(figure) {
    for (let fold = figure; (fold = fold.closest('details:not([open])'));) fold.open = true;
    const notice = document.createElement('small');
    notice.textContent = ' This link brings a program of its own, which runs once you press Edit.';
    figure.querySelector('.sources').append(notice);
    figure.scrollIntoView();
  }

  if (!('compiler' in document.documentElement.dataset)) return;
  for (const frame of document.querySelectorAll('.film iframe[data-source]')) {
    const figure = frame.closest('figure');
    // A change that is applied there is taken back: the program that opens is the book's.
    const edit = async () => {
      figure.querySelector('.changed .apply')?.click();
      (await globalThis.loadEditing()).film(figure, figure.id === broughtFor ? program : null);
    };
    const name = frame.dataset.source.split('/').at(-1);
    figure.querySelector('.sources').append(' ', pressTo('Edit', `Edit ${name}`, edit));
    if (figure.id === broughtFor) welcome(figure);
  }
  for (const starter of document.querySelectorAll('.starter[data-exercise]')) {
    const { exercise } = starter.dataset;
    const { id } = starter.closest('.exercise');
    const write = async () => (await globalThis.loadEditing()).exercise(place, exercise, id);
    const place = placeBehind(starter);
    const [words, judged] = begun(exercise, id);
    place.append(pressTo(words, `${words}: ${exercise.split('/').at(-1)}`, write), judged);
  }
  // On the page of a header, and where a method has been picked.
  for (const tried of document.querySelectorAll('[data-try]')) {
    const place = placeBehind(tried);
    const path = tried.dataset.try;
    const open = async () => (await globalThis.loadEditing()).header(place, path);
    place.append(pressTo('Try it', `Try it: ${path.split('/').at(-1)}`, open));
  }
})();
