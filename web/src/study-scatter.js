/** Drawn points of a study over two factors, or a quantity over the only one. */

import { make } from "./elements.js";
import { patternOf } from "./heat.js";
import { numberText } from "./study-model.js";

const SPACE = "http://www.w3.org/2000/svg";
const [WIDTH, HEIGHT] = [600, 420];
const EDGE = { left: 64, right: 14, top: 12, bottom: 52 };

export function makeScatter(model, view, press) {
  const { factors, points: count } = model.study;
  const { quantity } = view;
  const points = Array.from({ length: count }, (_, point) => point);
  const scale = model.scaleOf(quantity);
  const across = axis(factors[view.x].values, factors[view.x], EDGE.left, WIDTH - EDGE.right);
  const values = view.y === null ? quantity.values ?? points.map(() => 0) : factors[view.y].values;
  const named = view.y === null ? { name: quantity.title, unit: quantity.unit } : factors[view.y];
  const upwards = axis(values, named, HEIGHT - EDGE.bottom, EDGE.top);
  const drawing = draw("svg", { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, class: "scatter", role: "listbox", "aria-label": `${quantity.title} of ${count} drawn points; arrows move between them, enter opens one` });
  drawing.append(...axisParts(across, upwards));
  const marks = points.map((point) => makePoint(model, view, scale, point, across.place(point), upwards.place(point)));
  drawing.append(...marks);
  (marks[view.current ?? 0] ?? marks[0])?.setAttribute("tabindex", "0");
  listen(drawing, marks, press);
  return { element: make("div", { className: "scroll" }, drawing), points };
}

function makePoint(model, view, scale, point, x, y) {
  const { quantity } = view;
  const value = quantity.values?.[point] ?? null;
  const text = `${model.pointText(point)}: ${model.valueText(quantity, point)}`;
  const mark = draw("g", { role: "option", tabindex: "-1", "aria-label": text, "aria-selected": String(view.opened === point), "data-point": point, transform: `translate(${x.toFixed(1)} ${y.toFixed(1)})` });
  const title = draw("title", {});
  title.textContent = text;
  mark.append(title);
  const sign = value === null ? model.word(quantity.reasons[point]).sign : "";
  if (sign) mark.setAttribute("class", patternOf(sign));
  mark.append(draw("circle", { r: 8, class: value === null ? "missing" : "found", fill: value === null ? "transparent" : scale.colour(value).face }));
  if (sign) {
    const letter = draw("text", { "text-anchor": "middle", dy: "0.36em" });
    letter.textContent = sign;
    mark.append(letter);
  }
  return mark;
}

function listen(drawing, marks, press) {
  const pointOf = (event) => event.target.closest("[data-point]");
  drawing.addEventListener("click", (event) => {
    if (pointOf(event)) press(Number(pointOf(event).dataset.point));
  });
  const steps = { ArrowLeft: -1, ArrowUp: -1, ArrowRight: 1, ArrowDown: 1 };
  drawing.addEventListener("keydown", (event) => {
    const mark = pointOf(event);
    if (!mark || event.ctrlKey || event.metaKey || event.altKey) return;
    const point = Number(mark.dataset.point);
    if (event.key === "Enter" || event.key === " ") press(point);
    else if (!(event.key in steps)) return;
    else if (marks[point + steps[event.key]]) {
      mark.setAttribute("tabindex", "-1");
      marks[point + steps[event.key]].setAttribute("tabindex", "0");
      marks[point + steps[event.key]].focus();
    }
    event.preventDefault();
  });
}

/** Where values lie between two ends of an axis; words one after another, what is missing at its start. */
function axis(values, factor, from, to) {
  const label = factor.unit ? `${factor.name} (${factor.unit})` : factor.name;
  const numbers = values.filter((value) => typeof value === "number");
  const words = [...new Set(values.filter((value) => typeof value === "string"))];
  const lie = words.length ? (value) => words.indexOf(value) : (value) => value;
  const low = words.length ? -0.5 : Math.min(...numbers);
  const high = words.length ? words.length - 0.5 : Math.max(...numbers);
  const margin = 0.04 * (to - from);
  const at = (value) => from + margin + ((lie(value) - low) / (high - low || 1)) * (to - from - 2 * margin);
  const ticks = words.length ? words : numbers.length ? roundNumbers(low, high) : [];
  return { label, from, to, ticks: ticks.map((value) => [at(value), typeof value === "number" ? numberText(value) : value]), place: (point) => (values[point] === null ? from : at(values[point])) };
}

function roundNumbers(low, high) {
  if (!(high > low)) return [low];
  const rough = (high - low) / 5;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = power * ([1, 2, 5].find((each) => each * power >= rough) ?? 10);
  const found = [];
  for (let value = Math.ceil(low / step) * step; value <= high + 1e-9 * step; value += step) found.push(Number(value.toPrecision(12)));
  return found;
}

function axisParts(across, upwards) {
  const parts = [draw("path", { class: "axis", d: `M${across.from} ${upwards.to}V${upwards.from}H${across.to}` })];
  const write = (text, properties) => {
    const letters = draw("text", { class: "label", ...properties });
    letters.textContent = text;
    parts.push(letters);
  };
  for (const [x, text] of across.ticks) write(text, { x, y: upwards.from + 18, "text-anchor": "middle" });
  for (const [y, text] of upwards.ticks) write(text, { x: across.from - 8, y, dy: "0.35em", "text-anchor": "end" });
  write(across.label, { x: (across.from + across.to) / 2, y: HEIGHT - 8, "text-anchor": "middle" });
  write(upwards.label, { transform: `translate(14 ${(upwards.from + upwards.to) / 2}) rotate(-90)`, "text-anchor": "middle" });
  return parts;
}

function draw(tag, properties) {
  const element = document.createElementNS(SPACE, tag);
  for (const [name, value] of Object.entries(properties)) element.setAttribute(name, value);
  return element;
}
