/** Samples that agree before all drawn samples, for single unknowns and pairs. */

import { elementDrawing } from "./element-drawing.js";
import { make } from "./elements.js";
import { draw, scaleOf } from "./plane.js";
import { fileName, makeSaveButtons } from "./saving.js";
import { numberText } from "./study-model.js";

const BINS = 12;
const [WIDE, HIGH] = [200, 76];
const SIDE = 130;

/** Marginals of `marginals` and pair plots of `pairs`, keys of columns; `over` receives two columns of a pressed pair. */
export function makePairs(model, { marginals, pairs }, over) {
  const single = make("div", { className: "marginals" });
  const double = make("div", { className: "pairs" });
  const [every, some] = [marginals, pairs].map((keys) => keys.map(model.indexOf).filter((index) => index >= 0));
  const fill = () => {
    single.replaceChildren(...every.map((index) => marginal(model, index)));
    double.replaceChildren(...pairParts(model, some, over));
  };
  double.style.setProperty("--columns", Math.max(1, some.length - 1));
  model.whenAsked(fill);
  fill();
  const intro = "Blue: samples that agree. Grey: all drawn samples. Each colour is scaled by its number of samples. Unknowns that the facts narrow most come first.";
  const parts = [headOf("Single unknowns", single), make("p", { className: "note" }, intro), single];
  if (some.length > 1) parts.push(headOf("Pairs of unknowns", double), make("p", { className: "note" }, "Press a pair to enlarge it."), double);
  return { element: make("section", { className: "agreeing" }, ...parts) };
}

function headOf(title, place) {
  const saves = makeSaveButtons(title, () => fileName(title), () => elementDrawing([place], title));
  return make("div", { className: "head" }, make("h2", {}, title), saves);
}

const allOf = (model) => Array.from({ length: model.study.points }, (_, point) => point);
const drawnOf = (model) => allOf(model).filter((point) => !["placed", "unbuilt"].includes(model.word(model.study.verdicts[point]).pattern));

/** Share of points in every bin. */
function shares(column, scale, points) {
  const count = scale.words.length || BINS;
  const bins = new Array(count).fill(0);
  for (const point of points) bins[Math.min(count - 1, Math.floor(scale.share(column.values[point]) * count))] += 1 / points.length;
  return bins;
}

function marginal(model, index) {
  const column = model.columns[index];
  const scale = scaleOf(column);
  const drawn = drawnOf(model);
  const agree = drawn.filter((point) => model.good(point) && model.shown(point));
  const [prior, posterior] = [drawn, agree].map((points) => shares(column, scale, points));
  const most = Math.max(...prior, ...(agree.length ? posterior : [0]));
  const step = WIDE / prior.length;
  const bars = (bins, name) => draw("path", { class: name, d: bins.map((share, bin) => `M${bin * step + 1} ${HIGH}v${(-share / most) * (HIGH - 4)}h${step - 2}V${HIGH}z`).join("") });
  const contour = (bins) => draw("path", { class: "agree", d: `M0 ${HIGH}${bins.map((share, bin) => `V${HIGH - (share / most) * (HIGH - 4)}H${(bin + 1) * step}`).join("")}V${HIGH}` });
  const text = `${column.name}: ${spread(column, scale, agree)}`;
  const drawing = draw("svg", { viewBox: `0 0 ${WIDE} ${HIGH}`, role: "img", "aria-label": text, preserveAspectRatio: "none" }, bars(prior, "all"), ...(agree.length ? [contour(posterior)] : []), draw("path", { class: "axis", d: `M0 ${HIGH}H${WIDE}` }));
  const ends = scale.words.length ? scale.words : [0, 1].map((at) => numberText(scale.value(at)));
  const unit = column.unit ? ` (${column.unit})` : "";
  return make("figure", {}, make("figcaption", {}, `${column.name}${unit}`), drawing, make("div", { className: "ends" }, ...ends.map((end) => make("span", {}, end))), make("small", {}, spread(column, scale, agree)));
}

/** The middle half of the samples that agree, or the shares of words. */
function spread(column, scale, points) {
  if (!points.length) return "no sample agrees";
  if (scale.words.length) return scale.words.map((word) => `${Math.round((100 * points.filter((point) => column.values[point] === word).length) / points.length)} % ${word}`).join(", ");
  const values = points.map((point) => column.values[point]).sort((first, second) => first - second);
  const at = (share) => numberText(values[Math.round(share * (values.length - 1))]);
  return `middle half: ${at(0.25)} to ${at(0.75)}`;
}

/** Lower half of the matrix of pairs. */
function pairParts(model, indices, over) {
  return indices.slice(1).flatMap((y, row) =>
    indices.slice(0, -1).map((x, column) => {
      if (column > row) return make("span", {});
      return pair(model, x, y, over);
    }),
  );
}

function pair(model, x, y, over) {
  const [across, upwards] = [x, y].map((index) => model.columns[index]);
  const [left, up] = [across, upwards].map((each) => scaleOf(each));
  const dots = (points, name) =>
    draw("path", { class: name, d: points.map((point) => `M${(4 + left.share(across.values[point]) * (SIDE - 8)).toFixed(1)} ${(SIDE - 4 - up.share(upwards.values[point]) * (SIDE - 8)).toFixed(1)}h0`).join("") });
  const drawn = drawnOf(model);
  const agree = drawn.filter((point) => model.good(point) && model.shown(point));
  const drawing = draw("svg", { viewBox: `0 0 ${SIDE} ${SIDE}`, "aria-hidden": "true" }, dots(drawn.filter((point) => !agree.includes(point)), "all"), dots(agree, "agree"));
  const button = make("button", { type: "button", "aria-label": `${upwards.name} over ${across.name}, large` }, drawing, make("small", {}, `${upwards.name} \u2191, ${across.name} \u2192`));
  button.addEventListener("click", () => over(x, y));
  return button;
}
