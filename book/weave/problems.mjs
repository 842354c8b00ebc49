// Every mistake found in one weaving, so that all are told at once.
export function createProblems() {
  const list = [];
  const places = new Map();
  return {
    list,
    // Where the lines of a file came from, if it was put together from several.
    madeOf(file, lines) {
      places.set(file, lines);
    },
    add(madeFile, madeLine, madeMessage) {
      const lines = places.get(madeFile);
      const { file, line } = lines?.[madeLine - 1] ?? { file: madeFile, line: madeLine };
      const message = madeMessage.replace(/\b(of|in) line (\d+)/g, (all, word, n) =>
        lines?.[n - 1] ? `${word} line ${lines[n - 1].line}` : all,
      );
      const known = list.some(p => p.file === file && p.line === line && p.message === message);
      if (!known) list.push({ file, line, message });
    },
    get any() {
      return list.length > 0;
    },
    text() {
      const sorted = [...list].sort((a, b) => a.file.localeCompare(b.file) || a.line - b.line);
      return sorted.map(p => `${p.line ? `${p.file}:${p.line}` : p.file}: ${p.message}\n`).join('');
    },
  };
}

// "did you mean ...?" for a name that nothing bears, or nothing when no known name is near.
export function didYouMean(name, known) {
  const near = [...new Set(known)]
    .map(candidate => ({ candidate, distance: distance(name.toLowerCase(), candidate.toLowerCase()) }))
    .filter(({ candidate, distance }) => distance <= Math.max(2, Math.max(name.length, candidate.length) * 0.4))
    .sort((a, b) => a.distance - b.distance)
    .slice(0, 3)
    .map(({ candidate }) => `"${candidate}"`);
  return near.length ? ` Did you mean ${near.join(' or ')}?` : '';
}

// The same for a short list of names, which is told when none is near.
export function nameOneOf(name, known) {
  const all = [...new Set(known)];
  if (!all.length) return ' There is none yet.';
  return (
    didYouMean(name, all) ||
    ` There is ${all
      .slice(0, 5)
      .map(one => `"${one}"`)
      .join(', ')}${all.length > 5 ? ' and more' : ''}.`
  );
}

function distance(a, b) {
  let row = Array.from({ length: b.length + 1 }, (_, j) => j);
  for (let i = 1; i <= a.length; ++i) {
    const next = [i];
    for (let j = 1; j <= b.length; ++j) {
      next[j] = Math.min(row[j] + 1, next[j - 1] + 1, row[j - 1] + (a[i - 1] === b[j - 1] ? 0 : 1));
    }
    row = next;
  }
  return row[b.length];
}
