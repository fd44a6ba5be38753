/** Structures in 3-D with the controls of their clock, in an element of any page. */

import { VIEWS } from "./camera.js";
import { make } from "./elements.js";
import { keysHelp, listenToKeys } from "./keys.js";
import { makeLegend } from "./legend.js";
import { makeShape } from "./shape.js";
import { makeStage } from "./stage.js";
import { makeTransport, stageText } from "./transport.js";

/**
 * Show clips side by side on one clock.
 *
 * energy: {unit, factor, largest_J} of the tendons' colours; legend: samples of colours with what they mean; text: what
 * the picture shows, in a sentence; whole: what one of the structures is called; look: of a camera, to begin with.
 * Returns {stage, dispose}; stage is null without WebGL.
 */
export function mountPlayer(element, clips, clock, { energy, legend: entries, text, whole }, look) {
  const stage = makeStage(clips, clock, (clip) => makeShape(clip, energy.largest_J), text, look);
  const picture = stage
    ? make("div", { className: "picture" }, stage.element, viewButtons(stage.eye, clips.length > 1 || look ? whole : null))
    : make("p", { className: "note" }, noPicture(whole));
  if (stage && clips.length === 1) nameState(stage.cells[0], clips[0], clock);
  const legend = stage ? [makeLegend(entries, energy, stage.eye.size, clips.length > 1 ? whole : null)] : [];
  element.replaceChildren(picture, makeTransport(clips, clock), ...legend, keysHelp(clips, stage !== null, whole));
  element.classList.add("player");
  element.setAttribute("role", "region");
  element.setAttribute("aria-label", `the ${whole} moving`);
  const deaf = listenToKeys(element, clips, clock, stage?.eye, VIEWS[0]);

  function dispose() {
    clock.pause();
    deaf();
    stage?.dispose();
    element.replaceChildren();
  }

  return { stage, dispose };
}

/** Write into the picture of a single structure which state it is in, or what is done to it. */
function nameState(cell, clip, clock) {
  const name = make("p", { className: "now", "aria-hidden": "true" });
  cell.append(name);
  clock.onChange(() => {
    name.textContent = stageText(clip, clock.clipTime(0));
  });
}

export function noPicture(whole) {
  return `This browser has no WebGL, so the ${whole} cannot be drawn in 3-D. The plots and all numbers are here.`;
}

/** whole: what one of several structures is called, which are seen beside or after each other; null of a single one. */
export function viewButtons(eye, whole) {
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
    switched("follow", "follow: keep the picture filled as it moves", "following"),
    ...(whole ? [switched("one scale", `one scale: all ${whole}s as large as they are by each other`, "oneScale")] : []),
  ];
  const zooms = [button("+", "nearer", () => eye.zoom(1)), button("\u2212", "further", () => eye.zoom(-1))];
  return make(
    "div",
    { className: "views", role: "group", "aria-label": "view" },
    make("span", {}, ...frames),
    make("span", {}, ...views),
    make("span", { className: "turns" }, ...turns),
    make("span", {}, ...zooms),
  );
}
