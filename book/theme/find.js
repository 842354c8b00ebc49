// What the search finds, best first: MiniSearch over the places of the book, which also knows its readers' words for them.
(function () {
  'use strict';
  const { documents, same, idle } = window.BOOK_SEARCH;

  // What a reader of the prose is led to comes before a claim, and both before the reference.
  const WEIGHTS = {
    choice: 1.15,
    header: 1.1,
    section: 1,
    page: 0.9,
    word: 0.85,
    exercise: 0.6,
    literature: 0.3,
    claim: 0.35,
    name: 0.3,
  };
  const MOST = { claim: 2, name: 3, word: 3, exercise: 4 };
  const LONGEST = 12;
  const NAMED = 3; // what is called just what was typed

  const plain = word =>
    word
      .normalize('NFD')
      .replace(/[\u0300-\u036f]/g, '')
      .toLowerCase();
  // "springs" is "spring", and "masses" is "mass"; "bias" and "across" stay.
  const singular = word =>
    word.length < 4 || /(ss|us|is|as|os)$/.test(word) ? word : word.replace(/(ss|x|ch|sh)es$/, '$1').replace(/s$/, '');
  const wordsOf = text =>
    plain(text)
      .replace(/['’]s?\b/g, '')
      .match(/\d+(?:\.\d+)+|[\p{L}\p{N}+]+/gu)
      ?.map(singular) ?? [];
  // "Exercise 4 of chapter 3" is exercise 3.4.
  const numbered = query => query.replace(/\b(\d+) (?:of|in) chapter (\d+)\b/gi, '$2.$1');
  // Exercise 3.4 is found by 3.4; but 3.4 doesn't find 4.3.
  const numbersApart = text => (text.match(/\d+(?:\.\d+)+/g) ?? []).join(' ').replace(/\./g, ' ');
  // A name of several words is found by all of it and by each.
  const apart = text =>
    text
      .match(/\b\p{L}*\p{Ll}{2}\p{Lu}\p{Ll}\p{L}*/gu)
      ?.join(' ')
      .replace(/(\p{Ll})(?=\p{Lu})/gu, '$1 ') ?? '';

  const search = new window.MiniSearch({
    fields: ['title', 'called', 'text'],
    storeFields: ['kind', 'title', 'place', 'url', 'text'],
    tokenize: text => wordsOf(`${text} ${apart(text)} ${numbersApart(text)}`),
    processTerm: word => word,
    searchOptions: {
      boost: { title: 3, called: 3 },
      prefix: word => word.length > 2,
      weights: { prefix: 0.3, fuzzy: 0.2 },
      boostDocument: (_, __, { kind }) => WEIGHTS[kind],
    },
  });
  search.addAll(documents);

  // Of each word or phrase what stands for it as well, each a list of words.
  const meanings = new Map();
  for (const group of same.map(names => names.map(wordsOf)))
    for (const words of group) meanings.set(words.join(' '), group);
  const longest = Math.max(...[...meanings.keys()].map(key => key.split(' ').length));
  const without = new Set(idle.flatMap(wordsOf));

  // The query as what has to be found: a phrase with a meaning, or a word.
  function partsOf(query) {
    const words = wordsOf(numbered(query));
    const parts = [];
    for (let i = 0; i < words.length;) {
      let n = Math.min(longest, words.length - i);
      while (n > 1 && !meanings.has(words.slice(i, i + n).join(' '))) --n;
      const own = words.slice(i, i + n);
      parts.push(meanings.get(own.join(' ')) ?? [own]);
      i += n;
    }
    const said = parts.filter(group => !group.every(([word, ...more]) => !more.length && without.has(word)));
    return said.length ? said : parts;
  }

  const all = words => (words.length > 1 ? { combineWith: 'AND', queries: words } : words[0]);
  const any = group => (group.length > 1 ? { combineWith: 'OR', queries: group.map(all) } : all(group[0]));

  // What holds more of it comes before what holds less, unless it hardly speaks of it.
  function ranked(parts, asked) {
    const holds = (terms, group) => group.some(words => words.every(word => terms.has(word)));
    const shareOf = ({ queryTerms }) => {
      const terms = new Set(queryTerms);
      return parts.filter(group => holds(terms, group)).length / parts.length;
    };
    const isNamed = ({ title }) => wordsOf(title).join(' ') === asked;
    return search
      .search({ combineWith: 'OR', queries: parts.map(any) })
      .map(hit => ({ ...hit, score: hit.score * shareOf(hit) ** 2 * (isNamed(hit) ? NAMED : 1) }))
      .sort((one, other) => other.score - one.score);
  }

  // The same with slips of the fingers allowed, for words that stand nowhere.
  const nearly = parts =>
    search.search({ combineWith: 'OR', queries: parts.flat().map(all), fuzzy: word => (word.length > 4 ? 0.2 : 0) });

  function fewOfAKind(hits) {
    const count = {};
    return hits.filter(({ kind }) => (count[kind] = (count[kind] ?? 0) + 1) <= (MOST[kind] ?? LONGEST));
  }

  window.findInBook = query => {
    const parts = partsOf(query);
    if (!parts.length) return [];
    const found = ranked(parts, wordsOf(query).join(' '));
    const hits = fewOfAKind(found.length ? found : nearly(parts)).slice(0, LONGEST);
    const isLast = ({ kind }) => kind === 'name';
    return [...hits.filter(hit => !isLast(hit)), ...hits.filter(isLast)];
  };
})();
