/** Construction of elements of the page. */

/** Make an element with properties and children; names with a dash, and "role", are attributes. */
export function make(tag, properties = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (name.includes("-") || name === "role") element.setAttribute(name, value);
    else element[name] = value;
  }
  element.append(...children);
  return element;
}

/** A button whose tooltip, for screen readers as well, says what it does. */
export function makeButton(text, label, act) {
  const button = make("button", { type: "button", title: label, "aria-label": label }, text);
  button.addEventListener("click", act);
  return button;
}

/** A small drawing of a path in a box of 24 by 24. */
export const icon = (path) => drawn(path, 24);

/** A drawing of a path in a square box of a size, which a style may stretch. */
export function drawn(path, size) {
  const space = "http://www.w3.org/2000/svg";
  const drawing = document.createElementNS(space, "svg");
  drawing.setAttribute("viewBox", `0 0 ${size} ${size}`);
  if (size !== 24) drawing.setAttribute("preserveAspectRatio", "none");
  drawing.setAttribute("aria-hidden", "true");
  const line = document.createElementNS(space, "path");
  line.setAttribute("d", path);
  drawing.append(line);
  return drawing;
}

/** A sample of a plot's line or area. */
export function lineSample({ colour, dash, area }) {
  const space = "http://www.w3.org/2000/svg";
  const drawing = document.createElementNS(space, "svg");
  drawing.setAttribute("viewBox", "0 0 24 8");
  drawing.setAttribute("aria-hidden", "true");
  drawing.classList.add("sample");
  const line = document.createElementNS(space, "path");
  line.setAttribute("d", area ? "M0 0H24V8H0Z" : "M0 4H24");
  if (area) line.style.fill = colour;
  line.setAttribute("stroke", area ? "none" : colour);
  line.setAttribute("stroke-dasharray", dash.join(" "));
  drawing.append(line);
  return drawing;
}
