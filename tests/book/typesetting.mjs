// What a careful printer would see to: what belongs together stands together, and what is cut shows it. Runs within a page; returns
// what is wrong with it, one line each.
export async function typesetting() {
  await document.fonts.ready;
  const all = (selector, root = document) =>
    [...root.querySelectorAll(selector)].filter(e => e.getClientRects().length);
  const found = [];
  const wide = innerWidth > 960;
  const within = (text, mark) =>
    text.left < mark.right - 1 &&
    mark.left < text.right - 1 &&
    text.top < mark.bottom - 1 &&
    mark.top < text.bottom - 1;
  for (const mark of all('main a.claim')) {
    const block = mark.closest('p, li, td');
    const [line, at] = [block, mark].map(element => element.getBoundingClientRect());
    if (block.matches('td, .pick-a-method *')) {
      if (at.left - line.left < 10) found.push(`the check mark #${mark.id} starts a line`);
      continue;
    }
    if (wide && at.left < line.right) found.push(`the check mark #${mark.id} is not in the margin`);
    const text = document.createRange();
    text.selectNodeContents(block);
    if ([...text.getClientRects()].some(rect => rect.width > 20 && within(rect, at)))
      found.push(`the check mark #${mark.id} lies on its text`);
    for (const other of all('a.claim', block))
      if (other !== mark && within(other.getBoundingClientRect(), at))
        found.push(`the check marks #${mark.id} and #${other.id} lie on each other`);
  }
  for (const formula of all('main .nowrap .katex-html')) {
    const lefts = all(':scope > .base', formula).map(part => part.getBoundingClientRect().left);
    if (lefts.some((left, i) => left < lefts[i - 1])) found.push(`a short formula is torn: ${formula.textContent}`);
  }
  for (const svg of all('.plot svg:not(.film .still)')) {
    if (svg.getBoundingClientRect().width > svg.viewBox.baseVal.width + 1)
      found.push(`${svg.closest('figure').id} is drawn larger than it is`);
  }
  for (const box of all('pre, .tablescroll, .math-block').filter(e => e.checkVisibility())) {
    const cut = box.scrollWidth > box.clientWidth + 1;
    if (cut !== (getComputedStyle(box).maskImage !== 'none'))
      found.push(
        `${cut ? 'nothing shows that this is cut' : 'this fades, though it is whole'}: ${box.textContent.trim().slice(0, 40)}`,
      );
  }
  return found;
}
