/** Parallel coordinates: every point is a line across axes; a reader can select a range on every axis. */

import { elementDrawing } from "./element-drawing.js";
import { make } from "./elements.js";
import { draw } from "./plane.js";
import { fileName, makeSaveButtons } from "./saving.js";
import { numberText } from "./study-model.js";

const HEIGHT = 300;
const ENDS = 30; // space for the handles, above and below the axes
const LEAST_WIDE = 92; // width of an axis with its letters
const REACH = 16; // distance from the pointer to a line
const DRAGGED = 5; // movement of a pointer up to which it counts as a press

/** The lines with their axes, `keys` of the columns displayed first; pressing a line calls `press`. */
export function makeLines(model, keys, { best, best_word, front }, press) {
  const chosen = new Set(keys.map(model.indexOf).filter((index) => index >= 0));
  const view = { axes: [...chosen], opened: null, hovered: null, best, bestWord: best_word, front };
  const titles = make("div", { className: "titles" });
  const place = make("div", { className: "drawn" });
  const board = make("div", { className: "board" }, titles, place);
  const scroll = make("div", { className: "scroll" }, board);
  const said = make("p", { className: "note", role: "status" });
  const under = make("p", { className: "note under" }, "\u00a0");
  const all = make("button", { type: "button" }, `show all ${model.study.noun}s`);
  all.addEventListener("click", () => {
    model.forget();
    // the focused element no longer exists
    place.querySelector("[role=slider]")?.focus();
  });
  const redraw = () => {
    drawBoard(model, view, { board, titles, place, width: scroll.clientWidth });
    layers(model, view, place);
  };
  const hint = "Press a line to open its run. Move the two handles of an axis to select a range of values.";
  const key = legend(model, view);
  const title = `All ${model.study.noun}s as lines`;
  const saves = makeSaveButtons(title, () => fileName(title), () => elementDrawing([board, key], title, ".handle"));
  const head = make("div", { className: "head" }, make("h2", {}, title), saves);
  const element = make("section", { className: "lines" }, head, make("p", { className: "note" }, hint), axisChoice(model, view, redraw), scroll, key, make("div", { className: "choices" }, all, said), under);
  listen(model, view, place, under, press);
  model.whenAsked(() => {
    layers(model, view, place);
    handles(model, view, place);
    report(model, said, all);
  });
  report(model, said, all);
  let width = 0;
  new ResizeObserver(() => {
    if (scroll.clientWidth === width) return;
    width = scroll.clientWidth;
    redraw();
  }).observe(scroll);
  return {
    element,
    show(point) {
      view.opened = point;
      layers(model, view, place);
    },
  };
}

function report(model, said, all) {
  const { points, noun } = model.study;
  const left = Array.from({ length: points }, (_, point) => point).filter(model.shown);
  const good = left.filter(model.good).length;
  const word = model.study.words.find((each) => each.good)?.word;
  said.textContent = `${left.length} of ${points} ${noun}s lie within the selected ranges${word ? `; ${word}: ${good}` : ""}.`;
  all.hidden = model.asked.size === 0;
}

/** Choice of the columns with an axis. */
function axisChoice(model, view, redraw) {
  const boxes = model.columns.map((column, index) => {
    const box = make("input", { type: "checkbox", checked: view.axes.includes(index) });
    box.addEventListener("change", () => {
      view.axes = model.columns.map((_, each) => each).filter((each) => (each === index ? box.checked : view.axes.includes(each)));
      if (!box.checked) model.ask(index, 0, 1);
      redraw();
    });
    return make("label", {}, box, column.name);
  });
  return make("details", {}, make("summary", {}, "Axes"), make("fieldset", { className: "filter" }, make("legend", {}, "Show an axis of"), ...boxes));
}

function legend(model, view) {
  const entry = (kind, text) => make("li", {}, make("span", { className: `line ${kind}`, "aria-hidden": "true" }), text);
  const good = model.study.words.find((each) => each.good);
  const parts = [];
  if (good) parts.push(entry("good", good.word));
  if (model.study.words.some((each) => !each.good)) parts.push(entry("behind", good ? `other ${model.study.noun}s` : `all ${model.study.noun}s`));
  if (view.front.length) parts.push(entry("front", "Pareto front"));
  if (view.best !== null) parts.push(entry("best", view.bestWord));
  parts.push(entry("opened", "open"));
  if (model.columns.some((column) => column.limits.length)) parts.push(make("li", {}, make("span", { className: "bound", "aria-hidden": "true" }), "range allowed by a limit"));
  return make("ul", { className: "keys-of-lines" }, ...parts);
}

