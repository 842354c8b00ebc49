// How long a page takes: its words at an even pace, and some minutes for each thing to look at, to play with or to try. The exercises come
// on top.
const WORDS_A_MINUTE = 200;
const LONG = 20; // lines of a listing
const READ_AS_A_WORD = ['number', 'math', 'code'];
const MINUTES = {
  figure: ({ live }) => (live ? 5 : 1),
  listing: ({ snippet }) => (snippet?.lines.length > LONG ? 3 : 1),
  change: () => 4,
  table: () => 1,
  display: () => 1,
  card: () => 1,
};

// All tokens of a page -> whole minutes, to the nearest five.
export function minutesToRead(tokens) {
  const exercises = tokens.findIndex(({ meta: piece }) => piece?.type === 'heading' && piece.text === 'Exercises');
  const read = exercises < 0 ? tokens : tokens.slice(0, exercises);
  const looks = read.reduce(
    (sum, { meta: piece }) => sum + (piece && piece.type !== 'close' ? (MINUTES[piece.name]?.(piece) ?? 0) : 0),
    0,
  );
  const words = read.reduce((sum, token) => sum + wordsOf(token), 0);
  return Math.round((words / WORDS_A_MINUTE + looks) / 5) * 5;
}

const wordsOf = ({ type, content, meta: piece }) =>
  READ_AS_A_WORD.includes(piece?.name)
    ? 1
    : type === 'text' || piece?.type === 'heading'
      ? (piece?.text ?? content).split(/\s+/).filter(word => /[\p{L}\p{N}]/u.test(word)).length
      : 0;
