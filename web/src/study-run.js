/** The run behind a cell: its numbers, and its playback if it was kept. */

import { firstLook } from "./camera.js";
import { readClip } from "./clip.js";
import { makeClock } from "./clock.js";
import { make } from "./elements.js";
import { capital } from "./format.js";
import { nameCells } from "./page-compare.js";
import { mountPlayer } from "./player.js";
import { mountPlots } from "./plots.js";
import { mountReadout } from "./readout.js";
import { makeAnswers } from "./study-answer.js";
import { watchTables } from "./tables.js";

/** Three elements: `facts` has the point and its numbers, `element` plays its runs, `below` has their plots and numbers; `open` fills them. */
export function makeRunPanel(model) {
  const heading = make("h2");
  const status = make("p", { className: "outcome", role: "status" });
  const numbers = make("table", { className: "numbers" });
  const facts = make("section", { className: "facts", id: "point" }, heading, status, make("div", { className: "table" }, numbers));
  const parts = make("div", { className: "parts", role: "group", "aria-label": `runs of this ${model.study.noun}` });
  const place = make("div");
  const more = make("div", { className: "more" });
  const element = make("section", { className: "run", id: "run", "aria-label": "the run that is open" }, parts, place, more);
  const below = make("section", { className: "run below", "aria-label": "plots and numbers of the run that is open" });
  const answers = makeAnswers(model);
  const panel = { facts, element, below, point: null, playing: null, answers, open, show };
  let pinned = null;
  // the reader's view is kept from cell to cell
  const look = firstLook();

  /** Display a point and one of its kept runs (that of a transition, or the failed one, or the first), or why it has none. */
  function open(point, { play = false, transition = null } = {}) {
    panel.point = point;
    const runs = model.runsOf(point);
    heading.textContent = capital(`${model.study.noun} ${point + 1}`);
    status.textContent = `${capital(model.pointText(point))}: ${model.study.statuses[point]}.`;
    numbers.replaceChildren(make("caption", {}, model.study.numbers ?? "Values in the table"), make("tbody", {}, ...numberRows(model, point)));
    parts.replaceChildren(...(runs.length > 1 ? runs.map(partButton) : runs.map((run) => make("b", {}, capital(run.title)))));
    const wanted = transition === null ? null : runs.find((run) => run.transition === transition);
    // pressing a cell asks why it failed; the initial view shows the best run
    const failed = play ? runs.find((run) => run.failed) : null;
    if (runs.length) show(wanted ?? failed ?? runs[0], { play });
    else {
      stop();
      place.replaceChildren(make("p", { className: "note" }, whyNotKept(model, point)));
      below.replaceChildren();
    }
    more.replaceChildren(...(model.study.built[point] ? answers.offer(point, runs.length > 0) : []));
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
    const beside = pinned && pinned !== run ? pinned : null;
    const runs = beside ? [beside, run] : [run];
    const elements = { player: make("div"), plots: make("div"), readouts: runs.map(() => make("div")) };
    const [states, repeats] = [statesOf, commandsOf].map((made) => runs.map((each, index) => made(each, calledOf(runs, model)[index])));
    const advice = run.advice ? [make("p", { className: "note" }, run.advice)] : [];
    place.replaceChildren(make("p", {}, run.text), pin(run), ...advice, elements.player);
    below.replaceChildren(elements.plots, ...elements.readouts, ...states, ...repeats);
    look.scale = model.largestSpan / run.play.clips[0].span_m;
    panel.playing = { run, beside, ...mountRun(elements, run, beside, model, look) };
    watchTables(below);
    if (play && !matchMedia("(prefers-reduced-motion: reduce)").matches) panel.playing.clock.play();
  }

  /** A button that keeps a run visible beside runs that are opened later. */
  function pin(run) {
    const label = () => (pinned ? `unpin ${model.study.noun} ${pinned.point + 1}` : "pin to compare with another");
    const button = make("button", { type: "button", className: "pin" }, label());
    button.addEventListener("click", () => {
      pinned = pinned ? null : run;
      show(run);
      place.querySelector(".pin").focus();
    });
    return button;
  }

  return panel;
}

