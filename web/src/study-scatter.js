/** Points over two of their columns, or a quantity over a single column. */

import { make } from "./elements.js";
import { axisParts, draw, makeAxis } from "./plane.js";

const [WIDTH, HEIGHT] = [600, 420];
const EDGE = { left: 76, right: 14, top: 12, bottom: 52 };
const MANY = 60; // number of points above which marks are smaller
const STEPS = { ArrowLeft: -1, ArrowUp: -1, ArrowRight: 1, ArrowDown: 1 };

/**
 * The drawing of a view: `quantity`, and indices of the columns `x` and `y`; optionally `front`, indices of the
 * Pareto-optimal points, which are connected if `joined`; `best`, index of the best point,
 * with its name `bestWord`; and `cells`, a map under the points. `ordered`: whether arrow keys
 * go from left to right and the most successful points are in front; otherwise both are by index.
 */
export function makeScatter(model, view, press) {
  const { columns, study } = model;
  const { quantity } = view;
  const points = Array.from({ length: study.points }, (_, point) => point);
  const scale = model.scaleOf(quantity);
  const across = makeAxis(columns[view.x].values, columns[view.x], EDGE.left, WIDTH - EDGE.right, view.cells?.across);
  const values = view.y === null ? quantity.values ?? points.map(() => 0) : columns[view.y].values;
  const named = view.y === null ? { name: quantity.title, unit: quantity.unit } : columns[view.y];
  const upwards = makeAxis(values, named, HEIGHT - EDGE.bottom, EDGE.top, view.cells?.upwards);
  const label = `${quantity.title} of ${study.points} ${study.noun}s; arrows move between them, enter opens one`;
  const drawing = draw("svg", { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, class: ["scatter", points.length > MANY && "many", view.ordered && "judged"].filter(Boolean).join(" "), role: "listbox", "aria-label": label });
  if (view.cells) drawing.append(...mapCells(view.cells, across, upwards));
  if (showsBoundaries(study, view)) drawing.append(...boundaryParts(study.boundaries, view, across, upwards));
  drawing.append(...axisParts(across, upwards, HEIGHT), ...guides(columns[view.x], across, upwards, true), ...(view.y === null ? [] : guides(columns[view.y], upwards, across, false)));
  const places = points.map((point) => [across.place(point), upwards.place(point)]);
  if (view.joined) drawing.append(frontLine(view.front, places, columns[view.x].aim));
  const radius = points.length > MANY ? 6 : 8;
  const marks = points.map((point) => makePoint(model, view, scale, point, places[point], radius));
  drawing.append(...(view.ordered ? fromBehind(model, view, points) : points).map((point) => marks[point]));
  (marks[view.current ?? 0] ?? marks[0])?.setAttribute("tabindex", "0");
  listen(drawing, marks, view.ordered ? [...points].sort((first, second) => places[first][0] - places[second][0]) : points, press);
  return { element: make("div", { className: "scroll" }, drawing), points };
}

/** Points from back to front: the most successful last. */
function fromBehind(model, view, points) {
  const rank = (point) => (model.shown(point) ? 0 : 1e6) + (view.best === point ? -1 : model.study.verdicts[point]);
  return [...points].sort((first, second) => rank(second) - rank(first));
}

function makePoint(model, view, scale, point, [x, y], radius) {
  const { quantity } = view;
  const value = quantity.values?.[point] ?? null;
  const text = `${model.nameOf(point)}${model.pointText(point)}: ${model.valueText(quantity, point)}`;
  const mark = draw("g", { role: "option", tabindex: "-1", "aria-label": text, "aria-selected": String(view.opened === point), "data-point": point, transform: `translate(${x.toFixed(1)} ${y.toFixed(1)})` }, draw("title", {}, text));
  const { sign, pattern } = value === null ? model.word(quantity.reasons[point]) : {};
  if (sign) mark.setAttribute("class", `what ${pattern}`);
  if (!model.shown(point)) mark.classList.add("out");
  if (view.front?.includes(point)) mark.append(draw("circle", { r: radius + 3, class: "front" }));
  mark.append(draw("circle", { r: radius, class: value === null ? "missing" : "found", fill: value === null ? "transparent" : scale.colour(value).face }));
  if (sign) mark.append(draw("text", { "text-anchor": "middle", dy: "0.36em" }, sign));
  if (view.best === point) mark.append(draw("text", { class: "best", "text-anchor": "middle", dy: -radius - 6 }, view.bestWord));
  return mark;
}

