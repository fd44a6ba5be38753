/** The engine in a worker, for which the page never waits: messages come in, frames and outcomes go out. */

import loadEngine from "@mujoco/mujoco";
import { unpack } from "./clip.js";
import { outcomeOf, readingOf } from "./engine-outcome.js";
import { makeTracker } from "./engine-protocol.js";
import { leastValues } from "./engine-search.js";
import { buildModel, makeWing } from "./engine-wing.js";
import { takeUnits } from "./format.js";

const FRAME = 16; // ms between frames
const BUDGET = 12; // ms of each frame for steps
const AFTER = 10; // s after the last change for which it continues

let engine = null;
let live = null;
let wing = null;
let tracker = null;
let pace = 1; // simulated time per time
let timer = null;
let debt = 0; // simulated seconds still to be computed
let last = 0;
let quiet = 0; // seconds since the last change
let meddled = false; // whether it was pushed, or a value that acts on it changed, since the start of the run

/** Start the engine once, and build the model; returns the first frame or the reason for a failure. */
async function load({ program, text }) {
  pause();
  wing?.dispose();
  wing = null;
  engine ??= await startEngine(program);
  live = JSON.parse(text);
  takeUnits(live.texts.reading_units);
  wing = makeWing(engine, live, await buildModel(engine, live));
  tracker = makeTracker(wing, live.protocol);
  return { said: "loaded", version: engine.mj_versionString(), frame: frame() };
}

function startEngine(program) {
  // the engine's own messages are not displayed
  const quiet = () => {};
  return new Promise((take, refuse) => {
    const instantiateWasm = (imports, done) => {
      instantiate(program, imports, done).catch(refuse);
      return {};
    };
    loadEngine({ instantiateWasm, print: quiet, printErr: quiet }).then(take, refuse);
  });
}

/** Compile the program while it is inflated. */
async function instantiate(program, imports, done) {
  const bytes = Uint8Array.fromBase64?.(program) ?? unpack(program, Uint8Array);
  const inflated = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  const response = new Response(inflated, { headers: { "Content-Type": "application/wasm" } });
  const { instance, module } = await WebAssembly.instantiateStreaming(response, imports);
  done(instance, module);
}

/** Everything that the page displays of a moment. */
function frame() {
  wing.place();
  const points = wing.points(new Float32Array(3 * live.anchors.bodies.length));
  const coordinates = wing.coordinates(new Float64Array(wing.coordinateCount));
  const lengths = wing.tendonLengths(new Float64Array(wing.tendons));
  const { ends, divergedAt, stage, steps } = tracker;
  return {
    time_s: steps * live.protocol.timestep,
    stage: stage === null ? null : live.protocol.stages[stage].name,
    stageNumber: stage,
    points,
    readings: live.readings.map((reading) => readingOf(live, reading, coordinates)),
    energies_J: wing.tendonEnergies(new Float64Array(wing.tendons), lengths),
    restLengths_m: Array.from(lengths, (_, tendon) => live.units.length * wing.restLength(tendon)),
    works_J: Array.from(tracker.works, (work) => live.units.energy * work),
    ended: ends.length || divergedAt !== null ? summaryOf(ends, divergedAt) : null,
    meddled,
    running: timer !== null,
  };
}

/** Outcome of the stages so far; of a part of the protocol only its own transitions. */
function summaryOf(ends, divergedAt) {
  const outcome = outcomeOf(live, ends, divergedAt, wing.widest);
  for (const { took } of outcome.transitions) if (took) took.work_J = live.units.energy * took.work;
  return {
    ...outcome,
    stages: ends.map((end) => ({
      name: live.protocol.stages[end.stage].name,
      start_s: end.start * live.protocol.timestep,
      end_s: end.end * live.protocol.timestep,
      goal_s: end.goal === null ? null : end.goal * live.protocol.timestep,
      work_J: live.units.energy * end.work,
      readings: end.mean && live.readings.map((reading) => readingOf(live, reading, end.mean.coordinates)),
      energies_J: end.mean && Array.from(end.mean.energies),
    })),
  };
}

