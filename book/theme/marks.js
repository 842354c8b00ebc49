// Check marks stand in the margin, each on the line that its sentence ends on, those of one line side by side; and a mark and its
// sentence are lit together.
(function () {
  'use strict';
  const marks = [...document.querySelectorAll('main :is(p, li) .claim')];
  if (!marks.length) return;

  // What is folded is placed when it is opened.
  function place() {
    const counts = new Map();
    const seen = marks.filter(mark => !mark.closest('details:not([open])'));
    const boxes = seen.map(mark => mark.getBoundingClientRect()); // all, before one is moved
    seen.forEach((mark, i) => {
      const { top, height } = boxes[i];
      const line = height ? Math.round((top + scrollY) / 6) : null;
      mark.style.setProperty('--of-line', counts.get(line) ?? 0);
      counts.set(line, (counts.get(line) ?? 0) + 1);
    });
  }
  addEventListener('resize', place);
  document.fonts.ready.then(place);
  document.addEventListener('toggle', place, true);

  if (!globalThis.CSS?.highlights) return;
  const lit = new Highlight();
  CSS.highlights.set('claimed', lit);

  // From the end of the sentence before, or the mark before, to the mark.
  const sentences = new Map();
  function sentenceOf(mark) {
    if (!sentences.has(mark)) sentences.set(mark, sentenceBefore(mark));
    return sentences.get(mark);
  }
  function sentenceBefore(mark) {
    const home = mark.closest('p, li');
    const range = document.createRange();
    range.setStart(home, 0);
    const before = marks[marks.indexOf(mark) - 1];
    if (before && home.contains(before)) range.setStartAfter(before);
    range.setEndBefore(mark);
    const walker = document.createTreeWalker(range.commonAncestorContainer, NodeFilter.SHOW_TEXT);
    const texts = [];
    for (let node = walker.nextNode(); node; node = walker.nextNode()) if (range.intersectsNode(node)) texts.push(node);
    // A full stop that another word follows ends a sentence; the last of them counts.
    for (const node of texts.reverse()) {
      const ends = [...node.data.matchAll(/[.?!:][”’)]?\s+(?=\S)/g)];
      const end = ends.at(-1);
      const at = end && end.index + end[0].length;
      if (end && range.comparePoint(node, at) === 0) {
        range.setStart(node, at);
        break;
      }
    }
    return range;
  }

  let shown;
  function light(mark) {
    if (mark === shown) return;
    shown?.classList.remove('lit');
    lit.clear();
    shown = mark;
    if (!mark) return;
    mark.classList.add('lit');
    lit.add(sentenceOf(mark));
  }

  // The mark whose sentence lies under the mouse.
  function markAt({ target, clientX, clientY }) {
    const mark = target.closest?.('.claim');
    const home = target.closest?.('main :is(p, li)');
    if (mark || !home) return mark;
    return marks
      .filter(one => home.contains(one))
      .find(one =>
        [...sentenceOf(one).getClientRects()].some(
          ({ left, right, top, bottom }) => clientX >= left && clientX <= right && clientY >= top && clientY <= bottom,
        ),
      );
  }
  document.addEventListener('pointermove', event => light(markAt(event)), { passive: true });
  document.addEventListener('focusin', ({ target }) => light(target.closest('.claim')));
})();
