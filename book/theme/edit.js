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

  if (!('compiler' in document.documentElement.dataset)) return;
  for (const frame of document.querySelectorAll('.film iframe[data-source]')) {
    const figure = frame.closest('figure');
    const edit = async () => (await globalThis.loadEditing()).film(figure);
    const name = frame.dataset.source.split('/').at(-1);
    figure.querySelector('.sources').append(' ', pressTo('Edit', `Edit ${name}`, edit));
  }
  for (const starter of document.querySelectorAll('.starter[data-exercise]')) {
    const { exercise } = starter.dataset;
    const { id } = starter.closest('.exercise');
    const write = async () => (await globalThis.loadEditing()).exercise(place, exercise, id);
    const place = placeBehind(starter);
    place.append(pressTo('Write it here', `Write it here: ${exercise.split('/').at(-1)}`, write));
  }
  // On the page of a header, and where a method has been picked.
  for (const tried of document.querySelectorAll('[data-try]')) {
    const place = placeBehind(tried);
    const path = tried.dataset.try;
    const open = async () => (await globalThis.loadEditing()).header(place, path);
    place.append(pressTo('Try it', `Try it: ${path.split('/').at(-1)}`, open));
  }
})();
