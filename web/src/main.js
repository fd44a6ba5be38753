/** Start the view for the kind of the page's data. */

import "./page.css";
import "./try.css";
import "./bench.css";
import "./trace.css";
import { make } from "./elements.js";
import { mountFigures } from "./figures.js";
import { takeUnits } from "./format.js";
import { showBench } from "./page-bench.js";
import { showComparison } from "./page-compare.js";
import { showGoals } from "./page-goals.js";
import { showParts } from "./page-parts.js";
import { showRun } from "./page-run.js";
import { showStudy } from "./page-study.js";
import { showWorkbench } from "./page-workbench.js";
import { watchTables } from "./tables.js";

const PAGES = {
  run: showRun,
  compare: showComparison,
  curves: showRun,
  study: showStudy,
  goals: showGoals,
  parts: showParts,
  bench: showBench,
  workbench: showWorkbench,
};

const data = JSON.parse(document.getElementById("data").textContent);
takeUnits(data.reading_units);

/** Report that the page's script failed, and stop. */
function fail(error) {
  const said = `Moving pictures cannot be shown in this browser (${error.message}); all numbers are below.`;
  document.querySelector("main").prepend(make("p", { className: "note", role: "alert" }, said));
  throw error;
}

/** Expose the numbers behind the picture, for readers and for tests. */
function keep(shown) {
  window.forficula = shown;
}

try {
  const shown = PAGES[data.kind](data);
  if (shown instanceof Promise) shown.then(keep, fail);
  else keep(shown);
} catch (error) {
  fail(error);
}
mountFigures();
watchTables();
