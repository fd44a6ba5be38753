/** The table of all points: filter by outcome, sort by any column, download. */

import { make } from "./elements.js";
import { signOf } from "./heat.js";

/**
 * Add controls to the page's table; `open` receives the point of a row whose number is pressed. The returned function
 * hides and shows rows again, after the model has left points out.
 */
export function extendTable(section, model, csv, open) {
  const table = section?.querySelector("table");
  if (!table) return () => {};
  const rows = [...table.tBodies[0].rows];
  const count = make("p", { className: "note", role: "status" });
  const filter = statusFilter(model, () => {
    const shown = filter.shown();
    let left = 0;
    for (const [point, row] of rows.entries()) {
      row.hidden = !shown.has(model.study.verdicts[point]) || !model.shown(point);
      left += row.hidden ? 0 : 1;
    }
    count.textContent = `${left} of ${rows.length} ${model.study.noun}s shown.`;
  });
  for (const [point, row] of rows.entries()) {
    const number = make("button", { type: "button", "aria-label": `open ${model.study.noun} ${point + 1}` }, row.cells[0].textContent);
    number.addEventListener("click", () => open(point));
    row.cells[0].replaceChildren(number);
  }
  const words = model.study.factors.length + 1;
  for (const row of [table.tHead.rows[0], ...rows]) row.cells[words].classList.add("words");
  makeSortable(table, rows, sortKeys(model));
  const tools = make("div", { className: "choices" }, filter.element, ...(csv ? [downloadButton(csv, model.study.file)] : []));
  table.closest(".table").before(tools, count);
  filter.changed();
  return filter.changed;
}

function statusFilter(model, changed) {
  const boxes = new Map();
  const labels = model.study.words.flatMap((entry, number) => {
    if (!entry.count) return [];
    const box = make("input", { type: "checkbox", checked: true });
    box.addEventListener("change", changed);
    boxes.set(number, box);
    return [make("label", {}, box, signOf(entry), `${entry.word} (${entry.count})`)];
  });
  const element = make("fieldset", { className: "filter" }, make("legend", {}, `Show ${model.study.noun}s that`), ...labels);
  return { element, changed, shown: () => new Set([...boxes].filter(([, box]) => box.checked).map(([number]) => number)) };
}

/** Sort keys of each column: a list with one entry for each point. */
function sortKeys(model) {
  const { study } = model;
  const points = study.statuses.map((_, point) => point);
  const factors = study.factors.map((factor, index) => points.map((point) => factor.values[model.placesOf(point)[index]]));
  const numbers = model.numbers.map((each) => each.values);
  return [points, ...factors, study.statuses, ...numbers];
}

/** Headings that sort the rows: up, then down; missing values are last in both cases. */
function makeSortable(table, rows, keys) {
  const headings = [...table.tHead.rows[0].cells];
  for (const [column, heading] of headings.entries()) {
    const button = make("button", { type: "button" }, ...heading.childNodes);
    heading.replaceChildren(button);
    button.addEventListener("click", () => {
      const down = heading.getAttribute("aria-sort") === "ascending";
      for (const each of headings) each.removeAttribute("aria-sort");
      heading.setAttribute("aria-sort", down ? "descending" : "ascending");
      const order = rows.map((_, point) => point).sort((first, second) => compare(keys[column][first], keys[column][second], down ? -1 : 1) || first - second);
      table.tBodies[0].append(...order.map((point) => rows[point]));
    });
  }
  headings[0].setAttribute("aria-sort", "ascending");
}

function compare(first, second, direction) {
  if (first === null || second === null) return (first === null) - (second === null);
  const order = typeof first === "number" ? first - second : String(first).localeCompare(String(second), "en");
  return direction * order;
}

/** Download of the file in the study's folder. */
function downloadButton(csv, file) {
  const button = make("button", { type: "button", className: "button" }, `Download ${file}`);
  button.addEventListener("click", () => {
    const address = URL.createObjectURL(new Blob([csv], { type: "text/csv;charset=utf-8" }));
    make("a", { href: address, download: file }).click();
    setTimeout(() => URL.revokeObjectURL(address), 10_000);
  });
  return button;
}