/** Run the protocol, up to a stage, without display, with some values in place of the design's. */
function run({ values, until = live.protocol.stages.length - 1 }) {
  pause();
  // changes that a reader made while it moved do not apply
  const home = Object.fromEntries(live.knobs.map(({ key, value }) => [key, value]));
  for (const [key, value] of Object.entries({ ...home, ...values })) if (value !== wing.values.get(key)) wing.set(key, value);
  begin();
  tracker.begin(0, until);
  while (tracker.stage !== null) tracker.step();
  return { said: "outcome", outcome: summaryOf(tracker.ends, tracker.divergedAt), steps: tracker.steps };
}

/** Answer for a study's point: the outcome of its protocol, or the least values. */
function answer({ values, search }) {
  const runUntil = (more, until) => run({ values: { ...values, ...more }, until }).outcome;
  return { said: "answer", answer: search ? leastValues(search, runUntil) : { ...runUntil({}), least: {} } };
}

/** Return to the start of the run. */
function begin() {
  tracker.restart();
  meddled = false;
}

/** Whether another earlier value would have changed the motion. */
function acts(key) {
  const { drive } = live.knobs.find((knob) => knob.key === key);
  const acting = tracker.stage === null ? [] : live.protocol.stages[tracker.stage].drives;
  return tracker.steps > 0 && (drive === undefined || acting.includes(drive));
}

function play() {
  if (timer !== null) return;
  last = performance.now();
  debt = quiet = 0;
  timer = setInterval(advance, FRAME);
}

/** Continue, unless the simulation has diverged. */
function move() {
  if (tracker.divergedAt === null) play();
}

function pause() {
  clearInterval(timer);
  timer = null;
}

/** Take as many steps as real time requires, within the budget. */
function advance() {
  const now = performance.now();
  const passed = Math.min((now - last) / 1000, 0.1);
  last = now;
  debt = Math.min(debt + pace * passed, 0.1 * pace);
  quiet = tracker.stage === null ? quiet + passed : 0;
  while (debt >= live.protocol.timestep && performance.now() - now < BUDGET) {
    for (let step = 0; step < 20 && debt >= live.protocol.timestep; step++) {
      tracker.step();
      debt -= live.protocol.timestep;
      if (tracker.divergedAt !== null) break;
    }
    if (tracker.divergedAt !== null) break;
  }
  if (tracker.divergedAt !== null || quiet > AFTER) pause();
  self.postMessage({ said: "frame", frame: frame() });
}

const ACTS = {
  load,
  run,
  answer,
  /** Set values while it moves. */
  set({ values }) {
    for (const [key, value] of Object.entries(values)) {
      meddled ||= value !== wing.values.get(key) && acts(key);
      wing.set(key, value);
    }
    quiet = 0;
    if (tracker.stage === null) move();
    return { said: "frame", frame: frame() };
  },
  /** Restart: run all stages, or only those before the first driven one. */
  restart({ through }) {
    begin();
    const { stages } = live.protocol;
    const driven = stages.findIndex((stage) => stage.drives.length > 0);
    if (!through && driven === 0) tracker.release();
    else if (!through && driven > 0) tracker.begin(0, driven - 1);
    play();
    return { said: "frame", frame: frame() };
  },
  /** Run some stages of the protocol from the present state. */
  stages({ from, to }) {
    if (tracker.divergedAt !== null) begin();
    tracker.begin(from, to);
    play();
  },
  release() {
    if (tracker.divergedAt !== null) begin();
    tracker.release();
    play();
  },
  pace({ value }) {
    pace = value;
  },
  pause() {
    pause();
    return { said: "frame", frame: frame() };
  },
  push({ point, force }) {
    wing.push(point, force);
    meddled ||= force !== null;
    move();
  },
};

self.onmessage = async ({ data }) => {
  // nothing moves between two structures
  if (wing === null && data.act !== "load") return;
  try {
    const answer = await ACTS[data.act](data);
    if (answer) self.postMessage({ ...answer, to: data.number });
  } catch (error) {
    self.postMessage({ said: "refused", why: error.message ?? String(error), to: data.number });
  }
};