function drawBoard(model, view, { board, titles, place, width }) {
  const count = view.axes.length;
  const wide = Math.max(width, count * LEAST_WIDE);
  board.style.width = `${wide}px`;
  titles.replaceChildren(...view.axes.map((index) => axisTitle(model.columns[index])));
  titles.style.gridTemplateColumns = `repeat(${count}, 1fr)`;
  view.x = (number) => ((number + 0.5) * wide) / count;
  view.y = (share) => HEIGHT - ENDS - share * (HEIGHT - 2 * ENDS);
  const drawing = draw("svg", { width: wide, height: HEIGHT, viewBox: `0 0 ${wide} ${HEIGHT}`, role: "img", "aria-label": `${model.study.points} ${model.study.noun}s as lines over ${count} axes; the table below has them all` });
  drawing.append(draw("g", { class: "layers" }));
  for (const [number, index] of view.axes.entries()) drawing.append(...axisMarks(model.columns[index], view.x(number), view.y));
  place.replaceChildren(drawing);
  handles(model, view, place);
}

function axisTitle(column) {
  const unit = column.unit ? ` (${column.unit})` : "";
  const aim = column.aim ? make("small", {}, `${column.aim} is best`) : "";
  return make("div", {}, `${column.name}${unit}`, aim);
}

function axisMarks({ scale, limits }, x, y) {
  const parts = [draw("path", { class: "axis", d: `M${x} ${y(0)}V${y(1)}` })];
  for (const { kind, bound } of limits) {
    const at = Math.min(1, Math.max(0, scale.share(bound)));
    parts.push(draw("path", { class: "bound", d: `M${x} ${y(at)}V${y(kind === ">=" ? 1 : 0)}` }));
  }
  for (const value of scale.ticks) {
    const at = y(scale.share(value));
    parts.push(draw("path", { class: "axis", d: `M${x} ${at}h5` }), draw("text", { class: "label", x: x + 8, y: at, dy: "0.35em" }, typeof value === "number" ? numberText(value) : value));
  }
  return parts;
}

/** The two handles of every axis, as sliders for pointer and keyboard. */
function handles(model, view, place) {
  const focused = place.contains(document.activeElement) ? document.activeElement.dataset.handle : null;
  for (const each of place.querySelectorAll("[role=slider]")) each.remove();
  for (const [number, index] of view.axes.entries())
    for (const end of ["least", "most"]) {
      const handle = makeHandle(model, view, place, index, end);
      handle.style.left = `${view.x(number)}px`;
      place.append(handle);
      if (handle.dataset.handle === focused) handle.focus();
    }
}

function makeHandle(model, view, place, index, end) {
  const column = model.columns[index];
  const [low, high] = model.asked.get(index) ?? [0, 1];
  const at = end === "least" ? low : high;
  const value = column.scale.value(at);
  const text = typeof value === "number" ? `${numberText(value)} ${column.unit}`.trim() : String(value ?? "");
  const handle = make("div", { role: "slider", className: `handle ${end}`, tabIndex: 0, "aria-orientation": "vertical", "aria-label": `${end} ${column.name}`, "aria-valuemin": "0", "aria-valuemax": "100", "aria-valuenow": String(Math.round(100 * at)), "aria-valuetext": text, title: `${end} ${column.name}: ${text}` });
  handle.dataset.handle = `${index} ${end}`;
  handle.dataset.keys = "own";
  handle.style.top = `${view.y(at)}px`;
  const move = (share) => {
    const [from, to] = model.asked.get(index) ?? [0, 1];
    if (end === "least") model.ask(index, Math.min(Math.max(share, 0), to), to);
    else model.ask(index, from, Math.max(Math.min(share, 1), from));
  };
  const step = column.scale.words.length ? 1 / column.scale.words.length : 0.02;
  const steps = { ArrowUp: step, ArrowRight: step, ArrowDown: -step, ArrowLeft: -step, PageUp: 5 * step, PageDown: -5 * step };
  handle.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key in steps) move(at + steps[event.key]);
    else if (event.key === "Home") move(0);
    else if (event.key === "End") move(1);
    else return;
    event.preventDefault();
  });
  handle.addEventListener("pointerdown", (event) => {
    event.preventDefault();
    handle.focus();
    follow(event, (moved) => move(shareAt(view, place, moved)));
  });
  return handle;
}

/** Follow a pointer until it is released; the element on which it began may be gone by then. */
function follow(started, moved, ended = () => {}) {
  const mine = (act) => (event) => event.pointerId === started.pointerId && act(event);
  const move = mine(moved);
  const end = mine((event) => {
    removeEventListener("pointermove", move);
    removeEventListener("pointerup", end);
    removeEventListener("pointercancel", end);
    ended(event);
  });
  addEventListener("pointermove", move);
  addEventListener("pointerup", end);
  addEventListener("pointercancel", end);
}

