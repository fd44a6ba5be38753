/** The live structure with its sliders, buttons and messages. */

import { firstLook } from "./camera.js";
import { make } from "./elements.js";
import { capital, filled, readable, timeText } from "./format.js";
import { makeLive } from "./live-clip.js";
import { mountStill } from "./player.js";
import { mountReadout } from "./readout.js";
import { watchTables } from "./tables.js";
import { makeDesignLink, valueText } from "./try-design.js";
import { makePushKeys } from "./try-push-keys.js";
import { listenToPushes } from "./try-push.js";
import { makeSliders } from "./try-sliders.js";

const PACES = [
  ["real time", 1],
  ["1/2", 0.5],
  ["1/5", 0.2],
  ["1/20", 0.05],
  ["1/100", 0.01],
];
const PACE = 0.2; // initial speed: at its own speed a wing snaps too fast to see
export const ROOM = 1.4; // distance of the eye without a run to frame, relative to the one that fits the start
const MEDDLED = "Values were changed, or it was pushed, during the motion, which no run of a design file repeats. \u201cWhole protocol\u201d runs these settings from the start.";
const LEAST = 1e-15; // J, below which an energy is a rounding error

/**
 * A panel of a page's clip and the data of its structure; `start` starts the engine.
 *
 * look: view of the camera, and pace, of a panel that this one replaces; set: receives the key and text of every changed
 * value, for a page that stores the design itself.
 */
export async function makePanel(clip, data, text, start, { look: seen, pace = PACE, set } = {}) {
  const own = JSON.parse(text);
  const panel = { frame: null, engine: null, pace };
  const engine = await start(text, (message) => hear(message));
  const live = makeLive(clip, own, engine.first);
  const said = make("p", { className: "verdict", role: "status" });
  const advice = make("p", { className: "note" });
  const moment = make("p", { className: "time" });
  const account = make("p", { className: "account" });
  const picture = make("div");
  const readout = make("div");
  const design = makeDesignLink(own);
  const sliders = makeSliders(own.knobs, data.kind === "bench" ? "the design" : "this run", (key, value) => {
    engine.send({ act: "set", values: { [key]: value } });
    sliders.refresh();
    design.refresh(sliders.changes);
    set?.(key, valueText(own, key, value));
  });
  const buttons = makeButtons(own, engine, panel, () => {
    said.textContent = "";
    advice.textContent = "";
  });
  const acting = own.motors.every((motor) => motor.kind === "torque") ? "torques" : "drives";
  let shownKey = null;

  function hear(message) {
    if (message.said === "refused") {
      said.textContent = `The simulator stopped: ${message.why}.`;
      return;
    }
    if (message.said === "frame") show(message.frame);
  }

  function show(frame) {
    panel.frame = frame;
    live.show(frame);
    moment.textContent = `${timeText(frame.time_s, { start: 0, end: Math.max(1, frame.time_s) })}${stageText(frame, own.protocol)}`;
    const energy = frame.energies_J.reduce((sum, each) => sum + each, 0);
    const work = frame.works_J.reduce((sum, each) => sum + each, 0);
    const parts = [...(clip.tendons ? [`tendon energy ${energyText(energy)}`] : []), `work of the ${acting} ${energyText(work)}`];
    account.textContent = parts.join(" \u00b7 ");
    const outcome = frame.stageNumber === null ? frame.ended : null;
    const key = outcome && JSON.stringify([outcome.verdict, ...outcome.stages.map((stage) => stage.end_s)]);
    if (key !== shownKey) {
      said.textContent = outcome ? sentence(outcome, data.whole, own.texts.outcome) : "";
      advice.textContent = [outcome?.advice, outcome && frame.meddled && MEDDLED].filter(Boolean).join(" ");
    }
    shownKey = key;
  }

  panel.element = make(
    "div",
    { className: "trial" },
    make("div", { className: "head" }, make("div", { className: "choices" }, ...buttons), make("div", { className: "live-facts" }, moment, account), said, advice),
    picture,
    make("div", { className: "hands" }, sliders.element, ...(set ? [] : [design.element])),
    readout,
  );

  /** Set up parts that need their place in the page. */
  panel.begin = () => {
    // framed for all that the run shows; a structure without a run is framed at its start, with a margin
    const look = seen ?? { ...firstLook(), following: false, closer: data.kind === "bench" ? ROOM : 1 };
    const { stage } = mountStill(picture, [live.clip], live.clock, { ...data, text: `${data.shape}, live.` }, look);
    panel.stage = stage;
    mountReadout(readout, live.clip, live.clock, data.energy);
    watchTables(panel.element);
    if (stage) {
      live.movable = own.anchors.bodies.map((body) => body > 0);
      const most = strongest(own, clip.mesh.span_m);
      const push = (point, force) => engine.send({ act: "push", point, force });
      listenToPushes(stage, live, clip.mesh.span_m, most, push);
      picture.querySelector(".picture").after(makePushKeys(stage, live, own.anchors.names, most, push));
    }
    show(engine.first);
    engine.send({ act: "pace", value: panel.pace });
    engine.send({ act: "restart", through: false });
    // without scrolling, because the page brings the whole panel into view
    if (data.kind !== "bench") buttons[0].focus({ preventScroll: true });
  };
  panel.leave = () => panel.stage?.dispose();
  return Object.assign(panel, { engine, live, sliders, design, own });
}

