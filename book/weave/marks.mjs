// The book's own marks: how many arguments each takes (least, most), and what it is.
//   inline  stands within a sentence;  block  stands alone;  box  stands alone and ends with \end...
export const MARKS = {
  number: { takes: [1, 1], kind: 'inline', usage: '\\number{name}' },
  claim: { takes: [1, 1], kind: 'inline', usage: '\\claim{name of a test}', whole: true },
  tested: { takes: [1, 1], kind: 'inline', usage: '\\tested{name of a test}', whole: true },
  look: { takes: [0, 0], kind: 'inline', usage: '\\look' },
  set: { takes: [2, 2], kind: 'inline', usage: '\\set{live-figure?control=value, words}' },
  figref: { takes: [1, 1], kind: 'inline', usage: '\\figref{name}' },
  eqref: { takes: [1, 1], kind: 'inline', usage: '\\eqref{name}' },
  tabref: { takes: [1, 1], kind: 'inline', usage: '\\tabref{name}' },
  lstref: { takes: [2, 2], kind: 'inline', usage: '\\lstref{path, tag}' },
  citep: { takes: [1, 9], kind: 'inline', usage: '\\citep{key}' },
  chapterref: { takes: [1, 1], kind: 'inline', usage: '\\chapterref{2-euler}' },
  sectionref: { takes: [2, 2], kind: 'inline', usage: '\\sectionref{2-euler, name-of-section}' },
  minutes: { takes: [1, 1], kind: 'inline', usage: '\\minutes{2-euler}' },
  graded: { takes: [1, 1], kind: 'inline', usage: '\\graded{2-euler}' },
  exerciseref: { takes: [1, 1], kind: 'inline', usage: '\\exerciseref{name}' },
  ref: { takes: [1, 1], kind: 'inline', usage: '\\ref name, of something in code/, with its namespace' },
  term: { takes: [1, 1], kind: 'inline', usage: '\\term{a word of the glossary}' },
  bibitem: { takes: [2, 2], kind: 'inline', usage: '\\bibitem{key, Author year}' },
  listing: { takes: [2, 3], kind: 'block', usage: '\\listing{path, tag} or \\listing{path, tag, Caption}' },
  rows: { takes: [1, 1], kind: 'block', usage: '\\rows{table}' },
  sketch: { takes: [2, 2], kind: 'block', usage: '\\sketch{table, Caption}' },
  card: { takes: [1, 1], kind: 'block', usage: '\\card{function}' },
  rate: { takes: [0, 0], kind: 'block', usage: '\\rate' },
  take: { takes: [3, 3], kind: 'block', usage: '\\take{function, tag of the lines, Name}' },
  contents: { takes: [0, 0], kind: 'block', usage: '\\contents' },
  outline: { takes: [0, 0], kind: 'block', usage: '\\outline' },
  figure: { takes: [2, 2], kind: 'box', usage: '\\figure{name, Title}' },
  live: { takes: [2, 2], kind: 'box', usage: '\\live{name, Title}' },
  film: { takes: [2, 2], kind: 'box', usage: '\\film{play, Title}' },
  change: { takes: [1, 1], kind: 'box', usage: '\\change{What to change}' },
  paper: { takes: [0, 0], kind: 'box', within: 'live', usage: '\\paper' },
  screen: { takes: [0, 0], kind: 'box', within: 'live', usage: '\\screen' },
  table: { takes: [1, 1], kind: 'box', usage: '\\table{name}' },
  eq: { takes: [1, 1], kind: 'box', usage: '\\eq{name}' },
  task: { takes: [1, 1], kind: 'block', usage: '\\task{name} on a line of its own, in a chapter' },
  exercise: { takes: [2, 2], kind: 'box', usage: '\\exercise{name, Title}' },
  hint: { takes: [0, 0], kind: 'box', within: 'exercise', usage: '\\hint' },
  answer: { takes: [0, 0], kind: 'box', within: 'exercise', usage: '\\answer' },
  choice: { takes: [2, 2], kind: 'box', usage: '\\choice{name, What the reader answers}' },
  pause: { takes: [0, 0], kind: 'block', usage: '\\pause, near the middle of a chapter' },
  goals: { takes: [0, 0], kind: 'box', usage: '\\goals' },
  lead: { takes: [0, 0], kind: 'box', usage: '\\lead' },
  rest: { takes: [1, 1], kind: 'box', usage: '\\rest{The whole program}' },
  aside: { takes: [0, 0], kind: 'box', usage: '\\aside' },
  remark: { takes: [0, 0], kind: 'box', usage: '\\remark' },
  takehome: { takes: [0, 0], kind: 'box', usage: '\\takehome' },
};

export const NUMBERED = { figure: 'Figure', eq: 'equation', table: 'Table', listing: 'Listing', exercise: 'Exercise' };
export const REFERS = { figref: 'figure', eqref: 'eq', tabref: 'table', exerciseref: 'exercise' };

// "{a, b, the rest, with commas}" -> at most `most` arguments; the last one keeps its commas.
export function splitArguments(text, { takes: [, most], whole }) {
  if (whole || most === 1) return [text];
  const parts = text.split(',').map(part => part.trim());
  return parts.length <= most ? parts : [...parts.slice(0, most - 1), parts.slice(most - 1).join(', ')];
}
