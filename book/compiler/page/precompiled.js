// What the build precompiles for programs in the page. The second and the third go on where the first ends.

/** What a program includes that no other name is better for. */
export const STANDARD = 'standard.pch';
/** The same for a film, as long as its reader has changed nothing of what draws it. */
export const FILM = 'film.pch';
/** The same for an exercise that is judged. */
export const EXERCISE = 'exercise.pch';

/** The header of each that goes on where the first ends: its name, and what it is. */
export const ABOVE = {
  [FILM]: { header: 'film.h', text: '#pragma once\n#include "chapters/play.h"\n' },
  [EXERCISE]: { header: 'exercise.h', text: '#pragma once\n#define GRADING\n#include "given.h"\n' },
};

/** Those that a program has whose arguments these are: the first one, and the one above. */
export function precompiledFor(args) {
  const named = args[args.indexOf('-include-pch') + 1];
  return named in ABOVE ? [STANDARD, named] : [STANDARD];
}

/** The texts of their headers, which the compiler wants to see, too. */
export const headersOf = (names, standard) =>
  Object.fromEntries(
    names.map(name => (name === STANDARD ? ['standard.h', standard] : [ABOVE[name].header, ABOVE[name].text])),
  );
