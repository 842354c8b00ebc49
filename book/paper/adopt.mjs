// A woven page becomes a part of the whole book: without what only a screen shows, with names that no other part has, and with
// links that lead within the book.
const ON_SCREEN_ONLY =
  'script, template, .plot .narrow, .pager, .anchor-link, .sources, .starter, .your-spring, .on-screen, .pdf, .points, .film iframe, main > footer';
const NAMING = ['aria-labelledby', 'aria-describedby', 'for'];

const idIn = (part, id) => `${part.name}--${id}`;

export function adopt(parts, address) {
  for (const { $ } of parts) $(ON_SCREEN_ONLY).remove();
  const ids = new Map(parts.map(part => [part.href, renameIds(part)]));
  for (const part of parts) {
    const { $ } = part;
    $('details').attr('open', '');
    $('[data-tip]').removeAttr('data-tip');
    $('main a[href]').each((_, a) => {
      const to = newTarget($(a).attr('href'), part, ids, address);
      if (to) $(a).attr('href', to);
      else $(a).removeAttr('href');
    });
  }
}

// Returns the names as they were.
function renameIds(part) {
  const { $ } = part;
  const old = new Set();
  const renamed = text => text.replace(/\S+/g, id => idIn(part, id));
  $('main [id]').each((_, e) => {
    old.add($(e).attr('id'));
    $(e).attr('id', renamed($(e).attr('id')));
  });
  for (const name of NAMING) $(`main [${name}]`).each((_, e) => void $(e).attr(name, renamed($(e).attr(name))));
  $('main svg *').each((_, e) => {
    for (const [name, value] of Object.entries(e.attribs)) {
      if (name.endsWith('href') && value.startsWith('#')) e.attribs[name] = `#${idIn(part, value.slice(1))}`;
      else if (value.includes('url(#')) e.attribs[name] = value.replace(/url\(#/g, `url(#${part.name}--`);
    }
  });
  return old;
}

// Where a link of a part leads to in the whole book; a page that is not in it is looked up at the book's address, if it has one.
function newTarget(url, part, ids, address) {
  if (/^(https?|mailto):/.test(url)) return url;
  const [file, fragment] = url.split('#');
  const href = file || part.href;
  if (!ids.has(href)) return address ? new URL(url, address).href : null;
  const name = href.replace('.html', '');
  return ids.get(href).has(fragment) ? `#${name}--${fragment}` : `#${name}`;
}
