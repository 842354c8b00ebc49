// On which sheet of a PDF that Chromium wrote each of its named places is. Its objects, unlike what they draw, are plain text.
export function sheetsOfPlaces(pdf) {
  const text = pdf.toString('latin1');
  const begins = new Map(
    [...text.matchAll(/\n(\d+) 0 obj\n/g)].map(({ 0: head, 1: number, index }) => [number, index + head.length]),
  );
  const object = number => text.slice(begins.get(number), text.indexOf('\nendobj', begins.get(number)));
  const references = list => [...list.matchAll(/(\d+) 0 R/g)].map(([, number]) => number);
  const leaves = number => {
    const [, kids] = object(number).match(/\/Kids \[([^\]]*)\]/) ?? [];
    return kids ? references(kids).flatMap(leaves) : [number];
  };
  const catalog = text.match(/<<\/Type \/Catalog[^]*?\nendobj/)[0];
  const sheets = leaves(catalog.match(/\/Pages (\d+) 0 R/)[1]);
  const places = object(catalog.match(/\/Dests (\d+) 0 R/)[1]);
  return new Map(
    [...places.matchAll(/\/(\S+) \[(\d+) 0 R/g)].map(([, name, sheet]) => [
      unescapeName(name),
      sheets.indexOf(sheet) + 1,
    ]),
  );
}

export const countSheets = pdf => pdf.toString('latin1').match(/\/Type \/Page\b/g).length;

const unescapeName = name =>
  name.replace(/#([0-9A-Fa-f]{2})/g, (_, digits) => String.fromCharCode(parseInt(digits, 16)));
