/** The page of a study: a map, the run behind each of its cells, and all points in a table. */

import "./study.css";
import { make } from "./elements.js";
import { makeMap } from "./study-map.js";
import { makeModel } from "./study-model.js";
import { makeRunPanel } from "./study-run.js";
import { extendTable } from "./study-table.js";

export function showStudy(data) {
  const model = makeModel(data.study, data.runs);
  const panel = makeRunPanel(model);
  const open = (point, transition = null) => {
    panel.open(point, { play: true, transition });
    bringIntoSight(panel);
  };
  const map = makeMap(model, (point, quantity) => open(point, quantity.transition));
  const left = make("div", {}, map.element, panel.facts);
  document.getElementById("explorer").replaceChildren(make("div", { className: "explorer" }, left, panel.element));
  extendTable(document.getElementById("points"), model, data.csv, (point) => {
    map.show(point);
    open(point);
  });
  const first = firstPoint(model, data.runs);
  panel.open(first);
  map.show(first);
  return { model, map, panel, open };
}

/** The first point that can be played, of those that came furthest. */
function firstPoint(model, runs) {
  const ranks = ["\u25cf", "\u25c6", "\u25a0"];
  const rank = (run) => ranks.indexOf(model.word(model.study.verdicts[run.point]).sign) >>> 0;
  return runs.reduce((best, run) => (best === null || rank(run) < rank(best) ? run : best), null)?.point ?? 0;
}

/** Where map and run are not side by side, go to the point's numbers, below which it is played. */
function bringIntoSight({ facts, element }) {
  const { top } = element.getBoundingClientRect();
  if (top >= 0 && top < 0.5 * innerHeight) return;
  const narrow = facts.getBoundingClientRect().left === element.getBoundingClientRect().left;
  const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
  (narrow ? facts : element).scrollIntoView({ behavior: still ? "auto" : "smooth", block: "start" });
}
