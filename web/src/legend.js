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
  const table = entries.find(({ sample }) => sample === "table");
  const grid = table ? `grid on the ${table.text}` : "grid";
  return make(
    "ul",
    { className: "legend" },
    ...entries.filter(({ sample }) => sample !== "table").map(({ sample, text }) => (sample === "tendon" ? energyEntry(text, energy) : entry(sample, text))),
    ...(entries.some(({ sample }) => sample === "tendon") ? [make("li", {}, "slack tendons sag, drawn with their rest length")] : []),
    make("li", {}, `squares of the ${grid}: ${readable(squareSide(size), "m")}`),
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
  // the energy may exceed the run's maximum when a reader moves the structure
  return scaleEntry(text, "0", ENERGY_COLOURS, `${short(energy.factor * energy.largest_J)} ${energy.unit}${energy.orMore ? " or more" : ""}`);
}

/** Scale of colours between two texts, on one line. */
export function scaleEntry(text, low, colours, high) {
  const bar = swatch("bar", { background: colours.gradient });
  return make("li", { className: "energy" }, `${text}: `, make("span", { className: "whole" }, low, bar, high));
}

/** A text that changes while the structure moves, in a box with room for any of `texts`, so that nothing else moves. */
export function roomyText(texts) {
  const said = make("span");
  const measure = document.createElement("canvas").getContext("2d");
  measure.font = "14px system-ui, sans-serif";
  const widths = new Map([...new Set(texts)].map((text) => [text, measure.measureText(text).width]));
  const longest = [...widths.keys()].reduce((most, text) => (widths.get(text) > widths.get(most) ? text : most));
  const room = make("span", { className: "room", "aria-hidden": "true" }, longest);
  return { element: make("span", { className: "roomy" }, room, said), say: (text) => { said.textContent = text; } };
}

function swatch(kind, style) {
  const sample = make("span", { className: `swatch ${kind}`, "aria-hidden": "true" });
  Object.assign(sample.style, style);
  return sample;
}
