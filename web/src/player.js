/** Structures in 3-D with the controls of their clock, in an element of any page. */

import { VIEWS } from "./camera.js";
import { showCreases } from "./crease-label.js";
import { effortTexts } from "./efforts.js";
import { make, makeButton } from "./elements.js";
import { short, timeText } from "./format.js";
import { keysHelp, listenToKeys, listenToLooks } from "./keys.js";
import { makeLegend, roomyText } from "./legend.js";
import { makeShape } from "./shape.js";
import { pictureSaves } from "./save-picture.js";
import { makeSheetColours } from "./sheet-colours.js";
import { makeStage } from "./stage.js";
import { makeTransport, stageText } from "./transport.js";

/**
 * Display clips side by side with a common clock.
 *
 * energy: {unit, factor, largest_J} for the tendons' colours; legend: samples of colours with their meanings; text: a
 * sentence about the picture; whole: noun for one of the structures; look: initial view of the camera; scaled: whether
 * the structures of several clips, shown together or one after another, may have one scale.
 * Returns {stage, dispose}.
 */
export function mountPlayer(element, clips, clock, { energy, legend: entries, text, whole }, look, scaled = clips.length > 1 || Boolean(look)) {
  const stage = makeStage(clips, clock, (clip) => makeShape(clip, energy.largest_J), text, look);
  const picture = make("div", { className: "picture" }, stage.element, ...(stage.note ? [stage.note] : []), viewButtons(stage.eye, scaled ? whole : null));
  if (clips.length === 1) nameState(stage.cells[0], clips[0], clock);
  const legend = [makeLegend(entries, energy, stage.eye.size, clips.length > 1 ? whole : null)];
  if (clips.some((clip) => clip.strained)) legend.unshift(makeSheetColours(stage, legend[0], clips));
  if (clips.length === 1 && clips[0].efforts?.drives.length) tellEfforts(legend.at(-1), clips[0], clock);
  if (clips.length > 1 && clips.some((clip) => clip.efforts?.drives.some((drive) => drive.arrow)))
    legend.at(-1).append(make("li", { className: "effort" }, arrowSample(), "torque or force of a drive, while it acts"));
  const creases = clips.length === 1 && clips[0].creases ? [showCreases(stage, clips[0], clock)] : [];
  element.replaceChildren(picture, makeTransport(clips, clock), ...creases, ...legend, keysHelp(clips, whole));
  element.classList.add("player");
  element.setAttribute("role", "region");
  element.setAttribute("aria-label", `the moving ${whole}`);
  addSaves(element, stage, clock, () => momentName(clips, clock));
  const deaf = listenToKeys(element, clips, clock, stage.eye, VIEWS[0]);

  function dispose() {
    clock.pause();
    deaf();
    stage.dispose();
    element.replaceChildren();
  }

  return { stage, dispose };
}

/** Display structures without a time line, which sliders move; arguments as for mountPlayer. */
export function mountStill(element, clips, clock, { energy, legend: entries, text, whole }, look) {
  const stage = makeStage(clips, clock, (clip) => makeShape(clip, energy.largest_J), text, look);
  const picture = make("div", { className: "picture" }, stage.element, ...(stage.note ? [stage.note] : []), viewButtons(stage.eye, null, !look));
  const legend = [makeLegend(entries, { ...energy, orMore: true }, stage.eye.size, null)];
  if (clips.some((clip) => clip.strained)) legend.unshift(makeSheetColours(stage, legend[0], clips));
  element.replaceChildren(picture, ...legend);
  element.classList.add("player");
  element.setAttribute("role", "region");
  element.setAttribute("aria-label", `the ${whole} as set by the sliders`);
  addSaves(element, stage, clock, () => ({ text: "", longest: 0 }));
  listenToLooks(element, stage.eye, VIEWS[0]);
  return { stage };
}

/** Buttons that save the picture and its motion, with the scales of the legend. */
function addSaves(element, stage, clock, caption) {
  const scales = () => [...element.querySelectorAll(".legend .energy:not([hidden])")];
  element.querySelector(".views").prepend(pictureSaves(stage, clock, caption, scales));
}

/**
 * The time of a picture and, of a single structure, its state, as {text, longest}: the number of letters of the longest
 * such text, so that all frames of a film have one layout.
 */
function momentName(clips, clock) {
  const { span } = clock;
  const [clip] = clips;
  const before = clips.length === 1 ? `${stageText(clip, clock.clipTime(0))}, ` : "";
  const states = clips.length === 1 ? [...clip.stages.map(({ name }) => name), ...clip.marks.map(({ letter, name }) => `${letter} ${name}`)] : [];
  const letters = (texts) => Math.max(0, ...texts.map((text) => text.length));
  const text = `${before}${timeText(clock.time, span)}`;
  const times = [span.start, span.end].map((moment) => timeText(moment, span));
  return { text, longest: Math.max(text.length, letters(states) + ", ".length + letters(times)) };
}

/** Write into the picture of a single structure its state, or the drive that acts on it. */
function nameState(cell, clip, clock) {
  const name = make("p", { className: "now", "aria-hidden": "true" });
  cell.append(name);
  clock.onChange(() => {
    name.textContent = stageText(clip, clock.clipTime(0));
    name.hidden = !name.textContent;
  });
}

function arrowSample() {
  return make("span", { className: "swatch arrow", "aria-hidden": "true" });
}

/** List in the legend the drives that act now, with their strengths. */
function tellEfforts(legend, clip, clock) {
  const arrow = clip.efforts.drives.some((drive) => drive.arrow);
  const textAt = (moment) => effortTexts(clip.efforts, moment, short).join("; ") || "no drive acts now";
  const said = roomyText(Array.from(clip.time, textAt));
  legend.append(make("li", { className: "effort" }, ...(arrow ? [arrowSample()] : []), said.element));
  clock.onChange(() => said.say(textAt(clock.clipTime(0))));
}

/**
 * whole: noun for one of several structures, displayed side by side or one after another; null for a single one.
 * follows: whether the picture can be kept filled, which requires known future positions.
 */
export function viewButtons(eye, whole, follows = true) {
  const views = VIEWS.map((view) => makeButton(view.name, `${view.name}: view ${view.text}`, () => eye.show(view)));
  const turns = [
    ["\u2190", "turn left", [-1, 0]],
    ["\u2192", "turn right", [1, 0]],
    ["\u2191", "turn up", [0, 1]],
    ["\u2193", "turn down", [0, -1]],
  ].map(([text, label, steps]) => makeButton(text, label, () => eye.turn(...steps)));
  const switched = (text, label, choice) => {
    const made = makeButton(text, label, () => {
      eye.choose({ [choice]: !eye.look[choice] });
      made.setAttribute("aria-pressed", String(eye.look[choice]));
    });
    made.setAttribute("aria-pressed", String(eye.look[choice]));
    return made;
  };
  const frames = [
    ...(follows ? [switched("follow", "follow: keep the picture filled as the structure moves", "following")] : []),
    ...(whole ? [switched("one scale", `one scale: draw all ${whole}s at the same scale`, "oneScale")] : []),
  ];
  const zooms = [makeButton("+", "nearer", () => eye.zoom(1)), makeButton("\u2212", "further", () => eye.zoom(-1))];
  return make(
    "div",
    { className: "views", role: "group", "aria-label": "view" },
    ...(frames.length ? [make("span", {}, ...frames)] : []),
    make("span", {}, ...views),
    make("span", { className: "turns" }, ...turns),
    make("span", {}, ...zooms),
  );
}
