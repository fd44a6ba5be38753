/** What became of a structure, in the words of a summary; as in forficula.analysis. */

import { within } from "./engine-protocol.js";
import { summed } from "./engine-wing.js";

const FIRST_STEP = 1.5; // steps

/** What a way through a protocol came to, by the stages that took place; `widest`: how far closed loops came apart. */
export function outcomeOf(live, ends, divergedAt, widest) {
  const { course, protocol } = live;
  const ways = course.transitions.map((transition) => wayOf(live, ends, divergedAt, transition));
  const missedEnd = missed(live, ends, ways);
  const apart = widest > protocol.largestGap;
  const verdict = divergedAt !== null ? "diverged" : apart ? "untrusted" : verdictOf(protocol, missedEnd);
  const told = (tells(verdict) && missedEnd) || ways.findLast((way) => way.driven)?.driven;
  const way = told && wayAt(protocol, ways, told);
  const transition = way?.transition ?? null;
  const reading = tells(verdict) && way?.state ? furthest(live, transition, way.state.coordinates) : null;
  const why = verdict === "not held" && early(protocol, missedEnd) ? `the goal of stage "${protocol.stages[missedEnd.stage].name}" holds before it begins` : "";
  const short = verdict === "moving" && (missedEnd.atGoal ? "at its goal for too short a time when its stage was over" : missedEnd.atRest && "at rest under a torque that still rose when its stage was over");
  const ending = { verdict, transition, reading, time: divergedAt, why: apart ? apartText(live, widest) : why || short || "" };
  return {
    verdict,
    status: endingText(live, ending),
    word: endingWord(ending),
    advice: adviceOf(ending),
    transitions: ways.map((each) => transitionOf(protocol, each)),
    states: course.states.map((state) => stateOf(course, ends, ways, state)),
  };
}

/** Whether a verdict says something of the structure, rather than of the computation. */
export const tells = (verdict) => verdict !== "diverged" && verdict !== "untrusted";

function apartText({ size }, widest) {
  return `creases that close loops come apart by ${Number((widest / size).toPrecision(2))} of its size: a shorter timestep closes them`;
}

function wayOf({ course, protocol }, ends, divergedAt, transition) {
  const at = (stage) => ends.find((end) => end.stage === stage);
  const driven = transition.stage === null ? undefined : at(transition.stage);
  if (!driven) return { transition, driven: null, state: null, holds: false };
  const sound = (end) => end && end.mean !== null;
  const named = course.stageStates.findIndex((name, stage) => stage >= transition.stage && name === transition.state);
  const left = at(named < 0 ? transition.stage : named);
  const end = sound(left) ? left : sound(driven) ? driven : null;
  const own = protocol.stages[transition.stage];
  const state = course.states.find((each) => each.name === transition.state);
  const asked = sameGoal(own, transition.asked);
  const reached = driven.goal !== null || own.kind !== "bounds";
  const bounds = state && (asked ? transition.released : state.bounds);
  const holds = Boolean(end && bounds) && reached && within(end.mean.coordinates, bounds) && !early(protocol, driven);
  return { transition, driven, end, state: end?.mean ?? null, holds };
}

function sameGoal(one, other) {
  const alike = (side) => one[side].every((bound, place) => bound === other[side][place]);
  return one.kind === other.kind && alike("least") && alike("most");
}

function early(protocol, end) {
  const stage = protocol.stages[end.stage];
  return end.goal !== null && stage.drives.length > 0 && stage.kind === "bounds" && end.goal - end.start <= FIRST_STEP;
}

function missed({ protocol }, ends, ways) {
  const lost = ways.find((way) => way.driven && !way.holds);
  if (lost) return lost.driven;
  const last = ends.at(-1);
  return last && protocol.stages[last.stage].kind === "bounds" && last.goal === null ? last : null;
}

function verdictOf(protocol, end) {
  if (!end) return "reached";
  if (end.goal !== null) return "not held";
  const risen = protocol.stages[end.stage].drives.every((number) => end.end - end.start >= protocol.drives[number].rise);
  return end.atRest && risen && !end.atGoal ? "stuck" : "moving";
}

