/** Answers of a study's page for points without a run: the engine simulates the point, and finer points around it. */

import { readClip } from "./clip.js";
import { make } from "./elements.js";
import { hasEngine, startEngine } from "./engine.js";
import { capital, short } from "./format.js";
import { makePanel } from "./try-panel.js";

const FINER = 2; // parts of a step between two points
const DRAWN = 20; // parts of the range of drawn points

/** `offer` returns the elements below a point, whether its run was kept or not. */
export function makeAnswers(model) {
  const text = document.getElementById("live")?.textContent ?? null;
  const live = text && JSON.parse(text);
  const place = make("div", { className: "answer" });
  const said = make("p", { className: "outcome", role: "status" });
  const table = make("div");
  const holder = make("div");
  let panel = null;
  let starting = false;
  let current = 0;
  let working = Promise.resolve(); // the last request
  let asked = 0; // number of the last request: replies to earlier ones are ignored

  function offer(point, kept) {
    asked += 1;
    current = point;
    if (!live) return [];
    if (!hasEngine()) return kept ? [] : [make("p", { className: "note" }, `It cannot be simulated here either: ${live.refused}.`)];
    if (panel) answer(point);
    else if (!starting) {
      const button = make("button", { type: "button", className: "try" }, kept ? "Try it and refine here" : "Simulate it here");
      const hint = make("p", { className: "note" });
      button.addEventListener("click", () => start(button, hint));
      holder.replaceChildren(make("div", { className: "offer" }, button, hint));
    }
    return [holder];
  }

  /** Start the engine, and answer for the point that is open when it is ready. */
  async function start(button, hint) {
    starting = button.disabled = true;
    hint.textContent = "Starting the simulator \u2026";
    try {
      panel = await makePanel(readClip(live.bench.clips[0]), live.bench, text, startEngine);
      holder.replaceChildren(place);
      place.replaceChildren(panel.element);
      panel.begin();
      answer(current);
    } catch (error) {
      hint.textContent = `It cannot be simulated here: ${error.message}.`;
    }
  }

  /** Outcome for some values, after earlier requests; null if another request was made since. */
  async function ask(values, mine) {
    await working.catch(() => null);
    if (mine !== asked) return null;
    working = panel.engine.ask({ act: "answer", values, search: live.search });
    const { answer: found } = await working;
    return mine === asked ? found : null;
  }

  async function answer(point) {
    const mine = ++asked;
    const refine = make("button", { type: "button" }, "Refine here");
    refine.addEventListener("click", () => finer(point));
    table.replaceChildren();
    place.replaceChildren(said, ...(variedOf(model, live).length ? [refine] : []), table, panel.element);
    said.textContent = "Simulating \u2026";
    panel.sliders.set(live.points[point]);
    const found = await ask(live.points[point], mine);
    if (!found) return;
    said.textContent = `${capital(model.pointText(point))}: ${answerText(live, found)}.`;
    goLive(point);
  }

  /** Let the reader move the point's structure; its values are set again after earlier simulations. */
  function goLive(point) {
    panel.sliders.set(live.points[point]);
    panel.engine.send({ act: "restart", through: false });
  }

  /** A map between a point and its neighbours, filled cell by cell. */
  async function finer(point) {
    const mine = ++asked;
    const axes = axesAt(model, live, point);
    const words = new Map();
    const note = make("p", { className: "note", role: "status" });
    const grid = axes[1].values.map((up) => axes[0].values.map((across) => cellOf(axes, across, up))).reverse();
    const rows = grid.map((row, index) => make("tr", {}, make("th", { scope: "row" }, axisText(axes[1], axes[1].values.length - 1 - index)), ...row.map(({ cell }) => cell)));
    const feet = make("tr", { className: "feet" }, make("td"), ...axes[0].values.map((_, index) => make("th", { scope: "col" }, axisText(axes[0], index))));
    const body = make("table", { className: "grid" }, make("caption", {}, caption(axes, model.study.sampled)), make("tbody", {}, ...rows, feet));
    table.replaceChildren(make("div", { className: "table", tabIndex: 0, role: "group", "aria-label": "finer map" }, body), note);
    const every = grid.flat();
    for (const [number, { cell, values, where }] of every.entries()) {
      note.textContent = `${number} of ${every.length} points simulated`;
      const found = await ask({ ...live.points[point], ...values }, mine);
      if (!found) return;
      const { sign, pattern } = model.study.words.find(({ word }) => word === found.word) ?? model.study.other;
      cell.className = `what ${pattern}`;
      cell.replaceChildren(make("span", {}, sign));
      cell.title = `${where}: ${answerText(live, found)}`;
      cell.setAttribute("aria-label", cell.title);
      words.set(found.word, sign);
    }
    note.textContent = [...words].map(([word, sign]) => `${sign} ${word}`).join(" \u00b7 ");
    goLive(point);
  }

  return { offer, get panel() { return panel; } };
}

