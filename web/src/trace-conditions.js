/** The table of the flat-folding conditions at the vertices of a drawn pattern. */

import { make } from "./elements.js";
import { failsAt, kawasakiText, verdictAt } from "./trace-drawing.js";

const HEADS = ["vertex", "creases", "alternating sum of sectors (Kawasaki)", "|mountains \u2212 valleys| (Maekawa)", "within 1\u00b0 and exactly 2"];

const ANSWERS = { failing: "no", holding: "yes", unknown: "not known" };

/** Make the table; `select` receives the number of a vertex. */
export function makeConditions(select) {
  const summary = make("summary");
  const body = make("tbody");
  const head = make("thead", {}, make("tr", {}, ...HEADS.map((text) => make("th", { scope: "col" }, text))));
  const table = make("div", { className: "table", tabIndex: 0, role: "group", "aria-label": "conditions of flat folding" }, make("table", {}, head, body));
  const element = make("details", { className: "trace-conditions", open: true }, summary, table);

  let last = [];

  function show(conditions, rectified) {
    // the table is not built again while the pointer only moves
    if (last[0] === conditions && last[1] === rectified) return;
    last = [conditions, rectified];
    const failing = conditions.filter(failsAt).length;
    const where = rectified ? "" : " Angles are those in the picture until the scale is set.";
    const count = `${conditions.length} ${conditions.length === 1 ? "vertex" : "vertices"} inside the sheet`;
    summary.textContent = `Flat folding: ${conditions.length ? `${failing} of ${count} fail${failing === 1 ? "s" : ""}.` : "no vertices inside the sheet yet."}${where}`;
    table.hidden = !conditions.length;
    body.replaceChildren(
      ...conditions.map((condition) => {
        const { vertex, creases, maekawa } = condition;
        const button = make("button", { type: "button", title: "select this vertex" }, String(vertex));
        button.addEventListener("click", () => select(vertex));
        const odd = condition.kawasaki === null;
        const difference = creases ? (maekawa === null ? "unassigned edges" : maekawa + 2) : "no creases";
        const cells = [button, creases, odd ? "never flat: odd number" : kawasakiText(condition), difference, ANSWERS[verdictAt(condition)]];
        return make("tr", failsAt(condition) ? { className: "failing" } : {}, ...cells.map((cell) => make("td", {}, typeof cell === "number" ? String(cell) : cell)));
      }),
    );
  }

  return { element, show };
}