/** Play a run in elements of the page, beside a pinned one if any; their data are read only now. */
function mountRun(elements, run, beside, model, look) {
  const runs = beside ? [beside, run] : [run];
  const names = runs.map((each, index) => nameOf(each, calledOf(runs, model)[index], model));
  const clips = runs.map((each, index) => ({ ...readClip(each.play.clips[0]), ...(beside ? { name: names[index] } : {}) }));
  const clock = makeClock(clips, beside ? [sharedSpan(clips)] : run.play.spans);
  const energy = runs.map((each) => each.play.energy).reduce((most, each) => (each.largest_J > most.largest_J ? each : most));
  const text = beside ? `${capital(clips[0].name)} and ${clips[1].name}, side by side with a common clock.` : run.play.text;
  const player = mountPlayer(elements.player, clips, clock, { ...run.play, energy, text }, look);
  if (beside) nameCells(player.stage.cells, clips, clock, energy);
  const plots = mountPlots(elements.plots, beside ? pairedPlots(runs, clips) : run.play.plots, clips, clock);
  elements.plots.classList.toggle("paired", beside !== null);
  for (const [index, clip] of clips.entries()) mountReadout(elements.readouts[index], clip, clock, energy, index, beside !== null);
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

/** The plots of every run; plots of the same quantity are side by side with one range of values. */
function pairedPlots(runs, clips) {
  const own = runs.map(({ play }, clip) =>
    play.plots.map((plot) => ({
      ...plot,
      owner: clips[clip].name,
      sharing: `${plot.title} ${plot.unit}`,
      lines: plot.lines.map((line) => ({ ...line, clip })),
    })),
  );
  const titles = [...new Set(own.flat().map((plot) => plot.title))];
  return titles.flatMap((title) => own.flat().filter((plot) => plot.title === title));
}

/** Names that distinguish runs displayed together: their points, or what was done; empty for a single run. */
function calledOf(runs, { study }) {
  if (runs.length === 1) return [""];
  const severalPerPoint = new Set(runs.map((run) => run.point)).size < runs.length;
  return runs.map((run) => `${study.noun} ${run.point + 1}${severalPerPoint ? `, ${run.title}` : ""}`);
}

function nameOf(run, called, model) {
  const { factors } = model.study;
  const values = model.placesOf(run.point).map((place, index) => `${factors[index].texts[place]} ${factors[index].unit}`.trim());
  return `${called}: ${values.join(", ")}`;
}

/** Whole runs, aligned at the first drive of each. */
function sharedSpan(clips) {
  const origins = clips.map((clip) => clip.stages.find((stage) => stage.driven)?.start ?? clip.start);
  const [start, end] = [Math.min(...clips.map((clip, index) => clip.start - origins[index])), Math.max(...clips.map((clip, index) => clip.end - origins[index]))];
  return { name: "whole runs", label: "time since the first drive acts", start, end, origins, whole: true };
}

function numberRows(model, point) {
  return model.numbers.map((quantity) => make("tr", {}, make("th", { scope: "row" }, quantity.title), make("td", {}, model.valueText(quantity, point))));
}

function whyNotKept(model, point) {
  if (!model.study.built[point]) return model.study.unbuilt;
  return `${model.study.unkept ?? "This run was not kept, so it cannot be played here."} ${model.study.keeps}`;
}

function statesOf(run, called) {
  const inside = make("div");
  inside.innerHTML = run.numbers; // made by forficula, its texts escaped
  return make("details", {}, make("summary", {}, `States of ${called || "this run"}`), inside);
}

function commandsOf(run, called) {
  const lines = [`forficula run ${run.folder}/design.toml`, `forficula film ${run.folder} --out film.mp4`];
  return make("details", {}, make("summary", {}, called ? `Commands for ${called}` : "Commands"), make("p", { className: "note" }, "In the folder of this page, these commands repeat the run and make a film of it:"), make("pre", {}, make("code", {}, lines.join("\n"))));
}
