// The three rooms of the code, in the order in which the book's reference shows them.
export const NAMESPACES = [
  { name: 'integrate', title: 'Methods', about: 'The methods, one per header. Each header stands alone and can be copied into any project.' },
  { name: 'scenes', title: 'Scenes', about: 'What is integrated: an acceleration and a start, with the exact solution or what the motion conserves.' },
  { name: 'measure', title: 'Measurements', about: 'What the book asks of a method on a scene: error, order, energy, cost and stability.' },
];
