// Two texts as one, line by line, with the signs of a diff.

/** @returns [{ text, sign }, ...]: what both have in its order, and between it what goes (-) and what comes (+) */
export function mergeLines(before, after) {
  const [m, n] = [before.length, after.length];
  const common = Array.from({ length: m + 1 }, () => new Array(n + 1).fill(0)); // lines that the rest has in common
  for (let i = m - 1; i >= 0; --i)
    for (let k = n - 1; k >= 0; --k)
      common[i][k] = before[i] === after[k] ? common[i + 1][k + 1] + 1 : Math.max(common[i + 1][k], common[i][k + 1]);
  const merged = [];
  let i = 0,
    k = 0;
  while (i < m || k < n) {
    if (i < m && k < n && before[i] === after[k]) (merged.push({ text: before[i++], sign: ' ' }), ++k);
    else if (k === n || (i < m && common[i + 1][k] >= common[i][k + 1])) merged.push({ text: before[i++], sign: '-' });
    else merged.push({ text: after[k++], sign: '+' });
  }
  return merged;
}
