/** Colours: the page's own, which are light or dark, and those that mean something, which stay. */

export const MOUNTAIN = "#d55e00";
export const VALLEY = "#0072b2";

// of the regions of sheets and plates, in their order
const TINTS = ["#e2cf9f", "#c5bcd9", "#b7cfa2", "#d6aeb9", "#9cc4dd", "#cfcfcf"];

export function regionTint(region) {
  return TINTS[region % TINTS.length];
}

// viridis (Smith and van der Walt 2015), without its darkest end, which a dark page would swallow
const ENERGY = ["#453781", "#39568c", "#2d708e", "#20908d", "#29af7f", "#73d055", "#b8de29", "#fde725"];
const ENERGY_NUMBERS = ENERGY.map((colour) => [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16) / 255));

export const ENERGY_GRADIENT = `linear-gradient(to right, ${ENERGY.join(", ")})`;

/** The colour of an energy as a share of the largest, sRGB 0 to 1. */
export function energyColour(share, into = [0, 0, 0]) {
  const place = Math.min(1, Math.max(0, share)) * (ENERGY.length - 1);
  const step = Math.min(ENERGY.length - 2, Math.floor(place));
  for (let part = 0; part < 3; part++) {
    const from = ENERGY_NUMBERS[step][part];
    into[part] = from + (place - step) * (ENERGY_NUMBERS[step + 1][part] - from);
  }
  return into;
}

/** A colour of the page's style, such as "--ink". */
export function styleColour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

/** Listen to a change between light and dark; what it returns ends that. */
export function onSchemeChange(listener) {
  const dark = matchMedia("(prefers-color-scheme: dark)");
  dark.addEventListener("change", listener);
  return () => dark.removeEventListener("change", listener);
}

export const DASHES = [[], [8, 4], [8, 3, 2, 3], [2, 3]];
const LINES = 7;

/** Colour and dash of a plot's line by its number. */
export function lineLook(index) {
  return { colour: styleColour(`--line-${index % LINES}`), dash: DASHES[index % DASHES.length] };
}
