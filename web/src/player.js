/** Structures in 3-D with the controls of their clock, in an element of any page. */

import { VIEWS } from "./camera.js";
import { showCreases } from "./crease-label.js";
import { effortTexts } from "./efforts.js";
import { make } from "./elements.js";
import { short } from "./format.js";
import { keysHelp, listenToKeys, listenToLooks } from "./keys.js";
import { gradientSwatch, makeLegend } from "./legend.js";
import { STRAIN_COLOURS } from "./scheme.js";
import { makeShape } from "./shape.js";
import { makeStage } from "./stage.js";
import { makeTransport, stageText } from "./transport.js";

/**
 * Display clips side by side with a common clock.
 *
 * energy: {unit, factor, largest_J} for the tendons' colours; legend: samples of colours with their meanings; text: a
 * sentence about the picture; whole: noun for one of the structures; look: initial view of the camera; scaled: whether
 * the structures of several clips, shown together or one after another, may have one scale.
 * Returns {stage, dispose}; stage is null without WebGL.
 */
export function mountPlayer(element, clips, clock, { energy, legend: entries, text, whole }, look, scaled = clips.length > 1 || Boolean(look)) {
  const stage = makeStage(clips, clock, (clip) => makeShape(clip, energy.largest_J), text, look);
  const picture = stage
    ? make("div", { className: "picture" }, stage.element, viewButtons(stage.eye, scaled ? whole : null))
    : make("p", { className: "note" }, noPicture(whole));
  if (stage && clips.length === 1) nameState(stage.cells[0], clips[0], clock);
  const legend = stage ? [makeLegend(entries, energy, stage.eye.size, clips.length > 1 ? whole : null)] : [];
  if (stage && clips.some((clip) => clip.strained)) legend.unshift(colourChoice(stage, legend[0]));
  if (stage && clips.length === 1 && clips[0].efforts?.drives.length) tellEfforts(legend.at(-1), clips[0], clock);
  if (stage && clips.length > 1 && clips.some((clip) => clip.efforts?.drives.some((drive) => drive.arrow)))
    legend.at(-1).append(make("li", { className: "effort" }, arrowSample(), "torque or force of a drive, while it acts"));
  const creases = stage && clips.length === 1 && clips[0].creases ? [showCreases(stage, clips[0], clock)] : [];
  element.replaceChildren(picture, makeTransport(clips, clock), ...creases, ...legend, keysHelp(clips, stage !== null, whole));
  element.classList.add("player");
  element.setAttribute("role", "region");
  element.setAttribute("aria-label", `the moving ${whole}`);
  const deaf = listenToKeys(element, clips, clock, stage?.eye, VIEWS[0]);

  function dispose() {
    clock.pause();
    deaf();
    stage?.dispose();
    element.replaceChildren();
  }

  return { stage, dispose };
}

/** Display structures without a time line, which sliders move; arguments as for mountPlayer. */
export function mountStill(element, clips, clock, { energy, legend: entries, text, whole }, look) {
  const stage = makeStage(clips, clock, (clip) => makeShape(clip, energy.largest_J), text, look);
  if (!stage) {
    element.replaceChildren(make("p", { className: "note" }, noPicture(whole)));
    return { stage };
  }
  const picture = make("div", { className: "picture" }, stage.element, viewButtons(stage.eye, null, !look));
  const legend = [makeLegend(entries, { ...energy, orMore: true }, stage.eye.size, null)];
  if (clips.some((clip) => clip.strained)) legend.unshift(colourChoice(stage, legend[0]));
  element.replaceChildren(picture, ...legend);
  element.classList.add("player");
  element.setAttribute("role", "region");
  element.setAttribute("aria-label", `the ${whole} as set by the sliders`);
  listenToLooks(element, stage.eye, VIEWS[0]);
  return { stage };
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
  const said = make("span");
  legend.append(make("li", { className: "effort" }, ...(arrow ? [arrowSample()] : []), said));
  clock.onChange(() => {
    said.textContent = effortTexts(clip.efforts, clock.clipTime(0), short).join("; ") || "no drive acts now";
  });
}

/** Choice of the sheet's colours: regions, or strain with its scale in the legend. */
function colourChoice(stage, legend) {
  const names = ["panels", "membrane strain"];
  const bar = make("li", { className: "energy", hidden: true });
  legend.append(bar);
  const buttons = names.map((name, strained) => {
    const button = make("button", { type: "button", "aria-pressed": String(!strained) }, name);
    button.addEventListener("click", () => {
      const largest = stage.showStrain(Boolean(strained));
      bar.replaceChildren("Green strain of the membrane: 0", gradientSwatch(STRAIN_COLOURS), `${short(100 * largest)} %`);
      bar.hidden = !strained;
      for (const entry of legend.querySelectorAll(".of-region")) entry.hidden = Boolean(strained);
      for (const each of buttons) each.setAttribute("aria-pressed", String(each === button));
    });
    return button;
  });
  return make("div", { className: "colours", role: "group", "aria-label": "colour of the sheet" }, "colour:", make("span", {}, ...buttons));
}

export function noPicture(whole) {
  return `This browser has no WebGL, so the ${whole} cannot be drawn in 3-D. The plots and all numbers are below.`;
}

/**
 * whole: noun for one of several structures, displayed side by side or one after another; null for a single one.
 * follows: whether the picture can be kept filled, which requires known future positions.
 */
export function viewButtons(eye, whole, follows = true) {
  const button = (text, label, action) => {
    const made = make("button", { type: "button", title: label, "aria-label": label }, text);
    made.addEventListener("click", action);
    return made;
  };
  const views = VIEWS.map((view) => button(view.name, `${view.name}: view ${view.text}`, () => eye.show(view)));
  const turns = [
    ["\u2190", "turn left", [-1, 0]],
    ["\u2192", "turn right", [1, 0]],
    ["\u2191", "turn up", [0, 1]],
    ["\u2193", "turn down", [0, -1]],
  ].map(([text, label, steps]) => button(text, label, () => eye.turn(...steps)));
  const switched = (text, label, choice) => {
    const made = button(text, label, () => {
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
  const zooms = [button("+", "nearer", () => eye.zoom(1)), button("\u2212", "further", () => eye.zoom(-1))];
  return make(
    "div",
    { className: "views", role: "group", "aria-label": "view" },
    ...(frames.length ? [make("span", {}, ...frames)] : []),
    make("span", {}, ...views),
    make("span", { className: "turns" }, ...turns),
    make("span", {}, ...zooms),
  );
}
