/** Colours of a map's values, and of what became of points that have none. */

// cividis (Nunez, Anderton and Renslow 2018): its order survives grey print and every kind of colour vision
const STOPS = ["#00224e", "#083370", "#35456c", "#4f576c", "#666970", "#7d7c78", "#948e77", "#aea371", "#c8b866", "#e5cf52", "#fee838"];
const NUMBERS = STOPS.map((colour) => [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16)));

export const GRADIENT = `linear-gradient(to right, ${STOPS.join(", ")})`;

/** Face and ink for a share of the largest value, 0 to 1. */
export function cividis(share) {
  const place = Math.min(1, Math.max(0, share)) * (STOPS.length - 1);
  const step = Math.min(STOPS.length - 2, Math.floor(place));
  const parts = NUMBERS[step].map((from, part) => Math.round(from + (place - step) * (NUMBERS[step + 1][part] - from)));
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
  "\u2260": "untrusted",
  "\u271a": "diverged",
  "\u2298": "unbuilt",
  "\u2013": "untried",
  "\u00b7": "unrun",
  "\u2297": "before",
};

/** The style's class for a word's sign. */
export function patternOf(sign) {
  return `what ${PATTERNS[sign] ?? "other"}`;
}
