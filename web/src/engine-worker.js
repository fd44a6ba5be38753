/** The engine in a worker of a page, which never waits for it: messages go in, frames and outcomes come out. */

import loadEngine from "@mujoco/mujoco";
import { unpack } from "./clip.js";
import { outcomeOf, readingOf } from "./engine-outcome.js";
import { makeTracker } from "./engine-protocol.js";
import { leastValues } from "./engine-search.js";
import { buildModel, makeWing } from "./engine-wing.js";
import { takeUnits } from "./format.js";

const FRAME = 16; // ms
const BUDGET = 12; // ms of them in which it steps
const AFTER = 10; // seconds for which it goes on when nothing is done to it any more

let engine = null;
let live = null;
let wing = null;
let tracker = null;
let pace = 1; // of simulated time by time
let timer = null;
let debt = 0; // simulated seconds that are to be made up
let last = 0;
let quiet = 0; // seconds since something was done to it
let meddled = false; // whether it was pushed, or what acts on it changed, since it began where the run begins

/** Start the engine, once, and build what the page has; says what there is, or why there is nothing. */
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
  // what the engine writes of itself no page should say
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

/** All that the page shows of a moment. */
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
    ended: ends.length || divergedAt !== null ? told(ends, divergedAt) : null,
    meddled,
    running: timer !== null,
  };
}

/** What came of the stages so far; of some stages in the middle only what they did themselves. */
function told(ends, divergedAt) {
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

/** Take the protocol, up to a stage, at once, with some values in the place of the design's. */
function run({ values, until = live.protocol.stages.length - 1 }) {
  pause();
  // what a reader has changed while it moved is none of what is asked
  const home = Object.fromEntries(live.knobs.map(({ key, value }) => [key, value]));
  for (const [key, value] of Object.entries({ ...home, ...values })) if (value !== wing.values.get(key)) wing.set(key, value);
  begin();
  tracker.begin(0, until);
  while (tracker.stage !== null) tracker.step();
  return { said: "outcome", outcome: told(tracker.ends, tracker.divergedAt), steps: tracker.steps };
}

/** What a study asks of a point: what its protocol comes to, or the least values that it looks for. */
function answer({ values, search }) {
  const runUntil = (more, until) => run({ values: { ...values, ...more }, until }).outcome;
  return { said: "answer", answer: search ? leastValues(search, runUntil) : { ...runUntil({}), least: {} } };
}

/** From where the run begins. */
function begin() {
  tracker.restart();
  meddled = false;
}

/** Whether it would have moved otherwise, had this value been another one before. */
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

/** Go on, unless it has diverged: from there it gets nowhere. */
function move() {
  if (tracker.divergedAt === null) play();
}

function pause() {
  clearInterval(timer);
  timer = null;
}

/** As many steps as real time asks for, or as there is time for. */
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
  /** Put values in the place of others while it moves. */
  set({ values }) {
    for (const [key, value] of Object.entries(values)) {
      meddled ||= value !== wing.values.get(key) && acts(key);
      wing.set(key, value);
    }
    quiet = 0;
    if (tracker.stage === null) move();
    return { said: "frame", frame: frame() };
  },
  /** Begin again where the run begins: through all stages, or up to the first that is driven. */
  restart({ through }) {
    begin();
    const { stages } = live.protocol;
    const driven = stages.findIndex((stage) => stage.drives.length > 0);
    if (!through && driven === 0) tracker.release();
    else if (!through && driven > 0) tracker.begin(0, driven - 1);
    play();
    return { said: "frame", frame: frame() };
  },
  /** Go through some stages of the protocol from where it is. */
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
  // between two structures nothing moves
  if (wing === null && data.act !== "load") return;
  try {
    const answer = await ACTS[data.act](data);
    if (answer) self.postMessage({ ...answer, to: data.number });
  } catch (error) {
    self.postMessage({ said: "refused", why: error.message ?? String(error), to: data.number });
  }
};
