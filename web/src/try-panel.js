/** The live structure with its sliders, its buttons and what it says. */

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
const PACE = 0.2; // to begin with: at its own a wing snaps faster than anyone sees
const ROOM = 1.4; // distance of the eye where no run tells where it goes, by that which fits where it begins
const MEDDLED = "On the way values were changed or it was pushed, which no run of a design file does; Whole protocol goes through that from the start.";
const LEAST = 1e-15; // J, below which an energy is what is left of rounding

/**
 * A panel of a page's clip and of what it has of the structure; `start` starts the engine.
 *
 * look: of a camera, and pace, of another panel whose place this one takes; set: told the key of every value that is
 * changed, and its text in a design file, by a page that keeps the design itself.
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
    engine.tell({ act: "set", values: { [key]: value } });
    sliders.refresh();
    design.refresh(sliders.changes);
    set?.(key, valueText(own, key, value));
  });
  const buttons = makeButtons(own, engine, panel, () => {
    said.textContent = "";
    advice.textContent = "";
  });
  const acting = own.motors.every((motor) => motor.kind === "torque") ? "torques" : "drives";
  let told = null;

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
    if (key !== told) {
      said.textContent = outcome ? sentence(outcome, data.whole, own.texts.outcome) : "";
      advice.textContent = [outcome?.advice, outcome && frame.meddled && MEDDLED].filter(Boolean).join(" ");
    }
    told = key;
  }

  panel.element = make(
    "div",
    { className: "trial" },
    make("div", { className: "seen" }, make("div", { className: "choices" }, ...buttons), make("div", { className: "told" }, moment, account), said, advice, picture, readout),
    make("div", { className: "hands" }, sliders.element, ...(set ? [] : [design.element])),
  );

  /** What needs its place in the page. */
  panel.begin = () => {
    // framed so that all that the run shows is in the picture; where it begins alone, with room to move
    const look = seen ?? { ...firstLook(), following: false, closer: data.kind === "bench" ? ROOM : 1 };
    const { stage } = mountStill(picture, [live.clip], live.clock, { ...data, text: `${data.shape}, live.` }, look);
    panel.stage = stage;
    mountReadout(readout, live.clip, live.clock, data.energy);
    watchTables(panel.element);
    if (stage) {
      live.movable = own.anchors.bodies.map((body) => body > 0);
      const most = strongest(own, clip.mesh.span_m);
      const push = (point, force) => engine.tell({ act: "push", point, force });
      listenToPushes(stage, live, clip.mesh.span_m, most, push);
      picture.querySelector(".picture").after(makePushKeys(stage, live, own.anchors.names, most, push));
    }
    show(engine.first);
    engine.tell({ act: "pace", value: panel.pace });
    engine.tell({ act: "restart", through: false });
    if (data.kind !== "bench") buttons[0].focus();
  };
  panel.leave = () => panel.stage?.dispose();
  return Object.assign(panel, { engine, live, sliders, design, own });
}

/** The largest force of a pointer, N: that of the strongest drive of the run, at the end of the structure. */
function strongest({ protocol, motors }, span) {
  const forces = protocol.drives.map(({ strength, torques }) => {
    const motor = motors[torques.findIndex((torque) => torque !== 0)];
    return motor?.kind === "torque" ? Math.abs(strength) / span : motor?.kind === "force" ? Math.abs(strength) : 0;
  });
  return Math.max(...forces) || 1;
}

/** Start again, the driven stages of the protocol, let go, all of it, and how fast. */
function makeButtons({ protocol }, engine, panel, before) {
  const button = (text, message, title) => {
    const made = make("button", { type: "button", title });
    made.append(text);
    made.addEventListener("click", () => {
      before();
      engine.tell(message);
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
    engine.tell({ act: "pace", value: panel.pace });
  });
  return [
    button("Start again", { act: "restart", through: false }, "from where the run begins"),
    ...driven,
    button("Let go", { act: "release" }, "without any drive"),
    button("Whole protocol", { act: "restart", through: true }, "all stages, as in the run"),
    make("label", {}, "speed ", paces),
  ];
}

/** What it goes through; let go after a goal, what was reached, for until it rests nothing is said of it. */
function stageText({ stage, stageNumber, running, ended }, { stages }) {
  const met = stage && !stages[stageNumber].drives.length && ended?.stages.at(-1);
  const goal = met && met.goal_s !== null && stages.find(({ name }) => name === met.name).drives.length;
  const reached = goal ? `, ${met.name} reached its goal in ${readable(met.goal_s - met.start_s, "s")}` : "";
  if (stage) return ` \u00b7 ${stage}${reached}`;
  return running ? " \u00b7 no drive acts" : " \u00b7 at rest";
}

/** What became of it, with the time and the work of every transition. */
function sentence({ status, verdict, transitions }, whole, texts) {
  const parts = transitions
    .filter(({ took }) => took?.succeeded && took.time_s !== null)
    .map(({ words, took }) => filled(texts.transition, { did: words.did || words.done, time: readable(took.time_s, "s"), work: energyText(took.work_J) }));
  if (!parts.length) return `${capital(status)}.`;
  return filled(texts[verdict === "reached" ? "reached" : "missed"], { whole, transitions: parts.join(texts.then), status });
}

const energyText = (value) => readable(Math.abs(value) < LEAST ? 0 : value, "J");
