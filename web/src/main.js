/** Show what the page's data are. */

import "./page.css";
import { make } from "./elements.js";
import { showComparison } from "./page-compare.js";
import { showCurves } from "./page-curves.js";
import { showRun } from "./page-run.js";
import { showStudy } from "./page-study.js";
import { watchTables } from "./tables.js";

const PAGES = { run: showRun, compare: showComparison, curves: showCurves, study: showStudy };

const data = JSON.parse(document.getElementById("data").textContent);
// for those who want the numbers behind the picture, and for tests
try {
  window.forficula = PAGES[data.kind](data);
} catch (error) {
  const said = `What moves cannot be shown in this browser (${error.message}); the numbers below are all there.`;
  document.querySelector("main").prepend(make("p", { className: "note", role: "alert" }, said));
  throw error;
}
watchTables();
