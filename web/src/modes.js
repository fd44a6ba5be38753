/** Choice of how a structure moves. */

import { make } from "./elements.js";

/** Buttons for modes with names and titles; `choose` receives a name. Returns {element, mark}; `mark` shows the present mode. */
export function makeModes(whole, modes, choose) {
  const buttons = modes.map(({ name, title }) => {
    const button = make("button", { type: "button", title: `${name}: ${title}` }, name);
    button.addEventListener("click", () => choose(name));
    return button;
  });
  const mark = (present) => {
    for (const button of buttons) button.setAttribute("aria-pressed", String(button.textContent === present));
  };
  const meaning = modes.map(({ name, title }) => `${name}: ${title}`).join(" \u00b7 ");
  const label = `how the ${whole} moves`;
  const element = make("div", { className: "colours modes", role: "group", "aria-label": label }, make("span", {}, ...buttons), make("small", {}, meaning));
  return { element, mark };
}
