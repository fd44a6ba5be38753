/** A choice of a point, and a pad of arrows that moves it in the plane of the picture, by buttons and keys. */

import { make } from "./elements.js";

/** Sign, direction, key, and steps to the right and upwards. */
const ARROWS = [
  ["\u2190", "left", "ArrowLeft", [-1, 0]],
  ["\u2191", "up", "ArrowUp", [0, 1]],
  ["\u2193", "down", "ArrowDown", [0, -1]],
  ["\u2192", "right", "ArrowRight", [1, 0]],
];

/** Steps to the right and upwards, by key. */
export const STEPS = Object.fromEntries(ARROWS.map(([, , key, steps]) => [key, steps]));

/** Choice of a point among [name, number]. */
export const pointChoice = (points) => make("select", {}, ...points.map(([name, value]) => make("option", { value }, name)));

/** A pad of arrows; `verb` says what they do. Receives the key of a button, or an arrow key that is pressed alone. */
export function makeArrowPad(verb, { clicked, pressed }) {
  const buttons = ARROWS.map(([text, way, key]) => {
    const button = make("button", { type: "button", title: `${verb} ${way}`, "aria-label": `${verb} ${way}`, "data-way": key }, text);
    button.addEventListener("click", () => clicked(key));
    return button;
  });
  const pad = make("span", { className: "pad", role: "group", "aria-label": `${verb} in the plane of the picture` }, ...buttons);
  pad.addEventListener("keydown", (event) => {
    if (!(event.key in STEPS) || event.shiftKey || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    event.stopPropagation();
    pressed(event.key);
  });
  return pad;
}
