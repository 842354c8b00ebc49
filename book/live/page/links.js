// What sets a figure from outside its stage: the address of the page, and words in the prose.
(function () {
  'use strict';
  const Live = (globalThis.Live ??= {});

  Live.Links = class {
    // `figure` has an element, a stage, a query and read(query), set(values) before it runs and choose(values) from then on.
    constructor(figure) {
      const { element, stage } = figure;
      Object.assign(this, { id: element.id, figure });
      if (this.asked !== undefined) figure.set(figure.read(this.asked));
      addEventListener('hashchange', () => {
        if (this.asked === undefined || !figure.run) return;
        figure.choose(figure.read(this.asked));
        element.scrollIntoView();
      });
      document.addEventListener('click', event => {
        const words = event.target.closest?.(`a.set[href="#${this.id}"]`);
        if (!words || !figure.run) return;
        event.preventDefault();
        figure.choose(figure.read(words.dataset.set));
        stage.scrollIntoView({ block: 'nearest' });
      });
      stage.querySelector('[data-do=link]').addEventListener('click', event => this.copy(event.target));
    }
    // The settings that the address has for this figure.
    get asked() {
      const [, id, query] = location.hash.match(/^#([\w-]+)\?(.*)$/) ?? [];
      return id === this.id ? query : undefined;
    }

    // A step that somebody has written, and the method in whose place: { own, code }.
    get brought() {
      const given = new URLSearchParams(this.asked);
      return given.has('code') ? Object.fromEntries(given) : null;
    }

    copy(button) {
      history.replaceState(null, '', `#${this.id}?${this.figure.query}`);
      const say = words => {
        button.textContent = words;
        setTimeout(() => {
          button.textContent = 'Link to these settings';
        }, 2500);
      };
      const written =
        globalThis.isSecureContext && navigator.clipboard
          ? navigator.clipboard.writeText(location.href)
          : Promise.reject();
      written.then(
        () => say('Link copied'),
        () => say('The link is in the address bar'),
      );
    }
  };
})();
