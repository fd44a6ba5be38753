/** Colours of a map's values, and signs of outcomes without a value. */

import { make } from "./elements.js";
import { ENERGY_COLOURS, QUANTITY_COLOURS } from "./scheme.js";

export function coloursOf(quantity) {
  return quantity.energy ? ENERGY_COLOURS : QUANTITY_COLOURS;
}

/** Colours of a cell and of its text for a share of the largest value, 0 to 1. */
export function cellColour(colours, share) {
  const parts = colours.at(share).map((part) => Math.round(255 * part));
  const light = 0.299 * parts[0] + 0.587 * parts[1] + 0.114 * parts[2] > 118;
  return { face: `rgb(${parts.join(" ")})`, ink: light ? "#000" : "#fff" };
}

/** The sign of a word, in its pattern. */
export function signOf({ sign, pattern }) {
  return make("span", { className: `what ${pattern}`, "aria-hidden": "true" }, make("span", {}, sign));
}

/** Scale of the colours of a quantity; nothing if it has no values. */
export function scaleParts(model, quantity) {
  const scale = model.scaleOf(quantity);
  if (!scale) return [];
  const bar = make("span", { className: "bar", "aria-hidden": "true" });
  bar.style.background = coloursOf(quantity).gradient;
  return [make("p", { className: "scale" }, `${quantity.title} (${quantity.unit})`, make("span", { className: "whole" }, scale.text(scale.low), bar, scale.text(scale.high)))];
}
