/** Points of a goal on a page: their columns, and the points that the reader's selected ranges leave out. */

import { scaleOf } from "./plane.js";
import { makeModel } from "./study-model.js";

export function makeGoalModel(study, runs) {
  const model = makeModel(study, runs);
  const factors = study.factors.map((factor) => ({ ...factor, limits: [], aim: "" }));
  const numbers = model.numbers.map((quantity) => ({ ...quantity, key: quantity.name, name: quantity.title, log: false, own: null }));
  const columns = [...factors, ...numbers].map((column) => ({ ...column, scale: scaleOf(column, nearBounds(column)) }));
  const asked = new Map();
  const listeners = [];
  const within = ([index, [low, high]], point) => {
    const value = columns[index].values[point];
    if (value === null) return false;
    const share = columns[index].scale.share(value);
    return share >= low - 1e-9 && share <= high + 1e-9;
  };
  return {
    ...model,
    columns,
    asked,
    indexOf: (key) => columns.findIndex((column) => column.key === key),
    shown: (point) => [...asked].every((each) => within(each, point)),
    good: (point) => model.word(study.verdicts[point]).good,
    nameOf: (point) => `${study.noun} ${point + 1}: `,
    whenAsked: (listener) => listeners.push(listener),
    /** Select shares of a column's scale from a low to a high one; the whole scale selects everything. */
    ask(index, low, high) {
      if (low <= 0 && high >= 1) asked.delete(index);
      else asked.set(index, [low, high]);
      for (const listener of listeners) listener();
    },
    /** Remove all selections. */
    forget() {
      asked.clear();
      for (const listener of listeners) listener();
    },
  };
}

/** Limits close enough to the values to share a scale. */
function nearBounds({ limits, values }) {
  const numbers = values.filter((value) => typeof value === "number");
  const [low, high] = [Math.min(...numbers), Math.max(...numbers)];
  return limits.map((limit) => limit.bound).filter((bound) => bound >= low - (high - low) && bound <= high + (high - low));
}
