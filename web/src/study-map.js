/** A study's map: one quantity over two factors as a grid of cells that can be opened. */

import { elementDrawing } from "./element-drawing.js";
import { make } from "./elements.js";
import { scaleParts, signOf } from "./heat.js";
import { fileName, makeSaveButtons } from "./saving.js";
import { makeScatter, showsBoundaries } from "./study-scatter.js";

const MOST_CELLS = 20_000;
const MOST_NUMBERS = 16; // largest number of columns for which cells contain numbers
const MOST_TICKS = 16;
const LONG_WORD = 12; // letters that fit below a column
const MOVES = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

/** The map with its choices; `open` receives the point of a pressed cell, and the quantity. */
export function makeMap(model, open) {
  const { quantities, sampled } = model.study;
  const varied = model.study.axes.filter((index) => model.sizes[index] > 1);
  const [y, x] = varied.length > 1 ? varied : isList(model.study.factors[varied[0]]) ? [varied[0], null] : [null, varied[0] ?? 0];
  const view = { quantity: quantities[0], x, y, fixed: [...model.study.cuts], current: null, opened: null };
  const place = make("div", { className: "map-place" });
  const legend = make("div", { className: "map-legend" });
  const text = make("p", { className: "note" });
  const draw = () => {
    // numbers over a single factor are points over an axis
    const alone = view.y === null && view.quantity.values && model.sizes.every((size, index) => size === 1 || index === view.x);
    const shown = sampled || alone ? makeScatter(model, view, press) : makeGrid(model, view, press);
    place.replaceChildren(shown.element);
    legend.replaceChildren(...legendParts(model, view.quantity, shown.points), ...(showsBoundaries(model.study, view) ? [boundaryLegend(model.study.boundaries)] : []));
    text.textContent = mapText(model, view.quantity, shown.points);
  };
  const press = (point) => {
    view.current = view.opened = point;
    mark(place, point);
    open(point, view.quantity);
  };
  const chooser = makeChoices(model, view, varied, draw);
  const drawing = () => elementDrawing([place, legend], mapName(model, view).split(";")[0]);
  const saves = makeSaveButtons("the map", () => fileName(view.quantity.title), drawing);
  const head = make("div", { className: "head" }, make("h2", {}, "Map"), saves);
  const element = make("section", { className: "map" }, head, chooser.element, place, legend, text);
  draw();
  return {
    element,
    /** Mark the open point, and display the part of the study that contains it. */
    show(point) {
      view.current = view.opened = point;
      if (!sampled) view.fixed = model.placesOf(point);
      chooser.fill();
      draw();
    },
  };
}

/** Whether a factor's values are long words, which are legible only below one another. */
function isList(factor) {
  return factor?.values.some((value) => typeof value === "string" && value.length > LONG_WORD) ?? false;
}

function mark(place, point) {
  for (const cell of place.querySelectorAll("[data-point]")) {
    const chosen = Number(cell.dataset.point) === point;
    cell.setAttribute("aria-selected", String(chosen));
    cell.tabIndex = chosen ? 0 : -1;
  }
}

/** Choice of the quantity, the factors of the axes, and the values of the others. */
function makeChoices(model, view, varied, draw) {
  const { factors, quantities, sampled } = model.study;
  const element = make("div", { className: "choices" });
  const choice = (label, options, value, act) => {
    const select = make("select", {}, ...options.map(([name, text]) => make("option", { value: String(name) }, text)));
    select.value = String(value);
    select.addEventListener("change", () => {
      act(Number(select.value));
      fill();
      draw();
      // the focused menu was replaced by a new element
      [...element.querySelectorAll("label")].find((each) => each.dataset.name === label)?.querySelector("select").focus();
    });
    return make("label", {}, `${label} `, select);
  };
  const turn = (which, other) => (index) => {
    if (view[other] === index) view[other] = view[which];
    view[which] = index;
  };
  function fill() {
    const parts = [choice("show", quantities.map((each, index) => [index, each.title]), quantities.indexOf(view.quantity), (index) => { view.quantity = quantities[index]; })];
    if (varied.length > 2) {
      const names = varied.map((index) => [index, factors[index].name]);
      parts.push(choice("across", names, view.x, turn("x", "y")), choice("upwards", names, view.y, turn("y", "x")));
    }
    for (const index of varied.filter((each) => !sampled && each !== view.x && each !== view.y)) {
      const values = factors[index].texts.map((text, place) => [place, factors[index].unit ? `${text} ${factors[index].unit}` : text]);
      parts.push(choice(factors[index].name, values, view.fixed[index], (place) => { view.fixed[index] = place; }));
    }
    for (const part of parts) part.dataset.name = part.firstChild.textContent.trim();
    element.replaceChildren(...parts);
  }
  fill();
  return { element, fill };
}

