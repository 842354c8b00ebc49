// What a namespace of code/ is for stands above it in one of its headers, or here, where each header has to stand alone.
export const NAMESPACES = [
  { name: 'integrate', about: 'The methods, one per header, each of which stands alone and can be copied into any project.' },
];

const TITLES = { integrate: 'Methods', measure: 'Measurements' };

export const titleOf = name => TITLES[name] ?? name[0].toUpperCase() + name.slice(1);
