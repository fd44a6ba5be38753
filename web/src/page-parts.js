/** Page of parts to make: solids whose joints turn, that can be taken apart and describe themselves. */

import { Vector2 } from "three";
import { readArrays } from "./arrays.js";
import { VIEWS } from "./camera.js";
import { makeClock } from "./clock.js";
import { make } from "./elements.js";
import { short } from "./format.js";
import { squareSide } from "./floor.js";
import { keysHelp, listenToKeys } from "./keys.js";
import { makeApart, makeChoice, makeHinge, makeKinds } from "./parts-controls.js";
import { readModel, readMotion } from "./parts-model.js";
import "./parts.css";
import { makePartsShape } from "./parts-shape.js";
import { viewButtons } from "./player.js";
import { pictureSaves } from "./save-picture.js";
import { makeStage } from "./stage.js";
import { makeTransport } from "./transport.js";

const SPEED = 0.25; // share of the whole range per second
const FRAMES = 60;
const STILL = 4; // pixels that a finger may move during a press

export async function showParts(data) {
  const take = await readArrays(data.arrays);
  const model = readModel(data, take);
  const state = { apart: 0, side: 1, hidden: new Set(), chosen: null };
  const sources = [togetherSource(model, state), ...(data.motion ? [runSource(model, state, readMotion(data.motion, take))] : [])];
  const shown = makeSwitch(sources);
  const element = document.getElementById("player");
  const player = mount(element, data, model, state, shown);
  const chooser = makeChooser(model, data, state, player);
  player.onPress(chooser.choose);
  return { model, state, clock: sources[0].clock, run: sources[1]?.clock ?? null, ...player, choose: chooser.choose };
}

/** All joints at one angle: the clip's time goes from the overbend stop, or flat panels, 0, to the folded parts, 1. */
function togetherSource(model, state) {
  const [start, end] = model.folds ? [model.lowest, model.highest] : [model.highest, model.lowest];
  const angleOf = (moment) => start + moment * (end - start);
  const momentOf = (angle) => (angle - start) / (end - start || 1);
  const time = Float64Array.from({ length: FRAMES + 1 }, (_, frame) => frame / FRAMES);
  const anglesAt = (moment) => model.anglesTogether(angleOf(moment));
  const clip = clipOf(model, state, { time, anglesAt, marks: [], stages: [] });
  const clock = makeClock([forPace(model, clip, anglesAt)], [{ name: "", label: "", start: 0, end: 1, origins: [0], whole: false }]);
  clock.setSpeed(SPEED);
  const control = makeHinge(model, clock, angleOf, momentOf);
  return { name: model.folds ? "along the fold path" : "all joints together", clip, clock, anglesAt, control };
}

/** Motion of a recorded run. */
function runSource(model, state, motion) {
  const clip = clipOf(model, state, motion);
  const clock = makeClock([forPace(model, clip, motion.anglesAt)], motion.spans);
  return { name: "as in the simulated run", clip, clock, anglesAt: motion.anglesAt, control: makeTransport([clip], clock) };
}

/** Data of moving parts for a clock and a camera. */
function clipOf(model, state, { time, anglesAt, marks, stages }) {
  const seen = () => {
    const left = model.parts.filter((part) => !state.hidden.has(part.look));
    return left.length ? left : model.parts;
  };
  return {
    name: "",
    time,
    start: time[0],
    end: time[time.length - 1],
    marks,
    stages,
    readings: [],
    along: [],
    reach: 0,
    mesh: { tubes: [], joints: [], jointRadius: 0 },
    pointsAt: (moment) => model.outline(seen(), model.turn(anglesAt(moment)), state),
    stageAt: (moment) => stages.findLast((stage) => stage.start <= moment) ?? stages[0],
    markAt: (moment) => marks.find((mark) => Math.abs(mark.time - moment) < 1e-9),
  };
}

/** The same clip with fewer points: a clock computes them for all frames, to find its speed. */
function forPace(model, clip, anglesAt) {
  const ends = model.parts.filter((part) => part.outer).map((part) => ({ ...part, outer: [part.outer[0], part.outer.at(-1)] }));
  return { ...clip, pointsAt: (moment) => model.outline(ends, model.turn(anglesAt(moment)), { apart: 0, side: 1 }) };
}

/** One of several sources, as one clip and one clock for a stage. */
function makeSwitch(sources) {
  let now = sources[0];
  let span = { of: null };
  const listeners = new Set();
  for (const source of sources)
    source.clock.onChange(() => {
      if (source === now) for (const listener of listeners) listener();
    });
  const redraw = () => now.clock.redraw();
  const clock = {
    get time() {
      return now.clock.time;
    },
    get playing() {
      return now.clock.playing;
    },
    // another object whenever the view must be computed again
    get span() {
      if (span.of !== now.clock.span) span = { ...now.clock.span, of: now.clock.span };
      return span;
    },
    clipTime: (index, moment) => now.clock.clipTime(index, moment),
    timeAt: (way) => now.clock.timeAt(way),
    wayAt: (moment) => now.clock.wayAt(moment),
    onChange(listener) {
      listeners.add(listener);
      redraw();
      return () => listeners.delete(listener);
    },
    seek: (moment) => now.clock.seek(moment),
    seekClip: (index, moment) => now.clock.seekClip(index, moment),
    step: (steps) => now.clock.step(steps),
    play: () => now.clock.play(),
    pause: () => now.clock.pause(),
  };
  const clip = { ...sources[0].clip, pointsAt: (moment) => now.clip.pointsAt(moment) };
  return {
    clip,
    clock,
    sources,
    get now() {
      return now;
    },
    anglesAt: (moment) => now.anglesAt(moment),
    take(index) {
      now.clock.pause();
      now = sources[index];
      span = { of: null };
      redraw();
    },
    /** The picture has changed, although no time has passed. */
    changed() {
      span = { of: null };
      redraw();
    },
  };
}

