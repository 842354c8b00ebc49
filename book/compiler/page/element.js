// Elements of the page.
export const element = (name, properties = {}, ...content) => {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...content);
  return made;
};

export const press = (words, act) => {
  const button = element('button', { type: 'button', textContent: words });
  button.addEventListener('click', act);
  return button;
};
