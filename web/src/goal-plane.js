/** Points over two columns that a reader chooses, coloured by outcome or by a number. */

import { elementDrawing } from "./element-drawing.js";
import { make } from "./elements.js";
import { scaleParts, signOf } from "./heat.js";
import { fileName, makeSaveButtons } from "./saving.js";
import { makeScatter } from "./study-scatter.js";

/** `keys` are the columns of the horizontal and vertical axis; `open` receives a pressed point. */
export function makePlane(model, { plane, front, best, best_word, joined }, open) {
  const { quantities } = model.study;
  const [x, y] = [plane.x, plane.y].map(model.indexOf);
  const [firstX, firstY] = [x, y];
  const view = { quantity: quantities[0], x, y, current: best ?? 0, opened: null, front, best, bestWord: best_word, ordered: true };
  const place = make("div", { className: "map-place" });
  const legend = make("div", { className: "map-legend" });
  const draw = () => {
    const first = view.x === firstX && view.y === firstY;
    view.cells = first ? plane.cells : undefined;
    view.joined = joined && new Set([view.x, view.y, firstX, firstY]).size === 2;
    const shown = makeScatter(model, view, press);
    place.replaceChildren(shown.element);
    legend.replaceChildren(...legendParts(model, view));
  };
  const press = (point) => {
    show(point);
    open(point);
  };
  function show(point) {
    view.current = view.opened = point;
    const focused = place.contains(document.activeElement);
    draw();
    if (focused) place.querySelector(`[data-point="${point}"]`)?.focus();
  }
  const columns = model.columns.map((column, index) => [index, column.name]);
  const selects = {
    across: choice("across", columns, () => view.x, (index) => turn("x", "y", index)),
    upwards: choice("upwards", columns, () => view.y, (index) => turn("y", "x", index)),
    show: choice("show", quantities.map((each, index) => [index, each.title]), () => quantities.indexOf(view.quantity), (index) => { view.quantity = quantities[index]; }),
  };
  function choice(label, options, chosen, act) {
    const select = make("select", {}, ...options.map(([name, text]) => make("option", { value: String(name) }, text)));
    select.value = String(chosen());
    select.addEventListener("change", () => {
      act(Number(select.value));
      fill();
      draw();
    });
    const element = make("label", {}, `${label} `, select);
    element.dataset.name = label;
    return { element, fill: () => { select.value = String(chosen()); } };
  }
  const fill = () => Object.values(selects).forEach((each) => each.fill());
  function turn(which, other, index) {
    if (view[other] === index) view[other] = view[which];
    view[which] = index;
  }
  const names = () => [view.y, view.x].map((index) => model.columns[index].name).join(" over ");
  const saves = makeSaveButtons(plane.title, () => fileName(names()), () => elementDrawing([place, legend], names()));
  const head = make("div", { className: "head" }, make("h2", {}, plane.title), saves);
  const element = make("section", { className: "map" }, head, make("div", { className: "choices" }, ...Object.values(selects).map((each) => each.element)), place, legend);
  model.whenAsked(draw);
  draw();
  return {
    element,
    show,
    /** Place the points over these columns, by index. */
    over(across, upwards) {
      [view.x, view.y] = [across, upwards];
      fill();
      draw();
    },
  };
}

function legendParts(model, { quantity, front, cells, x, y }) {
  const parts = scaleParts(model, quantity);
  const reasons = quantity.values ? quantity.reasons : model.study.verdicts;
  const entries = model.study.words.flatMap((entry, number) => {
    const count = reasons.filter((each, point) => each === number && model.shown(point)).length;
    return count ? [make("li", {}, signOf(entry), `${entry.word} (${count})`)] : [];
  });
  if (front.length) entries.push(make("li", {}, make("span", { className: "ring", "aria-hidden": "true" }), "Pareto front"));
  const columns = [x, y].map((index) => model.columns[index]);
  if (columns.some((column) => typeof column.own === "number")) entries.push(make("li", {}, make("span", { className: "dashes", "aria-hidden": "true" }), "as designed"));
  if (columns.some((column) => column.limits.length)) entries.push(make("li", {}, make("span", { className: "shade", "aria-hidden": "true" }), "beyond a limit"));
  if (cells) for (const does of ["works", "fails"]) entries.push(make("li", {}, make("span", { className: `map-${does}`, "aria-hidden": "true" }), `${does} if only these two deviate`));
  if (entries.length) parts.push(make("ul", {}, ...entries));
  return parts;
}
