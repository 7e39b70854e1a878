/* Elements of a page, without markup in texts. */

/** Return a new element with properties and children; a text is a child as well. */
export function make(tag, properties = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (name in element) element[name] = value;
    else element.setAttribute(name, value);
  }
  element.append(...children);
  return element;
}

export const button = (text, className, onclick) => make("button", { type: "button", className, onclick }, text);