function makeGrid(model, view, press) {
  const { factors } = model.study;
  const [columns, rows] = [view.x, view.y].map((index) => (index === null ? 1 : model.sizes[index]));
  const list = view.x === null;
  if (columns * rows > MOST_CELLS) return { element: make("p", { className: "note" }, "This map has too many cells for a page; see the figures of the study."), points: [] };
  const scale = model.scaleOf(view.quantity);
  const numbers = columns <= MOST_NUMBERS;
  const at = (column, row) => model.pointAt(view.fixed.map((place, index) => (index === view.x ? column : index === view.y ? row : place)));
  const cells = new Map();
  const body = [];
  const points = [];
  for (let line = 0; line < rows; line++) {
    // numbers grow upwards, words follow one another downwards
    const row = list ? line : rows - 1 - line;
    const head = view.y === null ? "" : list ? factors[view.y].texts[row] : tick(factors[view.y], row);
    const cellsOfRow = make("tr", {}, make("th", { scope: "row" }, head));
    for (let column = 0; column < columns; column++) {
      const point = at(column, row);
      const cell = make("td", { tabIndex: -1, role: "gridcell" });
      fillCell(cell, model, view, scale, point, numbers);
      cells.set(`${column} ${row}`, cell);
      points.push(point);
      cellsOfRow.append(cell);
    }
    body.push(cellsOfRow);
  }
  if (!list) {
    const feet = factors[view.x].texts.map((_, column) => make("th", { scope: "col" }, tick(factors[view.x], column)));
    body.push(make("tr", { className: "feet" }, make("td"), ...feet));
  }
  const table = make("table", { role: "grid", className: list ? "grid list" : numbers ? "grid" : "grid small", "aria-label": mapName(model, view) }, make("tbody", {}, ...body));
  table.style.setProperty("--columns", columns);
  table.style.setProperty("--rows", rows);
  const first = [...cells.values()].find((cell) => Number(cell.dataset.point) === view.current) ?? cells.get("0 0");
  first.tabIndex = 0;
  listen(table, cells, press, list);
  const upwards = make("div", { className: "upwards" }, view.y === null || list ? "" : axisText(factors[view.y]));
  const across = make("div", { className: "across" }, list ? "" : axisText(factors[view.x]));
  // a map with few rows has no space for the vertical name
  return { element: make("div", { className: rows < 6 ? "axes low" : "axes" }, upwards, make("div", {}, make("div", { className: "scroll" }, table), across)), points };
}

function fillCell(cell, model, view, scale, point, numbers) {
  const { quantity } = view;
  const value = quantity.values?.[point] ?? null;
  cell.dataset.point = point;
  cell.setAttribute("aria-selected", String(view.opened === point));
  const text = `${model.pointText(point)}: ${quantity.values ? `${quantity.title} ` : ""}${model.valueText(quantity, point)}`;
  cell.setAttribute("aria-label", text);
  cell.title = text;
  if (value === null) {
    const { sign, pattern } = model.word(quantity.reasons[point]);
    cell.className = `what ${pattern}`;
    cell.append(make("span", {}, numbers ? sign : ""));
    return;
  }
  const { face, ink } = scale.colour(value);
  cell.style.background = face;
  cell.style.color = ink;
  cell.textContent = numbers ? scale.text(value) : "";
}