/** A map under the points: whether the design works at values of both axes. */
function mapCells(cells, across, upwards) {
  const [columns, rows] = [edges(cells.across.map(across.at)), edges(cells.upwards.map(upwards.at))];
  return cells.works.flatMap((column, i) =>
    column.map((works, j) => draw("rect", { class: works ? "map-works" : "map-fails", x: columns[i], width: columns[i + 1] - columns[i], y: rows[j + 1], height: rows[j] - rows[j + 1] })),
  );
}

/** Whether both axes of a view are those of the located boundaries. */
export function showsBoundaries({ boundaries }, { x, y }) {
  return Boolean(boundaries) && [x, y].every((index) => [boundaries.x, boundaries.y].includes(index));
}

/** Outlines of cells and the boundaries in them. */
function boundaryParts({ cells, lines, x, y }, view, across, upwards) {
  // of a single factor, shapes extend over the whole height
  const place = (first, second) => {
    if (y === null) return [across.at(first), upwards.from + second * (upwards.to - upwards.from)];
    return view.x === x ? [across.at(first), upwards.at(second)] : [across.at(second), upwards.at(first)];
  };
  const path = (points, close) => `M${points.map(([left, top]) => `${left.toFixed(1)} ${top.toFixed(1)}`).join("L")}${close}`;
  const outlines = cells.map(([low, bottom, high, top]) => path([place(low, bottom), place(high, bottom), place(high, top), place(low, top)], "Z"));
  const pieces = lines.map(([startX, startY, endX, endY]) => path([place(startX, startY), place(endX, endY)], ""));
  return [draw("path", { class: "cell-outline", d: outlines.join("") }), draw("path", { class: "boundary", d: pieces.join("") })];
}

/** Boundaries between the cells of values. */
function edges(places) {
  const between = places.slice(1).map((place, index) => (place + places[index]) / 2);
  const [first, last] = [places[0], places.at(-1)];
  return [first, ...between, last];
}

/** Guides of a column along its axis: the design’s own value, and limits with shaded areas beyond. */
function guides(column, along, other, upright) {
  const line = (at, name) => draw("path", { class: name, d: upright ? `M${at} ${other.from}V${other.to}` : `M${other.from} ${at}H${other.to}` });
  const inside = (at) => at >= Math.min(along.from, along.to) && at <= Math.max(along.from, along.to);
  const parts = [];
  if (typeof column.own === "number" && inside(along.at(column.own))) parts.push(line(along.at(column.own), "own"));
  for (const { kind, bound } of column.limits ?? []) {
    const at = along.at(bound);
    if (!inside(at)) continue;
    const end = kind === ">=" ? along.from : along.to;
    const [low, size] = [Math.min(at, end), Math.abs(at - end)];
    const box = upright ? { x: low, width: size, y: other.to, height: other.from - other.to } : { y: low, height: size, x: other.from, width: other.to - other.from };
    parts.push(draw("rect", { class: "beyond", ...box }), line(at, "limit"));
  }
  return parts;
}

/** The front as steps, because between two points only the worse value is certain. */
function frontLine(front, places, aim) {
  const along = front.map((point) => places[point]).sort((first, second) => first[0] - second[0]);
  const step = ([x, y]) => (aim === "least" ? `H${x.toFixed(1)}V${y.toFixed(1)}` : `V${y.toFixed(1)}H${x.toFixed(1)}`);
  return draw("path", { class: "front", d: along.map((place, index) => (index ? step(place) : `M${place.join(" ")}`)).join("") });
}

/** `order` is the order of the points for the arrow keys. */
function listen(drawing, marks, order, press) {
  const pointOf = (event) => event.target.closest("[data-point]");
  drawing.addEventListener("click", (event) => {
    if (pointOf(event)) press(Number(pointOf(event).dataset.point));
  });
  // one tab stop: the mark that had the focus last
  drawing.addEventListener("focusin", (event) => {
    for (const mark of marks) mark.setAttribute("tabindex", mark === event.target ? "0" : "-1");
  });
  drawing.addEventListener("keydown", (event) => {
    const mark = pointOf(event);
    if (!mark || event.ctrlKey || event.metaKey || event.altKey) return;
    const point = Number(mark.dataset.point);
    if (event.key === "Enter" || event.key === " ") press(point);
    else if (!(event.key in STEPS)) return;
    else {
      marks[order[order.indexOf(point) + STEPS[event.key]]]?.focus();
    }
    event.preventDefault();
  });
}