const FIRST = "Press a part, or its name in the table, for details.";
const WHOLE = "parts";

function mount(element, data, model, state, shown) {
  const { clip, clock, sources } = shown;
  let shape = null;
  const shapeOf = () => (shape = makePartsShape(model, state, shown.anglesAt, data.stopColour));
  const stage = makeStage([clip], clock, shapeOf, data.text);
  const views = viewButtons(stage.eye, null);
  views.prepend(pictureSaves(stage, clock, () => ({ text: "", longest: 0 }), () => []));
  const picture = make("div", { className: "picture" }, stage.element, ...(stage.note ? [stage.note] : []), views);
  const info = make("p", { className: "chosen", role: "status" }, FIRST);
  const control = make("div", {}, sources[0].control);
  element.replaceChildren(
    picture,
    info,
    control,
    makeChoices(model, state, shown, control),
    makeShown(model, state, shown),
    makeLegend(data, model, stage),
    keysHelp([clip], WHOLE),
  );
  element.classList.add("player");
  element.setAttribute("role", "region");
  element.setAttribute("aria-label", "the moving parts");
  listenToKeys(element, [clip], clock, stage.eye, VIEWS[0]);
  return {
    stage,
    shape,
    info,
    repaint: () => {
      shape.paint();
      clock.seek(clock.time);
    },
    onPress: (press) => listenToPresses(stage, (place) => press(shape.at(place, stage.eye.camera))),
  };
}

/** Controls of the motion, of the distance between parts, and of the bow of straps. */
function makeChoices(model, state, shown, control) {
  const change = (what) => {
    Object.assign(state, what);
    shown.changed();
  };
  const names = shown.sources.map((source) => source.name);
  const motion = makeChoice("motion", names, (index) => {
    shown.take(index);
    control.replaceChildren(shown.now.control);
  });
  const bow = makeChoice("slack straps bow", ["away from the hinge", "towards the hinge"], (index) =>
    change({ side: index ? -1 : 1 }),
  );
  return make(
    "div",
    { className: "choices" },
    ...(names.length > 1 ? [motion] : []),
    makeApart((apart) => change({ apart })),
    ...(model.straps.length ? [bow] : []),
  );
}

/** Choice of the parts that are displayed. */
function makeShown(model, state, shown) {
  const counts = model.looks.map((_, look) =>
    model.parts.reduce((sum, part) => sum + (part.look === look ? part.count : 0), 0),
  );
  return makeKinds(model.looks, counts, (look, on) => {
    if (on) state.hidden.delete(look);
    else state.hidden.add(look);
    shown.changed();
  });
}

function makeLegend(data, model, stage) {
  const taut = make("span", { className: "swatch taut", "aria-hidden": "true" });
  return make(
    "ul",
    { className: "legend" },
    ...(model.parts.some((part) => part.stops) ? [swatchEntry(data.stopColour, "face of a stop")] : []),
    ...(model.straps.length ? [make("li", {}, taut, "on the slider: range of taut straps")] : []),
    make("li", {}, `squares of the grid: ${short(1e3 * squareSide(stage.eye.size))} mm`),
  );
}

function swatchEntry(colour, text) {
  const swatch = make("span", { className: "swatch panel", "aria-hidden": "true" });
  swatch.style.background = colour;
  return make("li", {}, swatch, text);
}

/** Listen to presses without a drag: position on the canvas, -1 to 1 in both directions. */
function listenToPresses({ canvas, listen }, press) {
  let from = null;
  listen("pointerdown", (event) => {
    from = event.isPrimary ? [event.clientX, event.clientY] : null;
  });
  listen("pointerup", (event) => {
    if (from === null || Math.hypot(event.clientX - from[0], event.clientY - from[1]) > STILL) return;
    const box = canvas.getBoundingClientRect();
    const [x, y] = [(event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height];
    press(new Vector2(2 * x - 1, 1 - 2 * y));
  });
}

/** Select a part by index, or none by null: it glows, its row is marked, and its details are displayed. */
function makeChooser(model, data, state, player) {
  const rows = Array.from(document.querySelectorAll("#bill tbody tr"));
  const buttons = rows.map((row, index) => {
    const [name] = row.querySelector("th").childNodes;
    const button = make("button", { type: "button", className: "name", "aria-pressed": "false" }, name.textContent);
    name.replaceWith(button);
    button.addEventListener("click", () => choose(state.chosen === index ? null : index));
    return button;
  });

  function choose(index) {
    state.chosen = index;
    for (const [place, button] of buttons.entries()) button.setAttribute("aria-pressed", String(place === index));
    player.info.textContent = index === null ? FIRST : describe(index);
    player.repaint();
  }

  function describe(index) {
    const part = model.parts[index];
    const [material, mass, size] = part.facts;
    const many = part.count > 1 ? `${part.count} identical ones, each ` : "";
    return `${part.name}: ${model.looks[part.look].name} of ${material}, ${many}${mass}, ${size}`;
  }

  return { choose };
}