function cellOf(axes, across, up) {
  const values = { [axes[0].key]: across };
  if (axes[1].key) values[axes[1].key] = up;
  const where = axes.filter(({ key }) => key).map((axis) => `${axis.name} ${short(axis.factor * values[axis.key])} ${axis.unit}`).join(", ");
  return { cell: make("td", { "aria-label": `${where}: not simulated yet` }), values, where };
}

/** Factors that vary and are numbers; a study that changes one value at a time may lack some. */
function variedOf(model, live) {
  const changed = (index) => live.knobs.some(({ key }) => key === model.study.factors[index].key);
  return model.study.axes.filter((index) => model.sizes[index] > 1 && changed(index));
}

/** The two factors of the map, with values up to those of a point's neighbours. */
function axesAt(model, live, point) {
  const varied = variedOf(model, live);
  const [up, across] = varied.length > 1 ? varied : [null, varied[0] ?? 0];
  const axis = (index) => {
    if (index === null) return { key: "", name: "", unit: "", factor: 1, values: [0] };
    const { key, name } = model.study.factors[index];
    const knob = live.knobs.find((each) => each.key === key);
    if (model.study.sampled) return { key, name, unit: knob.unit, factor: knob.factor, values: around(live.points.map((each) => each[key]), point) };
    const places = model.placesOf(point);
    const valueAt = (place) => live.points[model.pointAt(places.map((own, each) => (each === index ? place : own)))][key];
    const [low, high] = [Math.max(0, places[index] - 1), Math.min(model.sizes[index] - 1, places[index] + 1)];
    const values = [];
    for (let place = low; place < high; place++)
      for (let part = 0; part < FINER; part++) values.push(valueAt(place) + (part / FINER) * (valueAt(place + 1) - valueAt(place)));
    return { key, name, unit: knob.unit, factor: knob.factor, values: [...values, valueAt(high)] };
  };
  return [axis(across), axis(up)];
}

/** Values about that of a drawn point, within a share of the range of all drawn points. */
function around(drawn, point) {
  const [low, high] = [Math.min(...drawn), Math.max(...drawn)];
  const steps = [-2, -1, 0, 1, 2].map((step) => drawn[point] + (step * (high - low)) / DRAWN);
  return [...new Set(steps.map((value) => Math.min(high, Math.max(low, value))))].sort((one, other) => one - other);
}

const axisText = ({ key, factor, unit, values }, index) => (key ? `${short(factor * values[index])} ${unit}` : "");

function caption([across, up], sampled) {
  const over = up.key ? `${capital(across.name)} across, ${up.name} upwards` : capital(across.name);
  return `${over}, ${sampled ? "around it" : "at half the steps"}`;
}

/** The outcome of a point, with the least values that were searched for. */
function answerText(live, { status, least }) {
  const steps = live.search ? [live.search.first, live.search.second].filter(Boolean) : [];
  const torques = steps
    .filter(({ name }) => least[name] !== null && least[name] !== undefined)
    .map(({ key, name, title }) => {
      const { factor, unit } = live.knobs.find((knob) => knob.key === key);
      return `${title} ${short(factor * least[name])} ${unit}`;
    });
  return [status, ...torques].join("; ");
}
