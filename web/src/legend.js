/** Meaning of the colours of the picture, and size of the structure. */

import { make } from "./elements.js";
import { squareSide } from "./floor.js";
import { readable, short } from "./format.js";
import { ENERGY_COLOURS, MOUNTAIN, VALLEY, regionTint } from "./scheme.js";

/** entries: {sample, text} of drawn parts; whole: noun for one of several structures, or null for a single one. */
export function makeLegend(entries, energy, size, whole) {
  const ofSeveral = whole
    ? ["marks on the time line: the states of each run, in its colour"]
    : [];
  return make(
    "ul",
    { className: "legend" },
    ...entries.map(({ sample, text }) => (sample === "tendon" ? energyEntry(text, energy) : entry(sample, text))),
    ...(entries.some(({ sample }) => sample === "tendon") ? [make("li", {}, "slack tendons sag, drawn with their rest length")] : []),
    make("li", {}, `squares of the grid: ${readable(squareSide(size), "m")}`),
    ...ofSeveral.map((text) => make("li", {}, text)),
  );
}

function entry(sample, text) {
  const [kind, region] = sample.split(" ");
  const look = { mountain: { color: MOUNTAIN }, valley: { color: VALLEY }, region: { background: regionTint(region) } };
  const className = kind === "region" ? "of-region" : "";
  return make("li", { className }, swatch(kind === "region" ? "panel" : kind, look[kind] ?? {}), text);
}

function energyEntry(text, energy) {
  const bar = make("li", { className: "energy" }, `${text}: 0`, gradientSwatch(ENERGY_COLOURS));
  // the energy may exceed the run's maximum when a reader moves the structure
  bar.append(`${short(energy.factor * energy.largest_J)} ${energy.unit}${energy.orMore ? " or more" : ""}`);
  return bar;
}

export function gradientSwatch(colours) {
  return swatch("bar", { background: colours.gradient });
}

function swatch(kind, style) {
  const sample = make("span", { className: `swatch ${kind}`, "aria-hidden": "true" });
  Object.assign(sample.style, style);
  return sample;
}
