// What a namespace of code/ is for stands above it in one of its headers, or here, where each header has to stand alone.
// Such a header has a page of its own in the code reference, which holds all that is in it.
import { slug } from './text.mjs';

export const NAMESPACES = [
  {
    name: 'integrate',
    about: 'The methods, one per header, each of which stands alone and can be copied into any project.',
  },
  {
    name: 'shelf',
    about: 'Things that a game needs beside a method, one per header, each of which stands alone as well.',
  },
];

const TITLES = { integrate: 'Methods', shelf: 'The shelf', measure: 'Measurements' };

export const titleOf = name => TITLES[name] ?? name[0].toUpperCase() + name.slice(1);

// Headers of things, and not of methods.
export const onShelf = ({ file }) => file.startsWith('code/shelf/');

// The page of a header that stands alone, or nothing.
export function headerPage(path) {
  const [, namespace, header] = path.match(/^code\/(\w+)\/(\w+)\.h$/) ?? [];
  return NAMESPACES.some(({ name }) => name === namespace) ? `${namespace}-${slug(header)}.html` : null;
}