function shareAt(view, place, event) {
  const y = event.clientY - place.getBoundingClientRect().top;
  return Math.min(1, Math.max(0, (view.y(0) - y) / (view.y(0) - view.y(1))));
}

/** The line of a point, interrupted at missing values. */
function lineOf(model, view, point) {
  let path = "";
  let joined = false;
  for (const [number, index] of view.axes.entries()) {
    const value = model.columns[index].values[point];
    if (value !== null) path += `${joined ? "L" : "M"}${view.x(number).toFixed(1)} ${view.y(model.columns[index].scale.share(value)).toFixed(1)}`;
    joined = value !== null;
  }
  return path;
}

/** All lines, from back to front. */
function layers(model, view, place) {
  const group = place.querySelector(".layers");
  if (!group) return;
  const points = Array.from({ length: model.study.points }, (_, point) => point);
  const [left, out] = [points.filter(model.shown), points.filter((point) => !model.shown(point))];
  const one = (point) => (point === null ? [] : [point]);
  const kinds = {
    out,
    behind: left.filter((point) => !model.good(point)),
    good: left.filter(model.good),
    front: view.front.filter(model.shown),
    best: one(view.best),
    opened: one(view.opened),
    hovered: one(view.hovered),
  };
  const drawn = Object.entries(kinds).filter(([, each]) => each.length);
  group.replaceChildren(...drawn.map(([kind, each]) => draw("path", { class: `line ${kind}`, d: each.map((point) => lineOf(model, view, point)).join("") })));
}

/** Handle presses and the pointer; dragging the mouse along an axis selects a range. */
function listen(model, view, place, under, press) {
  const hover = (point) => {
    if (point === view.hovered) return;
    view.hovered = point;
    place.classList.toggle("pressable", point !== null);
    under.textContent = point === null ? "\u00a0" : `${model.nameOf(point)}${model.pointText(point)}: ${model.study.statuses[point]}`;
    layers(model, view, place);
  };
  place.addEventListener("pointermove", (event) => {
    if (event.pointerType === "mouse" && event.buttons === 0) hover(nearest(model, view, place, event));
  });
  place.addEventListener("pointerleave", () => hover(null));
  place.addEventListener("pointerdown", (event) => {
    if (event.button !== 0 || event.target.closest("[role=slider]")) return;
    const axis = event.pointerType === "touch" ? null : axisAt(view, place, event);
    const from = shareAt(view, place, event);
    let dragged = false;
    const moved = (at) => {
      dragged ||= Math.hypot(at.clientX - event.clientX, at.clientY - event.clientY) > DRAGGED;
      const to = shareAt(view, place, at);
      if (dragged && axis !== null) model.ask(axis, Math.min(from, to), Math.max(from, to));
    };
    follow(event, moved, (at) => {
      const point = dragged || at.type === "pointercancel" ? null : nearest(model, view, place, at);
      if (point !== null) press(point);
    });
  });
}

function axisAt(view, place, event) {
  const x = event.clientX - place.getBoundingClientRect().left;
  const number = view.axes.findIndex((_, each) => Math.abs(view.x(each) - x) < REACH);
  return number < 0 ? null : view.axes[number];
}

/** The visible point whose line is nearest to the pointer; among equal lines the better point. */
function nearest(model, view, place, event) {
  const box = place.getBoundingClientRect();
  const [x, y] = [event.clientX - box.left, event.clientY - box.top];
  const before = view.axes.findLastIndex((_, number) => view.x(number) <= x);
  const [left, right] = [Math.max(0, before), Math.min(view.axes.length - 1, before + 1)];
  const part = right > left ? (x - view.x(left)) / (view.x(right) - view.x(left)) : 0;
  const heights = (number, point) => {
    const column = model.columns[view.axes[number]];
    const value = column.values[point];
    return value === null ? NaN : view.y(column.scale.share(value));
  };
  let [found, away] = [null, REACH];
  for (let point = 0; point < model.study.points; point++) {
    if (!model.shown(point)) continue;
    const [first, second] = [heights(left, point), heights(right, point)];
    const at = first + part * (second - first);
    // true distance also for steep lines
    const slope = right > left ? (second - first) / (view.x(right) - view.x(left)) : 0;
    const distance = Math.abs(y - at) / Math.hypot(1, slope) - (model.good(point) ? 1 : 0);
    if (distance < away) [found, away] = [point, distance];
  }
  return found;
}
