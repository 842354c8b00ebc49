// A film with another as its ghost: what a program shows after a change, and faintly behind it what it showed before.

const REEL = /const view = ([^]*?)(?=\n*const colours = )/;

/** @param film, ghost  pages that chapters/play.h writes */
export function withGhost(film, ghost) {
  const [, reel] = ghost.match(REEL) ?? [];
  if (!reel || !REEL.test(film)) throw new Error('no page of a film; play.h writes it in other words now');
  const { pictures, names } = reel.match(/names = (?<names>\[.*?\]), pictures = (?<pictures>[^]*);\s*$/).groups;
  return film.replace(
    'const view = ',
    () => `const ghost = { names: ${names}, pictures: ${pictures} };\nconst view = `,
  );
}
