// How long a page takes to read: its words at an even pace, and a minute for each thing to look at. The exercises are not read but done.
const WORDS_A_MINUTE = 200;
const LOOKED_AT = ['figure', 'live', 'table', 'listing', 'display', 'card'];
const READ_AS_A_WORD = ['number', 'math', 'code'];

// All tokens of a page -> whole minutes, to the nearest five.
export function minutesToRead(tokens) {
  const exercises = tokens.findIndex(({ meta: piece }) => piece?.type === 'heading' && piece.text === 'Exercises');
  const read = exercises < 0 ? tokens : tokens.slice(0, exercises);
  const looks = read.filter(
    ({ meta: piece }) => piece && piece.type !== 'close' && LOOKED_AT.includes(piece.name),
  ).length;
  const words = read.reduce((sum, token) => sum + wordsOf(token), 0);
  return Math.round((words / WORDS_A_MINUTE + looks) / 5) * 5;
}

const wordsOf = ({ type, content, meta: piece }) =>
  READ_AS_A_WORD.includes(piece?.name)
    ? 1
    : type === 'text' || piece?.type === 'heading'
      ? (piece?.text ?? content).split(/\s+/).filter(word => /[\p{L}\p{N}]/u.test(word)).length
      : 0;
