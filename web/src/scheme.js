/** Colours: those of the page, light or dark, and those with a meaning, which are constant. */

export const MOUNTAIN = "#d55e00";
export const VALLEY = "#0072b2";

// colours of the regions of sheets and plates, in their order
const TINTS = ["#e2cf9f", "#c5bcd9", "#b7cfa2", "#d6aeb9", "#9cc4dd", "#cfcfcf"];

// colours of bars of the same regions if these are groups of bodies: the same hues, darker
const BAR_TINTS = ["#735826", "#54458a", "#35693a", "#8c4467", "#0b5a8a", "#525252"];

export function barTint(region) {
  return BAR_TINTS[region % BAR_TINTS.length];
}

export function regionTint(region) {
  return TINTS[region % TINTS.length];
}

// The first scale is for every energy, the second for every other quantity of a map, as in figures and films
// (show/style.py): viridis (Smith and van der Walt 2015) without its darkest end, which a dark page would hide
const ENERGY = ["#453781", "#39568c", "#2d708e", "#20908d", "#29af7f", "#73d055", "#b8de29", "#fde725"];
// cividis (Nunez, Anderton and Renslow 2018)
const QUANTITY = ["#00224e", "#083370", "#35456c", "#4f576c", "#666970", "#7d7c78", "#948e77", "#aea371", "#c8b866", "#e5cf52", "#fee838"];
// yellow to red (Brewer 2002), beginning with a pale colour that differs from hidden parts
const STRAIN = ["#ffffcc", "#ffeda0", "#fed976", "#feb24c", "#fd8c3c", "#fc4d2a", "#e2191c", "#bb0026", "#800026"];

/** Colours by a share of the largest value, 0 to 1: `at` returns sRGB from 0 to 1, `gradient` a style. */
function palette(stops) {
  const numbers = stops.map((colour) => [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16) / 255));
  function at(share, into = [0, 0, 0]) {
    const place = Math.min(1, Math.max(0, share)) * (stops.length - 1);
    const step = Math.min(stops.length - 2, Math.floor(place));
    for (let part = 0; part < 3; part++) {
      const from = numbers[step][part];
      into[part] = from + (place - step) * (numbers[step + 1][part] - from);
    }
    return into;
  }
  return { at, gradient: `linear-gradient(to right, ${stops.join(", ")})` };
}

export const ENERGY_COLOURS = palette(ENERGY);
export const QUANTITY_COLOURS = palette(QUANTITY);
export const STRAIN_COLOURS = palette(STRAIN);

let styled = null; // element whose colours are used; null for those of the page

/** A colour of the page's style, such as "--ink". */
export function styleColour(name) {
  return getComputedStyle(styled ?? document.documentElement).getPropertyValue(name).trim();
}

/** Take colours from a light page, as for drawings to save; returns a function that ends this. */
export function beginPaper() {
  const paper = document.createElement("div");
  paper.className = "paper";
  document.body.append(paper);
  styled = paper;
  return () => {
    styled = null;
    paper.remove();
  };
}

/** Make something in the colours of a light page. */
export function onPaper(act) {
  const end = beginPaper();
  try {
    return act();
  } finally {
    end();
  }
}

/** Listen to changes between light and dark; returns a function that ends this. */
export function onSchemeChange(listener) {
  const dark = matchMedia("(prefers-color-scheme: dark)");
  dark.addEventListener("change", listener);
  return () => dark.removeEventListener("change", listener);
}

const DASHES = [[], [8, 4], [8, 3, 2, 3], [2, 3]];
const LINES = 7;

/** Colour and dash of a plot's line by its number. */
export function lineLook(index) {
  return { colour: styleColour(`--line-${index % LINES}`), dash: DASHES[index % DASHES.length] };
}
