// Source code in colours, with links from the book's own names to their documentation.
import hljs from 'highlight.js/lib/core';
import bash from 'highlight.js/lib/languages/bash';
import cmake from 'highlight.js/lib/languages/cmake';
import cpp from 'highlight.js/lib/languages/cpp';
import { escapeHtml } from './text.mjs';

hljs.registerLanguage('bash', bash);
hljs.registerLanguage('cmake', cmake);
hljs.registerLanguage('cpp', cpp);
hljs.registerLanguage('gnuplot', ({ COMMENT, QUOTE_STRING_MODE, APOS_STRING_MODE, C_NUMBER_MODE }) => ({
  keywords: {
    keyword: 'set unset plot splot replot load eval reset for in if else do while stats',
    built_in:
      'using with title notitle axes every smooth lines points linespoints labels filledcurves vectors steps boxes hypertext point',
  },
  contains: [COMMENT('#', '$'), QUOTE_STRING_MODE, APOS_STRING_MODE, C_NUMBER_MODE],
}));

const LANGUAGES = {
  sh: 'bash',
  bash: 'bash',
  shell: 'bash',
  console: 'bash',
  cmake: 'cmake',
  cpp: 'cpp',
  h: 'cpp',
  hpp: 'cpp',
  gp: 'gnuplot',
};
export const languageOf = name => LANGUAGES[name] ?? null;

// HTML lines, each complete in itself; `link(qualified)` gives the address of a C++ name, or nothing.
export function highlightLines(code, language, link = null) {
  const name = languageOf(language);
  const html = name ? hljs.highlight(code, { language: name, ignoreIllegals: true }).value : escapeHtml(code);
  return splitLines(name === 'cpp' && link ? linkNames(html, link) : html);
}

// A comment or string over several lines is one element: it has to end with each line and start again in the next.
function splitLines(html) {
  let open = [];
  return html.split('\n').map(line => {
    const before = open.join('');
    for (const [tag] of line.matchAll(/<span[^>]*>|<a [^>]*>|<\/(?:span|a)>/g))
      open = tag[1] === '/' ? open.slice(0, -1) : [...open, tag];
    return (
      before +
      line +
      [...open]
        .reverse()
        .map(tag => (tag.startsWith('<a') ? '</a>' : '</span>'))
        .join('')
    );
  });
}

const QUIET = /^<span class="hljs-(?:comment|string|meta|doctag)/;

// Names in comments and strings stay as they are. The parts of a qualified name may be coloured apart: `scope` carries
// "integrate::" over to the next part.
function linkNames(html, link) {
  let quiet = 0,
    scope = '';
  return html.replace(/<span[^>]*>|<\/span>|[^<]+/g, part => {
    if (part.startsWith('<span')) {
      if (quiet || QUIET.test(part)) ++quiet;
      return part;
    }
    if (part === '</span>') {
      if (quiet) --quiet;
      return part;
    }
    if (quiet) return part;
    const carried = scope;
    scope = part.match(/(?:[A-Za-z_]\w*::)+$/)?.[0] ?? '';
    return part.replace(/&\w+;|(?:[A-Za-z_]\w*::)*[A-Za-z_]\w*/g, (name, at) =>
      anchor(name, at === 0 ? carried : '', link),
    );
  });
}

function anchor(name, scope, link) {
  const href = name.startsWith('&') ? null : link(scope + name);
  return href ? `<a href="${href}">${name}</a>` : name;
}
