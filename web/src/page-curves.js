/** The page of curves without a run: balls that a slider moves. */

import { mountCurves } from "./curves.js";

export function showCurves(data) {
  return { curves: mountCurves(document.getElementById("curves"), data.curves) };
}