/** Arrow keys move between cells, as in a spreadsheet; enter, space and a press open one. */
function listen(table, cells, press, list) {
  const places = new Map([...cells].map(([place, cell]) => [cell, place.split(" ").map(Number)]));
  table.addEventListener("click", (event) => {
    const cell = event.target.closest("[data-point]");
    if (cell) press(Number(cell.dataset.point));
  });
  table.addEventListener("keydown", (event) => {
    const cell = event.target.closest("[data-point]");
    if (!cell || event.ctrlKey || event.metaKey || event.altKey) return;
    const [column, row] = places.get(cell);
    const [right, raised] = MOVES[event.key] ?? [0, 0];
    const up = list ? -raised : raised;
    const columns = Math.max(...[...places.values()].map(([each]) => each));
    const there = { Home: `0 ${row}`, End: `${columns} ${row}` }[event.key] ?? `${column + right} ${row + up}`;
    if (event.key === "Enter" || event.key === " ") press(Number(cell.dataset.point));
    else if (!(event.key in MOVES) && event.key !== "Home" && event.key !== "End") return;
    else if (cells.has(there)) {
      cell.tabIndex = -1;
      cells.get(there).tabIndex = 0;
      cells.get(there).focus();
    }
    event.preventDefault();
  });
}

/** Meaning of the colours and patterns. */
function legendParts(model, quantity, points) {
  const parts = scaleParts(model, quantity);
  const reasons = [...countReasons(quantity, points)].map(([number, count]) => {
    const entry = model.word(number);
    return make("li", {}, signOf(entry), `${entry.word} (${count})`);
  });
  if (reasons.length) parts.push(make("ul", {}, ...reasons));
  return parts;
}

/** The lines of a study that locates boundaries. */
function boundaryLegend({ text }) {
  const entry = (name, text) => make("li", {}, make("span", { className: `line ${name}`, "aria-hidden": "true" }), text);
  return make("ul", {}, entry("boundary", `${text}, a straight line in each cell`), entry("cell-outline", "side of a cell"));
}

function countReasons(quantity, points) {
  const counts = new Map();
  for (const point of points) {
    const reason = quantity.reasons[point];
    if (reason !== null) counts.set(reason, (counts.get(reason) ?? 0) + 1);
  }
  return new Map([...counts].sort(([first], [second]) => first - second));
}

/** The map in a sentence or two. */
function mapText(model, quantity, points) {
  const known = points.filter((point) => (quantity.values?.[point] ?? null) !== null);
  const reasons = [...countReasons(quantity, points)].map(([number, count]) => `${count} ${model.word(number).word}`);
  const title = `${quantity.title[0].toUpperCase()}${quantity.title.slice(1)}`;
  const noun = `${model.study.noun}s`;
  if (!known.length) return `${title} of ${points.length} ${noun}: ${reasons.join(", ") || "none"}.`;
  const rest = reasons.length ? ` Other ${noun}: ${reasons.join(", ")}.` : "";
  const [least, most] = [Math.min, Math.max].map((pick) => endText(model, quantity, known, pick));
  return `${title}, known for ${known.length} of ${points.length} ${noun}: from ${least} to ${most}.${rest}`;
}

/** The least or the largest value, and its point, or the number of such points. */
function endText(model, quantity, points, pick) {
  const value = points.map((point) => quantity.values[point]).reduce((first, second) => pick(first, second));
  const there = points.filter((point) => quantity.values[point] === value);
  const where = there.length > 1 ? `${there.length} ${model.study.noun}s` : model.pointText(there[0]);
  return `${model.valueText(quantity, there[0])} (${where})`;
}

function mapName(model, view) {
  const { factors } = model.study;
  const over = view.y === null || view.x === null ? factors[view.x ?? view.y].name : `${factors[view.x].name} across and ${factors[view.y].name} upwards`;
  return `${view.quantity.title} over ${over}; arrows move between cells, enter opens one`;
}

function axisText(factor) {
  return factor.unit ? `${factor.name} (${factor.unit})` : factor.name;
}

/** A value beside its row or column, if there is space for all or it is a selected one. */
function tick(factor, place) {
  const step = Math.ceil(factor.texts.length / MOST_TICKS);
  return place % step ? "" : factor.texts[place];
}