/** Largest force of the pointer, N: that of the run's strongest drive, at the end of the structure. */
function strongest({ protocol, motors }, span) {
  const forces = protocol.drives.map(({ strength, torques }) => {
    const motor = motors[torques.findIndex((torque) => torque !== 0)];
    return motor?.kind === "torque" ? Math.abs(strength) / span : motor?.kind === "force" ? Math.abs(strength) : 0;
  });
  return Math.max(...forces) || 1;
}

/** Buttons: start again, the driven stages, release, the whole protocol, and the speed. */
function makeButtons({ protocol }, engine, panel, before) {
  const button = (text, message, title) => {
    const made = make("button", { type: "button", title });
    made.append(text);
    made.addEventListener("click", () => {
      before();
      engine.send(message);
    });
    return made;
  };
  const driven = protocol.stages.flatMap(({ name, drives }, from) => {
    if (!drives.length) return [];
    const next = protocol.stages.findIndex((stage, number) => number > from && stage.drives.length > 0);
    const to = (next < 0 ? protocol.stages.length : next) - 1;
    return [button(capital(name), { act: "stages", from, to }, `the stage "${name}" of the protocol, and what follows without a drive`)];
  });
  const paces = make("select", {}, ...PACES.map(([name, value]) => make("option", { value, selected: value === panel.pace }, name)));
  paces.addEventListener("change", () => {
    panel.pace = Number(paces.value);
    engine.send({ act: "pace", value: panel.pace });
  });
  return [
    button("Start again", { act: "restart", through: false }, "from the start of the run"),
    ...driven,
    button("Release", { act: "release" }, "without any drive"),
    button("Whole protocol", { act: "restart", through: true }, "all stages, as in the run"),
    make("label", {}, "speed ", paces),
  ];
}

/** The present stage; after a release, the goal that was reached, because nothing more is known until it rests. */
function stageText({ stage, stageNumber, running, ended }, { stages }) {
  const met = stage && !stages[stageNumber].drives.length && ended?.stages.at(-1);
  const goal = met && met.goal_s !== null && stages.find(({ name }) => name === met.name).drives.length;
  const reached = goal ? `, ${met.name} reached its goal in ${readable(met.goal_s - met.start_s, "s")}` : "";
  if (stage) return ` \u00b7 ${stage}${reached}`;
  return running ? " \u00b7 no drive acts" : " \u00b7 at rest";
}

/** The outcome, with the time and the work of every transition. */
function sentence({ status, verdict, transitions }, whole, texts) {
  const parts = transitions
    .filter(({ took }) => took?.succeeded && took.time_s !== null)
    .map(({ words, took }) => filled(texts.transition, { did: words.did || words.done, time: readable(took.time_s, "s"), work: energyText(took.work_J) }));
  if (!parts.length) return `${capital(status)}.`;
  return filled(texts[verdict === "reached" ? "reached" : "missed"], { whole, transitions: parts.join(texts.then), status });
}

const energyText = (value) => readable(Math.abs(value) < LEAST ? 0 : value, "J");
