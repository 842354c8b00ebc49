// gnuplot's SVG made fit to live inside a page: ids of its own, the book's colours, a name and a description.
import * as cheerio from 'cheerio';
import { escapeHtml, smarten } from './text.mjs';

const COLOURS = { stroke: true, fill: true, color: true };

export function adoptSvg(svg, { id, title, description }) {
  const $ = cheerio.load(svg.replace(/^[\s\S]*?<svg/, '<svg').replace(/<!--[\s\S]*?-->/g, ''), {
    xml: { decodeEntities: true },
  });
  const root = $('svg').first();
  root.children('title, desc').remove();
  $('filter, script, style').remove();
  adoptTips($);
  removeNames($);
  removeEmpty($);
  renameIds($, id);
  $('*').each((_, e) => {
    tidyAttributes(e);
    shortenNumbers(e);
  });
  const { viewBox, width, height } = root.attr();
  const box = viewBox ?? `0 0 ${width} ${height}`;
  root.get(0).attribs = {
    'viewBox': box,
    'style': `max-width:${box.split(/[\s,]+/)[2]}px`,
    'role': 'img',
    'aria-labelledby': `${id}-title ${id}-desc`,
  };
  root.prepend(
    `<title id="${id}-title">${escapeHtml(title)}</title><desc id="${id}-desc">${escapeHtml(description)}</desc>`,
  );
  return compact($.xml(root));
}

// 'with labels hypertext' carries each point's value for gnuplot's own script, which the book does not need.
function adoptTips($) {
  $('[onmousemove]').each((_, e) => {
    const tip = e.attribs.onmousemove.match(/showHypertext\(evt,\s*'([\s\S]*)'\)/)?.[1];
    e.attribs = tip ? { 'class': 'point', 'data-tip': tidyTip(tip.replace(/\\'/g, "'")) } : {};
    $(e).children('title').remove();
  });
  $('*').each((_, e) => {
    for (const name of Object.keys(e.attribs)) if (name.startsWith('on')) delete e.attribs[name];
  });
}

// C's printf knows a minus zero, and no minus but the hyphen.
const tidyTip = tip =>
  smarten(tip)
    .replace(/(?<![\w.])-(0(?:\.0+)?)(?![\d.])/g, '$1')
    .replace(/(?<![\w.])-(?=\d)/g, '\u2212');

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

function renameIds($, id) {
  $('[id]').each((_, e) => {
    e.attribs.id = `${id}-${e.attribs.id}`;
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
    if (/^(font-family|xml:space|xmlns|xmlns:xlink|style)$/.test(name) || (name === 'class' && value !== 'point')) {
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
