// What a reader has done, kept in the browser for the page of all exercises (theme/exercises.js).

function change(key, id, value) {
  try {
    const all = JSON.parse(localStorage.getItem(key)) ?? {};
    localStorage.setItem(key, JSON.stringify({ ...all, [id]: value }));
  } catch {
    // Where nothing can be kept, it lasts as long as the page.
  }
}

/** @param id  of the exercise's section */
export function noteReport(id, { score, points }) {
  change('judged', id, { score, points });
  if (score === points) change('done', id, true);
}
