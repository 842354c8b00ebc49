// The few lines that the weaver says when all went well.
import { bareCaptions, captions } from './captions.mjs';

export function stopwatch() {
  const parts = [];
  const watch = (name, work) => {
    const from = performance.now();
    const result = work();
    parts.push([name, (performance.now() - from) / 1000]);
    return result;
  };
  watch.parts = parts;
  return watch;
}

export function summary(book, pages, watch) {
  const rows = [...book.chapters.values()].map(({ page, name, numbers, tests }) => {
    const all = mark => page.pieces.filter(p => p.name === mark && p.type !== 'close');
    const count = mark => all(mark).length;
    const different = mark => new Set(all(mark).map(p => p.args[0])).size;
    return [
      name,
      page.words,
      count('figure'),
      count('listing'),
      `${different('claim')} of ${tests.length}`,
      `${different('number')} of ${numbers.size}`,
      count('exercise'),
      page.tasks.size,
    ];
  });
  const times = watch.parts.map(([name, seconds]) => `${name} ${seconds.toFixed(2)} s`).join(', ');
  const all = watch.parts.reduce((sum, [, seconds]) => sum + seconds, 0);
  return [
    ...table([['chapter', 'words', 'figures', 'listings', 'claims', 'numbers', 'exercises', 'graded'], ...rows]),
    `${bareCaptions(book).length} of ${captions(book).length} captions have neither \\number nor \\claim nor \\look (at most ${book.config.bareCaptions ?? 0} may)`,
    `${pages.length} pages woven in ${all.toFixed(2)} s: ${times}`,
    `open ${book.config.output}/index.html`,
  ].join('\n');
}

function table(rows) {
  const widths = rows[0].map((_, i) => Math.max(...rows.map(row => String(row[i]).length)));
  return rows.map(row =>
    row
      .map((cell, i) => (i ? String(cell).padStart(widths[i]) : String(cell).padEnd(widths[i])))
      .join('  ')
      .trimEnd(),
  );
}
