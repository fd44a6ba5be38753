/**
 * A study on a page: its points, numbered in the table's order, in which the last factor varies fastest, and their
 * results. Numbers are in the units beside them.
 */

import { cellColour, coloursOf } from "./heat.js";

export function makeModel(study, runs) {
  const { factors, quantities, words } = study;
  const sizes = factors.map((factor) => factor.values.length);
  const runsOf = new Map();
  for (const run of runs) runsOf.set(run.point, [...(runsOf.get(run.point) ?? []), run]);

  /** Index of each factor's value at a point. */
  function placesOf(point) {
    if (study.sampled) return factors.map(() => point);
    const places = [];
    for (let index = sizes.length - 1; index >= 0; index--) {
      places[index] = point % sizes[index];
      point = Math.floor(point / sizes[index]);
    }
    return places;
  }

  const pointAt = (places) => places.reduce((point, place, index) => point * sizes[index] + place, 0);

  function scaleOf(quantity) {
    // groups that share a scale can be compared
    const sameGroup = quantity.shares ? quantities.filter((each) => each.group === quantity.group) : [quantity];
    const values = sameGroup.flatMap((each) => each.values ?? []).filter((value) => value !== null);
    if (!values.length) return null;
    const [low, high] = [values.reduce((a, b) => Math.min(a, b)), values.reduce((a, b) => Math.max(a, b))];
    const share = (value) => (high > low ? (value - low) / (high - low) : 0.5);
    const digits = decimals((quantity.values ?? []).filter((value) => value !== null));
    return { low, high, colour: (value) => cellColour(coloursOf(quantity), share(value)), text: (value) => numberText(Number(value.toFixed(digits))) };
  }

  const factorText = (factor, place) => `${factor.name} ${factor.texts[place]}${factor.unit ? ` ${factor.unit}` : ""}`;

  return {
    study,
    sizes,
    /** Quantities with one value for each point. */
    numbers: quantities.filter((quantity) => quantity.values && !quantity.tried),
    /** Columns that can be an axis. */
    columns: factors,
    /** Whether a point is displayed. */
    shown: () => true,
    /** Words before the text of a point. */
    nameOf: () => "",
    placesOf,
    pointAt,
    scaleOf,
    factorText,
    /** Length of the largest structure that can be played, m. */
    largestSpan: runs.reduce((most, run) => Math.max(most, run.play.clips[0].span_m), 0),
    runsOf: (point) => runsOf.get(point) ?? [],
    word: (number) => words[number],
    pointText: (point) => placesOf(point).map((place, index) => factorText(factors[index], place)).join(", "),
    /** A quantity at a point in words: its value, or the reason why it is missing. */
    valueText(quantity, point) {
      const value = quantity.values?.[point] ?? null;
      return value === null ? words[quantity.reasons[point]].word : `${numberText(value)} ${quantity.unit}`;
    },
  };
}

/** Decimals for three digits of the largest value. */
function decimals(values) {
  const largest = values.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
  return Math.min(20, Math.max(0, 2 - Math.floor(Math.log10(largest || 1))));
}

/** At most three significant digits, with real minus signs; small numbers as powers of ten. */
export function numberText(value) {
  const number = Number(value.toPrecision(3));
  const small = number !== 0 && Math.abs(number) < 1e-3;
  return (small ? number.toExponential() : String(number)).replaceAll("-", "\u2212");
}
