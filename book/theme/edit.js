// The button Edit of a film, where the book has a compiler for the page: nothing of it is loaded before it is pressed.
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

  if (!('compiler' in document.documentElement.dataset)) return;
  for (const frame of document.querySelectorAll('.film iframe[data-source]')) {
    const figure = frame.closest('figure');
    const button = document.createElement('button');
    Object.assign(button, { type: 'button', className: 'edit', textContent: 'Edit' });
    button.setAttribute('aria-label', `Edit ${frame.dataset.source.split('/').at(-1)}`);
    button.addEventListener('click', async () => (await globalThis.loadEditing()).film(figure));
    figure.querySelector('.sources').append(' ', button);
  }
})();
