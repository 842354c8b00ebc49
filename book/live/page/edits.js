// Words in the code beside a figure that a click changes, as its controls do.
(function () {
  'use strict';
  const Live = (globalThis.Live ??= {});

  // Puts a button in the place of a whole word of a line.
  function replace(line, word, button) {
    const texts = document.createTreeWalker(line, NodeFilter.SHOW_TEXT);
    while (texts.nextNode()) {
      const text = texts.currentNode;
      const at = text.data.search(new RegExp(`\\b${word}\\b`));
      if (at < 0) continue;
      const found = text.splitText(at);
      found.splitText(word.length);
      return found.replaceWith(button);
    }
    throw new Error(`"${line.textContent}" has no word "${word}"`);
  }

  Live.Edits = class {
    // `edits(values)` lists [what its line begins with, word, what stands in its place, the choice that a click turns].
    constructor(stage, edits, settings, choose) {
      Object.assign(this, { edits, settings });
      const lines = [...stage.querySelectorAll('.line')];
      this.buttons = edits(settings.values).map(([start, word, , name]) => {
        const button = document.createElement('button');
        button.type = 'button';
        button.addEventListener('click', () => choose({ [name]: settings.of(name).next }));
        replace(
          lines.find(line => line.textContent.startsWith(start)),
          word,
          button,
        );
        return button;
      });
    }
    show() {
      this.edits(this.settings.values).forEach(([, word, now, name], i) => {
        const button = this.buttons[i],
          control = this.settings.of(name);
        button.textContent = now;
        button.title = `${control.label}: ${control.words()}`;
        button.classList.toggle('edited', now !== word);
      });
    }
  };
})();
