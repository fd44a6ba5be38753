/** What the colours of the picture mean, and how large the wing is. */

import { make } from "./elements.js";
import { squareSide } from "./floor.js";
import { short } from "./format.js";
import { DISTAL, ENERGY_GRADIENT, MOUNTAIN, PROXIMAL, VALLEY } from "./scheme.js";

const OF_SEVERAL = [
  "all wings are drawn to one scale",
  "marks on the time line: the states of each run, in its colour",
];

export function makeLegend(energy, size, several) {
  const swatch = (kind, style) => {
    const sample = make("span", { className: `swatch ${kind}`, "aria-hidden": "true" });
    Object.assign(sample.style, style);
    return sample;
  };
  const entry = (sample, text) => make("li", {}, sample, text);
  const bar = make(
    "li",
    { className: "energy" },
    "tendon, energy stored: 0",
    swatch("bar", { background: ENERGY_GRADIENT }),
  );
  bar.append(`${short(energy.factor * energy.largest_J)} ${energy.unit}`);
  return make(
    "ul",
    { className: "legend" },
    entry(swatch("mountain", { color: MOUNTAIN }), "mountain (dash-dotted ring fold, veins)"),
    entry(swatch("valley", { color: VALLEY }), "valley (dashed ring fold, veins)"),
    entry(swatch("border", {}), "vein at the rim"),
    entry(swatch("panel", { background: PROXIMAL }), "proximal panel"),
    entry(swatch("panel", { background: DISTAL }), "distal panel"),
    entry(swatch("joint", {}), "hinge"),
    bar,
    make("li", {}, `squares of the grid: ${lengthText(squareSide(size))}`),
    ...(several ? OF_SEVERAL.map((text) => make("li", {}, text)) : []),
  );
}

function lengthText(length) {
  const [unit, factor] =
    length >= 1 ? ["m", 1] : length >= 0.01 ? ["cm", 100] : length >= 1e-4 ? ["mm", 1e3] : ["\u00b5m", 1e6];
  return `${short(factor * length)} ${unit}`;
}
