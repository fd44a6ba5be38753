/** Page of a study: a map, the run behind each of its cells, and all points in a table. */

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
  // without runs there is space for the numbers
  const sides = data.runs.length ? [[map.element, panel.facts], [panel.element]] : [[map.element], [panel.facts, panel.element]];
  document.getElementById("explorer").replaceChildren(make("div", { className: "explorer" }, ...sides.map((side) => make("div", {}, ...side)), panel.below));
  extendTable(document.getElementById("points"), model, data.csv, (point) => {
    map.show(point);
    open(point);
  });
  const first = firstPoint(model, data.runs);
  panel.open(first);
  map.show(first);
  return { model, map, panel, open };
}

/** The point to play first: of the most successful ones the one with the least torques, in the order of the drives. */
function firstPoint(model, runs) {
  const least = model.study.quantities.filter((quantity) => quantity.group === "torque");
  const keys = (point) => [model.study.verdicts[point], ...least.map((quantity) => quantity.values[point] ?? Infinity), point];
  const before = (first, second) => {
    const place = first.findIndex((value, index) => value !== second[index]);
    return place >= 0 && first[place] < second[place];
  };
  const points = runs.map((run) => run.point);
  return points.reduce((best, point) => (best === null || before(keys(point), keys(best)) ? point : best), null) ?? 0;
}

/** If map and run are not side by side, scroll to the point's numbers, below which it is played. */
export function bringIntoSight({ facts, element }) {
  const { top } = element.getBoundingClientRect();
  if (top >= 0 && top < 0.5 * innerHeight) return;
  const narrow = facts.getBoundingClientRect().left === element.getBoundingClientRect().left;
  const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
  (narrow ? facts : element).scrollIntoView({ behavior: still ? "auto" : "smooth", block: "start" });
}
