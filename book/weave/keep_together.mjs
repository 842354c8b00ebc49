// Puts the HTML of the marks into the text, and keeps together what should not be torn at the end of a line: a short
// formula or piece of code in itself, a check mark and the word that it follows, punctuation and what it follows.
import { inlineText } from './inline.mjs';
import { HOLE, textOfHtml } from './text.mjs';

const MOST = 24;
const CLAIM = '\ue004\\d+\ue005';
const REST = `(?:${CLAIM}|[^\\s<>—–/\ue000-\ue005])*`;
const WITH_CLAIM = `(?:[^\\s<>—–/\ue000-\ue005]*${CLAIM})+[.,;:!?)\\]”’…]*`;
const TOKENS = new RegExp(`([(“‘[]*)\ue000(\\d+)\ue001(${REST})`, 'g');
const WORDS = new RegExp(
  `((?:[^\\s<>\ue000-\ue005]+|<(a|code)\\b[^>]*>[^<]*</\\2>)?)((?:</(?:em|strong)>)*)(${WITH_CLAIM})`,
  'g',
);

export function keepTogether(html, expand, piece) {
  const claims = text => text.replace(/\ue004(\d+)\ue005/g, (_, n) => `\u2060${expand(n)}`);
  const together = (text, length) => (length <= MOST ? `<span class="nowrap">${text}</span>` : text);
  const isClaim = n => piece(n).name === 'claim';
  return html
    .replace(HOLE, (all, n) => (isClaim(n) ? `\ue004${n}\ue005` : all))
    .replace(/\s+(?=\ue004)/g, '')
    .replace(TOKENS, (_, before, n, rest) => {
      const whole = before + expand(n) + claims(rest);
      const length = inlineText(piece(n)).length + rest.replace(/\ue004\d+\ue005/g, '').length;
      return ['math', 'code'].includes(piece(n).name) || rest.includes('\ue004') ? together(whole, length) : whole;
    })
    .replace(WORDS, (_, word, tag, ends, rest) => together(word + claims(rest), textOfHtml(word).length) + ends);
}
