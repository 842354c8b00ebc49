// The prose of a page, Markdown with the book's marks, formulas and boxes: read by markdown-it with a plugin for these.
import MarkdownIt from 'markdown-it';
import { findLeftovers } from './leftovers.mjs';
import { BLOCK_PIECES, codeSpan, comment, dollars, image, tag } from './markdown.mjs';
import { tableRule } from './markdown-tables.mjs';
import { MARKS } from './marks.mjs';
import { readMark } from './read-mark.mjs';
import { linesBefore } from './text.mjs';

// Returns the tokens of markdown-it; a mark is a token that has its piece as `meta`. `report` is told the line and what is wrong.
export function parseProse(source, report) {
  return markdown.parse(source, { report, lines: source.split('\n') });
}

// Every token of a page, in the order in which they are read.
export const allTokens = tokens => tokens.flatMap(token => [token, ...(token.children ?? [])]);

function bookPlugin(md) {
  const ENDS = { alt: ['paragraph', 'blockquote', 'list'] };
  md.block.ruler.before('table', 'marks', blockMarks, ENDS);
  md.block.ruler.before('lheading', 'rows', tableRule, ENDS);
  md.inline.ruler.after('text', 'marks', inlineMark);
  md.core.ruler.at('inline', sentences);
  md.disable(['table', 'reference', 'text_join']);
  md.linkify.set({ fuzzyLink: false, fuzzyEmail: false });
  md.inline.State = inLines(md.inline.State);
}

const lineOf = ({ src, pos, env }) => env.line + linesBefore(src, pos);

// Within a sentence as among blocks, a token knows its line.
function inLines(State) {
  const located = (token, line) => Object.assign(token, { map: [line - 1, line] });
  return class extends State {
    push(...about) {
      return located(super.push(...about), lineOf(this));
    }
    pushPending() {
      return located(super.pushPending(), lineOf(this));
    }
  };
}

function sentences({ tokens, md, env }) {
  let map;
  tokens.forEach((token, i) => {
    map = token.map ?? map;
    const [line] = map ?? [0];
    const report = (message, at = line + 1) => env.report(at, message);
    const piece = BLOCK_PIECES[token.type]?.(token, tokens[i + 1], { lines: env.lines, report });
    if (piece) token.meta = { ...piece, line: line + 1 };
    if (token.type !== 'inline' || tokens[i - 1].type === 'heading_open') return;
    md.inline.parse(token.content, md, Object.assign(env, { line: line + 1 }), token.children);
    findLeftovers(token.children, env.report);
  });
}

const IN_SENTENCES = [comment, image, tag, dollars, codeSpan, readMark];

function inlineMark(state, silent) {
  const { src: source, pos, env } = state;
  if (!'\\@`<!$'.includes(source[pos])) return false;
  const report = message => silent || env.report(lineOf(state), message);
  const found = IN_SENTENCES.reduce((before, read) => before ?? read({ source, report }, pos), undefined);
  if (!found) return false;
  const { end, piece } = found;
  if (piece && !silent) state.push('mark', '', 0).meta = { ...piece, line: lineOf(state) };
  if (piece === undefined && !silent) state.pending += source.slice(pos, end);
  state.pos = end;
  return true;
}

const ALONE = Object.keys(MARKS).filter(name => MARKS[name].kind !== 'inline');
const STANDS_ALONE = new RegExp(`^(?:<!--|\\\\f[[{]|\\\\(?:end)?(?:${ALONE.join('|')})(?![A-Za-z]))`);

// Marks that stand alone, at the start of a line: one or several, and behind them at times text.
function blockMarks(state, first, last, silent) {
  const { bMarks, tShift, eMarks, src, env } = state;
  const start = src.slice(bMarks[first] + tShift[first], eMarks[first]);
  if (!STANDS_ALONE.test(start)) return false;
  if (silent) return true;
  const source = textFrom(state, first, last, start.startsWith('<!--'));
  let at = 0;
  while (STANDS_ALONE.test(source.slice(at))) {
    const line = first + linesBefore(source, at) + 1;
    const context = { source, report: message => env.report(line, message) };
    const { end, piece } = comment(context, at) ?? readMark(context, at);
    if (piece) Object.assign(state.push('mark', '', 0), { map: [line - 1, line], meta: { ...piece, line } });
    at = end + source.slice(end).match(/^[ \t]*/)[0].length;
  }
  goOn(state, first + linesBefore(source, at), source.slice(at).split('\n', 1)[0], last);
  return true;
}

// The text from a line on, within its list item or quotation; only a comment goes on behind an empty line.
function textFrom(state, first, last, goesOn) {
  let end = first + 1;
  while (end < last && (state.isEmpty(end) ? goesOn : state.sCount[end] >= state.blkIndent)) ++end;
  return state.getLines(first, end, state.blkIndent, false).trimStart();
}

// Text behind a mark is read as if it began its line.
function goOn(state, line, rest, last) {
  state.line = line + 1;
  if (!rest) return;
  state.bMarks[line] = state.eMarks[line] - rest.length;
  state.tShift[line] = 0;
  state.sCount[line] = state.blkIndent;
  state.md.block.tokenize(state, line, last);
}

const markdown = new MarkdownIt({ linkify: true }).use(bookPlugin);
