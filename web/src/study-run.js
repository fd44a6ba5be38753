/** The run behind a cell: its numbers, and its playback where it was kept. */

import { firstLook } from "./camera.js";
import { readClip } from "./clip.js";
import { makeClock } from "./clock.js";
import { make } from "./elements.js";
import { mountPlayer } from "./player.js";
import { mountPlots } from "./plots.js";
import { mountReadout } from "./readout.js";
import { watchTables } from "./tables.js";

const NUMBERS = ["torque", "time", "work", "energy"];

/** Two elements: `facts` has the point and its numbers, `element` plays its runs; `open` fills both. */
export function makeRunPanel(model) {
  const heading = make("h2");
  const status = make("p", { className: "outcome", role: "status" });
  const numbers = make("table", { className: "numbers" });
  const facts = make("section", { className: "facts", id: "point" }, heading, status, make("div", { className: "table" }, numbers));
  const parts = make("div", { className: "parts", role: "group", "aria-label": "runs of this point" });
  const place = make("div");
  const element = make("section", { className: "run", id: "run", "aria-label": "the run that is open" }, parts, place);
  const panel = { facts, element, point: null, playing: null, open, show };
  // what a reader has turned and zoomed stays from cell to cell
  const look = firstLook();

  /** Show a point, and of its kept runs that of a transition, by its number, or the first, or why there is none. */
  function open(point, { play = false, transition = null } = {}) {
    panel.point = point;
    const runs = model.runsOf(point);
    heading.textContent = `Point ${point + 1}`;
    status.textContent = `${capital(model.pointText(point))}: ${model.study.statuses[point]}.`;
    numbers.replaceChildren(make("caption", {}, "In the study\u2019s table"), make("tbody", {}, ...numberRows(model, point)));
    parts.replaceChildren(...(runs.length > 1 ? runs.map(partButton) : runs.map((run) => make("b", {}, capital(run.title)))));
    if (runs.length) show((transition === null ? null : runs.find((run) => run.transition === transition)) ?? runs[0], { play });
    else {
      stop();
      place.replaceChildren(make("p", { className: "note" }, whyNotKept(model, point)));
    }
  }

  function partButton(run) {
    const button = make("button", { type: "button" }, run.title);
    button.dataset.part = run.part;
    button.addEventListener("click", () => show(run, { play: true }));
    return button;
  }

  function stop() {
    panel.playing?.dispose();
    panel.playing = null;
  }

  function show(run, { play = false } = {}) {
    stop();
    for (const button of parts.querySelectorAll("button")) button.setAttribute("aria-pressed", String(button.dataset.part === run.part));
    const elements = { player: make("div"), plots: make("div"), readout: make("div") };
    const inside = make("div", { className: "table" });
    inside.innerHTML = run.numbers; // made by forficula, its texts escaped
    const details = make("details", {}, make("summary", {}, "States of this run"), inside);
    place.replaceChildren(make("p", {}, run.text), ...(run.advice ? [make("p", { className: "note" }, run.advice)] : []), elements.player, elements.plots, elements.readout, details, commands(run));
    look.scale = model.largestSpan / run.play.clips[0].span_m;
    panel.playing = { run, ...mountRun(elements, run.play, look) };
    watchTables(place);
    if (play && !matchMedia("(prefers-reduced-motion: reduce)").matches) panel.playing.clock.play();
  }

  return panel;
}

/** Play a run in elements of the page; what it holds is read only now. */
function mountRun(elements, data, look) {
  const clips = data.clips.map(readClip);
  const clock = makeClock(clips, data.spans);
  const player = mountPlayer(elements.player, clips, clock, data, look);
  const plots = mountPlots(elements.plots, data.plots, clips, clock);
  mountReadout(elements.readout, clips[0], clock, data.energy);
  return {
    clips,
    clock,
    player,
    plots,
    dispose() {
      player.dispose();
      plots.dispose();
    },
  };
}

function numberRows(model, point) {
  const shown = model.study.quantities.filter((quantity) => NUMBERS.includes(quantity.group));
  return shown.map((quantity) => make("tr", {}, make("th", { scope: "row" }, quantity.title), make("td", {}, model.valueText(quantity, point))));
}

function whyNotKept(model, point) {
  if (!model.study.built[point]) return "There is nothing to play: this point cannot be built.";
  return "This run was not kept, so it cannot be played here. The study keeps the runs of as many points as --keep says.";
}

function commands(run) {
  const lines = [`forficula run ${run.folder}/design.toml`, `forficula film ${run.folder} --out film.mp4`];
  return make("details", {}, make("summary", {}, "Commands"), make("p", { className: "note" }, "In the study\u2019s folder, these run it again, and film it:"), make("pre", {}, make("code", {}, lines.join("\n"))));
}

function capital(text) {
  return `${text[0]?.toUpperCase() ?? ""}${text.slice(1)}`;
}
