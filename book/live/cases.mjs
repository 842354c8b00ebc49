// The runs whose bits are compared: every combination of a figure's choices, with its sliders where they stand at first, all
// at their low ends, and all at their high ends; of many combinations, those with one choice changed. What concerns the page
// alone is left out.
import { readDescriptions } from './descriptions.mjs';

const CHAPTERS = new URL('../../chapters/', import.meta.url);
// Steps of a run, with each build, and where there is time.
export const STEPS = 2_000;
export const MANY_STEPS = 20_000; // with the sliders where they stand at first
const MOST = 48; // combinations of a figure that are all tried

export const readFigures = () => readDescriptions(CHAPTERS);

export const casesOfManySteps = () => cases(['start']);

// [{ figure, choices, settings: { name: value } }]
export function cases(ends = ['start', 'from', 'to']) {
  return readFigures().flatMap(({ name, controls }) => {
    const computed = controls.filter(({ page }) => !page);
    return combinations(computed).flatMap(choices =>
      ends.map(end => ({
        figure: name,
        choices,
        settings: { ...choices, ...sliders(computed, end) },
      })),
    );
  });
}

function combinations(controls) {
  const choosing = controls.filter(control => control.choices);
  const all = choosing.reduce((count, { choices }) => count * Object.keys(choices).length, 1);
  return all > MOST ? oneByOne(choosing) : product(choosing);
}

const product = controls =>
  controls.reduce(
    (found, { name, choices }) =>
      found.flatMap(chosen => Object.keys(choices).map(choice => ({ ...chosen, [name]: choice }))),
    [{}],
  );

function oneByOne(controls) {
  const first = Object.fromEntries(controls.map(({ name, start }) => [name, start]));
  const others = controls.flatMap(({ name, choices, start }) =>
    Object.keys(choices)
      .filter(choice => choice !== start)
      .map(choice => ({ ...first, [name]: choice })),
  );
  return [first, ...others];
}

function sliders(controls, end) {
  const value = ({ values, scale = 1, ...control }) =>
    (values && end !== 'start' ? values.at(end === 'from' ? 0 : -1) : control[end]) * scale;
  return Object.fromEntries(
    controls.filter(control => !control.choices).map(control => [control.name, value(control)]),
  );
}

// The line that asks the native program for this run.
export const question = ({ figure, settings }, steps) =>
  `${figure} ${steps} ${Object.entries(settings)
    .map(([name, value]) => `${name}=${value}`)
    .join(' ')}`;
