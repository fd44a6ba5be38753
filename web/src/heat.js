/** Colours of a map's values, and of what became of points that have none. */

import { ENERGY_COLOURS, QUANTITY_COLOURS } from "./scheme.js";

export function coloursOf(quantity) {
  return quantity.energy ? ENERGY_COLOURS : QUANTITY_COLOURS;
}

/** Face of a cell and ink on it for a share of the largest value, 0 to 1. */
export function cellColour(colours, share) {
  const parts = colours.at(share).map((part) => Math.round(255 * part));
  const light = 0.299 * parts[0] + 0.587 * parts[1] + 0.114 * parts[2] > 118;
  return { face: `rgb(${parts.join(" ")})`, ink: light ? "#000" : "#fff" };
}

// each sign has a pattern of its own in the style
const PATTERNS = {
  "\u25cf": "opened",
  "\u25c6": "folded",
  "\u25a0": "closed",
  "\u00d7": "unfolded",
  "\u2731": "stuck",
  "\u21ba": "returned",
  "\u21bb": "reclosed",
  "\u25b7": "moving",
  "\u25c1": "opening",
  "\u2277": "undecided",
  "\u2260": "untrusted",
  "\u271a": "diverged",
  "\u2298": "unbuilt",
  "\u2013": "untried",
  "\u00b7": "unrun",
  "\u2297": "before",
  "\u25d0": "missed",
  "\u25d2": "missed",
  "\u25cb": "apart",
  "\u25b3": "placed",
};

/** The style's class for a word's sign. */
export function patternOf(sign) {
  return `what ${PATTERNS[sign] ?? "other"}`;
}
