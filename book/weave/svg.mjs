// gnuplot's SVG made fit to live inside a page: ids of its own, the book's colours, a name and a description.
import * as cheerio from 'cheerio';
import { takePoints } from './svg-points.mjs';
import { thin } from './svg-thin.mjs';
import { escapeHtml } from './text.mjs';

const COLOURS = { stroke: true, fill: true, color: true };

// { html, shape, points }: the drawing, its width over its height, and the values that it shows at its points.
export function adoptSvg(svg, { id, title, description }) {
  const $ = cheerio.load(svg.replace(/^[\s\S]*?<svg/, '<svg').replace(/<!--[\s\S]*?-->/g, ''), {
    xml: { decodeEntities: true },
  });
  const root = $('svg').first();
  root.children('title, desc').remove();
  $('filter, script, style').remove();
  const points = takePoints($);
  removeNames($);
  removeEmpty($);
  renameIds($, id);
  $('*').each((_, e) => {
    tidyAttributes(e);
    shortenNumbers(e);
  });
  const { viewBox, width, height } = root.attr();
  const box = viewBox ?? `0 0 ${width} ${height}`;
  const [, , w, h] = box.split(/[\s,]+/);
  root.get(0).attribs = {
    'viewBox': box,
    'style': `max-width:${w}px`,
    'role': 'img',
    'aria-labelledby': `${id}-title ${id}-desc`,
  };
  thin($, root.get(0));
  root.prepend(
    `<title id="${id}-title">${escapeHtml(title)}</title><desc id="${id}-desc">${escapeHtml(description)}</desc>`,
  );
  return { html: compact($.xml(root)), shape: `${w}/${h}`, points };
}

// A plot's <title> would pop up over every line: the book has hover values instead.
function removeNames($) {
  $('g > title').remove();
}

function removeEmpty($) {
  $('rect[fill="none"]')
    .filter((_, e) => e.attribs.x === '0' && e.attribs.y === '0' && !e.attribs.stroke)
    .remove();
  for (let before = -1; before !== $('*').length;) {
    before = $('*').length;
    const used = new Set(
      $('use')
        .map((_, e) => (e.attribs['xlink:href'] ?? e.attribs.href ?? '').slice(1))
        .get(),
    );
    $('defs [id]').each((_, e) => {
      if (!used.has(e.attribs.id)) $(e).remove();
    });
    $('g, defs, text')
      .filter((_, e) => !e.children.some(c => c.type === 'tag' || c.data?.trim()))
      .remove();
  }
}

// What nobody refers to needs no name.
function renameIds($, id) {
  const meant = new Set(
    $('use, [clip-path]')
      .map((_, { attribs }) => [attribs['xlink:href'] ?? attribs.href, attribs['clip-path']].join(' ').match(/[\w-]+/g))
      .get(),
  );
  $('[id]').each((_, e) => {
    if (meant.has(e.attribs.id)) e.attribs.id = `${id}-${e.attribs.id}`;
    else delete e.attribs.id;
  });
  $('use').each((_, e) => {
    const target = e.attribs['xlink:href'] ?? e.attribs.href;
    delete e.attribs['xlink:href'];
    e.attribs.href = `#${id}-${target.slice(1)}`;
  });
  $('[clip-path]').each((_, e) => {
    e.attribs['clip-path'] = e.attribs['clip-path'].replace('url(#', `url(#${id}-`);
  });
}

// A presentation attribute takes no var(): the book's colours have to be written as style.
function tidyAttributes(e) {
  const styles = e.attribs.style ? [e.attribs.style.replace(/;$/, '')] : [];
  for (const [name, value] of Object.entries(e.attribs)) {
    if (/^(font-family|xml:space|xmlns|xmlns:xlink|class|style)$/.test(name)) {
      delete e.attribs[name];
      continue;
    }
    if (!COLOURS[name]) continue;
    const plot = value.match(/^rgb\(\s*0,\s*0,\s*(\d+)\)$|^#0000([0-9a-f]{2})$/i);
    const n = plot && (plot[1] ? Number(plot[1]) : parseInt(plot[2], 16));
    if (n >= 1) {
      styles.push(`${name}:var(--plot-${n})`);
      delete e.attribs[name];
    } else if (value === 'black' || n === 0) {
      if (name === 'color') delete e.attribs[name];
      else e.attribs[name] = 'currentColor';
    }
  }
  // A formula looks as it does in the text.
  if (e.attribs['font-style'] === 'italic') styles.push('font-family:KaTeX_Math,serif;font-size:1.1em');
  if (styles.length) e.attribs.style = styles.join(';');
}

const GEOMETRY = /^(d|transform|points|x|y|x1|x2|y1|y2|cx|cy|r|width|height|stroke-width|font-size|stroke-dasharray)$/;

// A tenth of a unit is plenty, except for widths of lines, where gnuplot's defaults are thinner than that.
function shortenNumbers(e) {
  for (const [name, value] of Object.entries(e.attribs)) {
    if (!GEOMETRY.test(name) || e.parent?.name === 'defs') continue;
    e.attribs[name] = value
      .replace(/(\d\.\d)\d+/g, '$1')
      .replace(/(\d)\.0\b/g, '$1')
      .replace(/\s+/g, ' ')
      .trim();
  }
}

const compact = svg =>
  svg
    .replace(/<tspan>([^<]*)<\/tspan>/g, '$1')
    .replace(/>\s*\n\s*/g, '>\n')
    .trim();
