// Ticks on the page of all exercises, kept in the browser.
(function () {
  'use strict';
  const KEY = 'done';
  const read = () => {
    try {
      return JSON.parse(localStorage.getItem(KEY)) ?? {};
    } catch {
      return {};
    }
  };
  for (const cell of document.querySelectorAll('.tasks .tick')) cell.hidden = false;
  for (const box of document.querySelectorAll('.tasks input')) {
    box.checked = read()[box.name] === true;
    box.addEventListener('change', () => {
      const done = { ...read(), [box.name]: box.checked };
      try {
        localStorage.setItem(KEY, JSON.stringify(done));
      } catch {
        // Where nothing can be kept, the tick lasts as long as the page.
      }
    });
  }
})();
