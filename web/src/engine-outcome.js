/** Outcome of a structure, in the words of a summary; same rules as forficula.analysis. */

import { within } from "./engine-protocol.js";
import { summed } from "./engine-wing.js";
import { filled, readable } from "./format.js";

const FIRST_STEP = 1.5; // steps

/** Outcome of a path through a protocol, from the stages that took place; `widest`: largest gap of loops and supports. */
export function outcomeOf(live, ends, divergedAt, widest) {
  const { course, protocol, texts } = live;
  const { endings } = texts;
  const ways = course.transitions.map((transition) => wayOf(live, ends, divergedAt, transition));
  const missedEnd = missed(live, ends, ways);
  const apart = widest > protocol.largestGap;
  const verdict = divergedAt !== null ? "diverged" : apart ? "untrusted" : verdictOf(protocol, missedEnd);
  const decisive = (isConclusive(verdict) && missedEnd) || ways.findLast((way) => way.driven)?.driven;
  const way = decisive && wayAt(protocol, ways, decisive);
  const transition = way?.transition ?? null;
  const reading = isConclusive(verdict) && way?.state ? furthest(live, transition, way.state.coordinates) : null;
  const why = verdict === "not held" && early(protocol, missedEnd) ? filled(endings["not held, early"], { stage: protocol.stages[missedEnd.stage].name }) : "";
  const short = verdict === "moving" && (missedEnd.atGoal ? endings["moving, too short"] : missedEnd.atRest && endings["moving, torque rises"]);
  const ending = { verdict, transition, reading, time: divergedAt, why: apart ? apartText(live, widest) : why || short || "" };
  return {
    verdict,
    status: endingText(live, ending),
    word: endingWord(live, ending),
    advice: texts.advice[verdict] ?? "",
    transitions: ways.map((each) => transitionOf(protocol, each)),
    states: course.states.map((state) => stateOf(course, ends, ways, state)),
  };
}

/** Whether a verdict is about the structure and not about the computation. */
export const isConclusive = (verdict) => verdict !== "diverged" && verdict !== "untrusted";

function apartText({ size, texts }, widest) {
  return filled(texts.apart, { share: Number((widest / size).toPrecision(2)) });
}

function wayOf({ course, protocol }, ends, divergedAt, transition) {
  const at = (stage) => ends.find((end) => end.stage === stage);
  const driven = transition.stage === null ? undefined : at(transition.stage);
  if (!driven) return { transition, driven: null, state: null, holds: false };
  // several driven stages may lead to a state
  const begun = at(transition.begins);
  const work = ends.filter(({ stage }) => stage >= transition.begins && stage <= transition.stage).reduce((sum, each) => sum + each.work, 0);
  const sound = (end) => end && end.mean !== null;
  const named = course.stageStates.findIndex((name, stage) => stage >= transition.stage && name === transition.state);
  const left = at(named < 0 ? transition.stage : named);
  const end = sound(left) ? left : sound(driven) ? driven : null;
  const own = protocol.stages[transition.stage];
  const state = course.states.find((each) => each.name === transition.state);
  const asked = sameGoal(own, transition.asked);
  const reached = driven.goal !== null || own.kind !== "bounds";
  const bounds = state && (asked ? transition.released : state.bounds);
  const between = ends.filter(({ stage }) => stage > transition.stage && stage <= named);
  const lost = between.some((each) => protocol.stages[each.stage].kind === "bounds" && each.goal === null);
  const holds = Boolean(end && bounds) && reached && !lost && within(end.mean.coordinates, bounds) && !early(protocol, driven);
  return { transition, begun, driven, work, end, state: end?.mean ?? null, holds };
}

function sameGoal(one, other) {
  const sameBounds = (side) => one[side].every((bound, place) => bound === other[side][place]);
  return one.kind === other.kind && sameBounds("least") && sameBounds("most");
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

function transitionOf(protocol, { transition, begun, driven, work, holds }) {
  const { name, words } = transition;
  if (!driven) return { name, words, took: null };
  const time = holds && driven.goal !== null ? (driven.goal - begun.start) * protocol.timestep : null;
  return { name, words, took: { succeeded: holds, time_s: time, work } };
}

function stateOf(course, ends, ways, state) {
  const way = ways.find(({ transition }) => transition.state === state.name);
  if (way) return { name: way.holds ? state.name : state.missed, mean: way.state };
  const stage = course.stageStates.indexOf(state.name);
  const mean = ends.find((end) => end.stage === stage)?.mean ?? null;
  return { name: mean === null || within(mean.coordinates, state.bounds) ? state.name : state.missed, mean };
}

/** The reading furthest from a transition's goal, for the coordinates of a state. */
function furthest(live, { reading, furthest: side }, coordinates) {
  if (reading === null) return null;
  const values = readingOf(live, reading, coordinates);
  return side === "largest" ? Math.max(...values) : Math.min(...values);
}

/** Readings of a measure, rad or the model's unit of length; for many the smallest, medians and the largest. */
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
  if (kind === "distance") return readable(live.units.length * reading, "m");
  return `${((180 / Math.PI) * reading).toFixed(1)} deg`;
}

/** The outcome in a few words, as a summary's status. */
function endingText(live, ending) {
  const { verdict, transition, reading, time, why } = ending;
  const { endings } = live.texts;
  if (verdict === "untrusted") return filled(endings["untrusted, why"], { why });
  if (verdict === "diverged") return filled(endings["diverged, time"], { time: Number(time.toPrecision(4)) });
  if (transition === null || verdict === "reached") return endingWord(live, ending);
  if (why) return why;
  const fields = { ...transition.words, reading: reading === null ? "" : readingText(live, transition, reading) };
  if (verdict === "moving") return filled(endings[transition.begun !== null && reading !== null ? "moving, reading" : "moving, limit"], fields);
  return verdict === "stuck" && underWay(ending) ? filled(endings["stuck, reading"], fields) : endingWord(live, ending);
}

/** The outcome without numbers: the part that many runs have in common. */
function endingWord({ texts: { endings } }, ending) {
  const { verdict, transition } = ending;
  if (!isConclusive(verdict)) return endings[verdict];
  if (transition === null) return verdict === "reached" ? endings.settled : endings.missed;
  return filled(endings[verdict === "stuck" && underWay(ending) ? "stuck, under way" : verdict], transition.words);
}
