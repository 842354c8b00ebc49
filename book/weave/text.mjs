// Small helpers on text that several parts of the weaver need.
export const escapeHtml = text =>
  text.replace(/&/g, '&amp;').replace(/</g, '&lt;').replace(/>/g, '&gt;').replace(/"/g, '&quot;');

export const slug = text =>
  text
    .normalize('NFKD')
    .replace(/[\u0300-\u036f]/g, '')
    .toLowerCase()
    .replace(/['’]/g, '')
    .replace(/[^a-z0-9]+/g, '-')
    .replace(/^-+|-+$/g, '');

export function linesBefore(text, at) {
  let lines = 0;
  for (let i = text.indexOf('\n'); i >= 0 && i < at; i = text.indexOf('\n', i + 1)) ++lines;
  return lines;
}

// Where a mark stands in HTML that is not finished: characters of Unicode's private area frame the number of its piece.
export const hole = ({ token }) => `\ue000${token}\ue001`;
export const HOLE = /\ue000(\d+)\ue001/g;

export const textOfHtml = html =>
  html
    .replace(/<[^>]*>/g, ' ')
    .replace(/&lt;/g, '<')
    .replace(/&gt;/g, '>')
    .replace(/&quot;/g, '"')
    .replace(/&amp;/g, '&')
    .replace(/\s+/g, ' ')
    .trim();

const UNITS = '[kcmµ]?m|[mµn]?s|[kMG]?Hz|[kMG]?B|[km]?[gNJW]|rad|AU|(?:[kcm]?m|rad|AU)/s(?:²|\\^2)?|km/h|°|%';
const BEFORE_UNIT = new RegExp(`(?<=[\\d\\ue001]) (?=(?:${UNITS})(?![\\w/^²]))`, 'g');

// Typographic quotes, apostrophes and ellipses, units that stay with their numbers; `before` is the character that precedes the text.
export function smarten(text, before = ' ') {
  const opens = (all, at) => /[\s([{\u2013\u2014\u2018\u201c/]/.test(at > 0 ? all[at - 1] : before);
  return text
    .replace(/\.\.\./g, '…')
    .replace(BEFORE_UNIT, '\u202f')
    .replace(/["']/g, (quote, at, all) => {
      if (quote === '"') return opens(all, at) ? '“' : '”';
      return opens(all, at) && !/^\d\ds?\b/.test(all.slice(at + 1)) ? '‘' : '’';
    });
}

// As a style sheet quotes it.
export const cssString = text => `"${text.replace(/[\\"<]/g, c => `\\${c.codePointAt(0).toString(16)} `)}"`;

// A chapter is called "Euler: along the tangent", and "Euler" within a sentence or where there is little room.
export const beforeColon = title => title.split(':')[0];
