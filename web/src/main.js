/** Show what the page's data are. */

import "./page.css";
import { showComparison } from "./page-compare.js";
import { showRun } from "./page-run.js";
import { showStudy } from "./page-study.js";
import { watchTables } from "./tables.js";

const PAGES = { run: showRun, compare: showComparison, study: showStudy };

const data = JSON.parse(document.getElementById("data").textContent);
// for those who want the numbers behind the picture, and for tests
window.forficula = PAGES[data.kind](data);
watchTables();
