// What the editor in the page must know of a method's header, besides the lines that it shows.

/**
 * @param text  a header of code/integrate
 * @returns { before, keeps }: the lines that name parts of a step before its first mark "// [move]", and what the method keeps from step
 *   to step besides x and v, if it does; null if its step takes more than that, such as a solver
 */
export function editableOf(text) {
  const lines = text.split('\n');
  const mark = lines.findIndex(line => line.trim() === '// [move]');
  const opened = lines.slice(0, mark).findLastIndex(line => /^ *if constexpr \(/.test(line));
  const signature = lines.slice(0, opened).join(' ').split('template <').at(-1).replace(/\s+/g, ' ');
  const takes = /\bPosition& x, Vec& v, (?:Vec& (\w+), )?Time t, Real h, Acceleration&& acceleration\)/.exec(signature);
  if (!takes || !/constexpr void/.test(signature)) return null;
  const before = lines
    .slice(opened + 1, mark)
    .map(line => line.trim())
    .filter(line => line && !line.startsWith('using Clock'));
  return { before: before.join('\n'), ...(takes[1] && { keeps: takes[1] }) };
}
