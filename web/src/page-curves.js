/** Page of curves of a structure without a run and without a fold path: a slider moves a ball on each curve. */

import { mountCurves } from "./curves.js";

export function showCurves(data) {
  return { curves: mountCurves(document.getElementById("curves"), data.curves) };
}
