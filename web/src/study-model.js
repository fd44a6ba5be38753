/**
 * A study on a page: its points, numbered in the table's order, in which the last factor runs fastest, and what is
 * known of each. Numbers are in the units that stand beside them.
 */

import { cellColour, coloursOf } from "./heat.js";

export function makeModel(study, runs) {
  const { factors, quantities, words } = study;
  const sizes = factors.map((factor) => factor.values.length);
  const runsOf = new Map();
  for (const run of runs) runsOf.set(run.point, [...(runsOf.get(run.point) ?? []), run]);

  /** Number of each factor's value at a point. */
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
    // of one group that shares a scale, so that their maps can be compared
    const alike = quantity.shares ? quantities.filter((each) => each.group === quantity.group) : [quantity];
    const values = alike.flatMap((each) => each.values ?? []).filter((value) => value !== null);
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
    /** What a point may have one value of beside its factors. */
    numbers: quantities.filter((quantity) => quantity.values && !quantity.tried),
    /** What points can lie over. */
    columns: factors,
    /** Whether a point is not left out. */
    shown: () => true,
    /** What a point is called before what it is. */
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
    /** A quantity at a point in words: its value, or why there is none. */
    valueText(quantity, point) {
      const value = quantity.values?.[point] ?? null;
      return value === null ? words[quantity.reasons[point]].word : `${numberText(value)} ${quantity.unit}`;
    },
  };
}

/** Decimals that the largest of some values needs for three digits. */
function decimals(values) {
  const largest = values.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
  return Math.min(20, Math.max(0, 2 - Math.floor(Math.log10(largest || 1))));
}

/** Three significant digits at most, with minus signs that are such; small numbers as powers of ten. */
export function numberText(value) {
  const number = Number(value.toPrecision(3));
  const small = number !== 0 && Math.abs(number) < 1e-3;
  return (small ? number.toExponential() : String(number)).replaceAll("-", "\u2212");
}
