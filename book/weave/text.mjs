// Small helpers on text that several parts of the weaver need.
export const escapeHtml = text => text
  .replace(/&/g, '&amp;').replace(/</g, '&lt;').replace(/>/g, '&gt;').replace(/"/g, '&quot;');

export const slug = text => text.normalize('NFKD').replace(/[\u0300-\u036f]/g, '').toLowerCase()
  .replace(/['’]/g, '').replace(/[^a-z0-9]+/g, '-').replace(/^-+|-+$/g, '');

export const textOfHtml = html => html.replace(/<[^>]*>/g, ' ')
  .replace(/&lt;/g, '<').replace(/&gt;/g, '>').replace(/&quot;/g, '"').replace(/&amp;/g, '&')
  .replace(/\s+/g, ' ').trim();

// Typographic quotes, apostrophes and ellipses; `before` is the character that precedes the text.
export function smarten(text, before = ' ') {
  const opens = (all, at) => /[\s([{\u2013\u2014\u2018\u201c/]/.test(at > 0 ? all[at - 1] : before);
  return text.replace(/\.\.\./g, '…').replace(/["']/g, (quote, at, all) => {
    if (quote === '"') return opens(all, at) ? '“' : '”';
    return opens(all, at) && !/^\d\ds?\b/.test(all.slice(at + 1)) ? '‘' : '’';
  });
}