function wayAt(protocol, ways, end) {
  const { until, drives } = protocol.stages[end.stage];
  const acts = (name) => drives.some((number) => protocol.drives[number].name === name);
  return ways.find((way) => way.driven === end) ?? ways.find(({ transition }) => transition.goal === until || acts(transition.drive));
}

function transitionOf(protocol, { transition, driven, holds }) {
  const { name, words } = transition;
  if (!driven) return { name, words, took: null };
  const time = holds && driven.goal !== null ? (driven.goal - driven.start) * protocol.timestep : null;
  return { name, words, took: { succeeded: holds, time_s: time, work: driven.work } };
}

function stateOf(course, ends, ways, state) {
  const way = ways.find(({ transition }) => transition.state === state.name);
  if (way) return { name: way.holds ? state.name : state.missed, mean: way.state };
  const stage = course.stageStates.indexOf(state.name);
  const mean = ends.find((end) => end.stage === stage)?.mean ?? null;
  return { name: mean === null || within(mean.coordinates, state.bounds) ? state.name : state.missed, mean };
}

/** What reads furthest from a transition's goal, of the coordinates of a state. */
function furthest(live, { reading, furthest: side }, coordinates) {
  if (reading === null) return null;
  const values = readingOf(live, reading, coordinates);
  return side === "largest" ? Math.max(...values) : Math.min(...values);
}

/** What a measure reads, rad or the model's unit of length; of many the smallest, medians and the largest. */
export function readingOf(live, { parts, groups, distance }, coordinates) {
  if (distance !== undefined) return [coordinates[live.hinges.senses.length + distance]];
  const values = parts.map((part) => summed(coordinates, part));
  if (!groups.length) return values;
  const median = (places) => places.map((place) => values[place]).sort((one, other) => one - other)[(places.length - 1) >> 1];
  return [Math.min(...values), ...groups.map(median), Math.max(...values)];
}

function underWay({ transition, reading }) {
  if (transition?.begun == null || reading === null) return false;
  return transition.furthest === "largest" ? reading < transition.begun : reading > transition.begun;
}

function readingText(live, { kind }, reading) {
  if (kind === "distance") return `${Number((1e3 * live.units.length * reading).toPrecision(4))} mm`;
  return `${((180 / Math.PI) * reading).toFixed(1)} deg`;
}

/** In a few words, as a summary's status. */
function endingText(live, ending) {
  const { verdict, transition, reading, time, why } = ending;
  if (verdict === "untrusted") return `not to be trusted: ${why}`;
  if (verdict === "diverged") return `diverged at t = ${Number(time.toPrecision(4))} s`;
  if (transition === null) return "settled";
  const { words } = transition;
  if (verdict === "reached") return words.done;
  if (why) return why;
  if (verdict === "stuck") return underWay(ending) ? `stuck at ${readingText(live, transition, reading)}` : `did not ${words.verb}`;
  if (verdict === "not held") return `did not stay ${words.stays}`;
  const at = transition.begun !== null && reading !== null ? ` at ${readingText(live, transition, reading)}` : "";
  return `still moving${at} when its time to ${words.verb} was over`;
}

/** The same without its numbers: what many have in common. */
function endingWord(ending) {
  const { verdict, transition } = ending;
  if (verdict === "diverged") return "diverged";
  if (verdict === "untrusted") return "not to be trusted";
  if (transition === null) return "settled";
  const { words } = transition;
  if (verdict === "reached") return words.done;
  if (verdict === "moving") return `still ${words.doing}`;
  if (verdict === "stuck") return underWay(ending) ? "stuck on the way" : `did not ${words.verb}`;
  return `did not stay ${words.stays}`;
}

/** What is known to help without statics, which the page has not: less than what a run says. */
function adviceOf({ verdict }) {
  return verdict === "diverged" || verdict === "untrusted" ? "Take a shorter timestep." : "";
}
