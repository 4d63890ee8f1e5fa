// Short names for making and finding elements.

export const byId = (id) => document.getElementById(id);

// Children are elements or texts; attributes that are undefined are left out.
export function make(name, attributes = {}, ...children) {
  const element = document.createElement(name);
  for (const [attribute, value] of Object.entries(attributes))
    if (value !== undefined) element.setAttribute(attribute, value);
  element.append(...children);
  return element;
}

export function button(content, attributes, onClick) {
  const element = make('button', {type: 'button', ...attributes}, ...[content].flat());
  element.addEventListener('click', onClick);
  return element;
}
