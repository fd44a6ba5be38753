/** Pages of goals: points as lines and in planes, runs that were kept, and all points in a table. */

import "./study.css";
import "./goals.css";
import { make } from "./elements.js";
import { makeLines } from "./goal-lines.js";
import { makeGoalModel } from "./goal-model.js";
import { makePairs } from "./goal-pairs.js";
import { makePlane } from "./goal-plane.js";
import { bringIntoSight } from "./page-study.js";
import { makeRunPanel } from "./study-run.js";
import { extendTable } from "./study-table.js";

export function showGoals(data) {
  const { views } = data;
  const model = makeGoalModel(data.study, data.runs);
  const panel = makeRunPanel(model);
  const parts = [];
  const choose = (point, play) => {
    panel.open(point, { play });
    for (const part of parts) part.show?.(point);
  };
  const open = (point) => {
    choose(point, true);
    bringIntoSight(panel);
  };
  const lines = makeLines(model, views.lines, views, open);
  const joined = model.columns.filter((column) => column.aim).length === 2;
  const plane = makePlane(model, { ...views, joined }, open);
  const pairs = views.pairs?.length ? makePairs(model, views, showPair) : null;
  parts.push(lines, plane);
  function showPair(across, upwards) {
    plane.over(across, upwards);
    plane.element.scrollIntoView({ block: "start" });
  }
  // without runs there is space for the numbers
  const sides = data.runs.length ? [[plane.element, panel.facts], [panel.element]] : [[plane.element], [panel.facts]];
  const beside = make("div", { className: "explorer" }, ...sides.map((side) => make("div", {}, ...side)), panel.below);
  const elements = { lines: lines.element, pairs: pairs?.element, plane: beside };
  document.getElementById("explorer").replaceChildren(...views.order.map((name) => elements[name]));
  const refresh = extendTable(document.getElementById("points"), model, data.csv, open);
  model.whenAsked(refresh);
  if (data.study.points) choose(firstPoint(model, data), false);
  return { model, panel, lines, plane, open };
}

/** The best point if it can be played; else the first good one that can, the first that can, the best, the first. */
function firstPoint(model, { runs, views, study }) {
  const { best } = views;
  const played = runs.map((run) => run.point);
  if (best !== null && played.includes(best)) return best;
  return played.find((point) => model.good(point)) ?? played[0] ?? best ?? study.verdicts.findIndex((_, point) => model.good(point) || point === study.points - 1);
}
