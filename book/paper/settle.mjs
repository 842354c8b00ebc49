// Chromium names the heads of tables by numbers that differ from one print to the next. By their order they are always the same.
export function settleNames(pdf) {
  const text = pdf.toString('latin1');
  const names = [...new Set(text.match(/\bnode\d{8}\b/g))].sort();
  const settled = new Map(names.map((name, i) => [name, `node${String(i).padStart(8, '0')}`]));
  return Buffer.from(
    text.replace(/\bnode\d{8}\b/g, name => settled.get(name)),
    'latin1',
  );
}
