export default {
  root: true,
  extends: ['html-validate:recommended'],
  rules: {
    // KaTeX places its glyphs by inline styles, and a figure's colour can follow the page only so.
    'no-inline-style': 'off',
    // An id may begin with a digit in HTML; a chapter's id does.
    'valid-id': ['error', { relaxed: true }],
  },
};
