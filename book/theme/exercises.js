// Ticks on the page of all exercises, kept in the browser.
(function () {
  'use strict';
  const read = key => {
    try {
      return JSON.parse(localStorage.getItem(key)) ?? {};
    } catch {
      return {};
    }
  };
  for (const cell of document.querySelectorAll('.tasks .tick')) cell.hidden = false;
  for (const box of document.querySelectorAll('.tasks input')) {
    const judged = read('judged')[box.name];
    if (judged) box.after(` ${judged.score} of ${judged.points}`);
    box.checked = read('done')[box.name] === true;
    box.addEventListener('change', () => {
      const done = { ...read('done'), [box.name]: box.checked };
      try {
        localStorage.setItem('done', JSON.stringify(done));
      } catch {
        // Where nothing can be kept, the tick lasts as long as the page.
      }
    });
  }
})();
