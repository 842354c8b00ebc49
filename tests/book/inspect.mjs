// Runs within a page; returns what is wrong with it, one line each.
export async function inspect() {
  await document.fonts.ready;
  const faults = [];
  const all = (selector, root = document) => [...root.querySelectorAll(selector)];
  const name = e => e.tagName.toLowerCase() + (e.id ? `#${e.id}` : '') + [...e.classList].map(c => `.${c}`).join('');

  const headings = all('h1').length;
  if (headings !== 1) faults.push(`${headings} h1 instead of one`);

  const root = document.documentElement;
  const over = root.scrollWidth - root.clientWidth;
  if (over > 0) faults.push(`scrolls sideways by ${over} px`);
  const scrolls = e => e && (/auto|scroll/.test(getComputedStyle(e).overflowX) || scrolls(e.parentElement));
  for (const e of all('main *:not(svg *)')) {
    if (e.closest('.katex-mathml') || scrolls(e)) continue;
    const right = e.getBoundingClientRect().right;
    if (right > root.clientWidth + 1)
      faults.push(`${name(e)} is cut off: it ends at ${Math.round(right)} px of ${root.clientWidth}`);
  }

  for (const font of document.fonts) if (font.status === 'error') faults.push(`font not loaded: ${font.family}`);
  const loaded = [...document.fonts]
    .filter(font => font.status === 'loaded')
    .map(font => font.family.replace(/"/g, ''));
  for (const e of all('body, nav, main code')) {
    const family = getComputedStyle(e).fontFamily.split(',')[0].replace(/"/g, '');
    if (!loaded.includes(family)) faults.push(`${name(e)} is not set in ${family}`);
  }

  const text = document.body.cloneNode(true);
  all('code, pre, script, .katex, input', text).forEach(e => e.remove());
  const tips = all('[data-tip], [aria-label], [title]').map(e => [e.dataset.tip, e.ariaLabel, e.title].join(' '));
  const written = [document.title, ...tips, text.textContent].join('\n');
  // Doxygen's and the book's marks, Markdown, TeX, gnuplot's
  const raw =
    /\\f[$[\](){}]|\\[a-z]+\{|[\\@](ref|cite|snippet|p|c|endlink)\b|\*\*|``|\]\(|\$\$|\\[([]|\{\/:|[_^]\{|%[.\d]*[dfegs]\b|&(amp|lt|gt|quot|#\d+);|\[object /;
  const found = written.match(new RegExp(`.{0,30}(${raw.source}).{0,30}`));
  if (found) faults.push(`raw markup in the text: ${found[0].trim()}`);
  const torn = all('p', text).find(p => /(^|\s)\|\s.*\s\|/.test(p.textContent));
  if (torn) faults.push(`a table that became a paragraph: ${torn.textContent.slice(0, 60)}`);
  const values = all('data.number').filter(e => !/^[-+]?(\d[\d.]*(e[-+]?\d+)?|inf)$/.test(e.value));
  if (values.length) faults.push(`a value that is no number: ${values[0].value}`);
  if (document.querySelector('.katex-error')) faults.push('a formula that KaTeX could not set');
  return faults;
}
