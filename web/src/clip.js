/**
 * A run that can be played: frames of moving points, numbers that belong to them, and the shapes between them.
 * Lengths are in m, times in s, readings in their own unit, energies in J.
 */

import { readEfforts } from "./efforts.js";

/** Name of the tendon energies among the values of a clip. */
export const TENDONS = "tendon energy";
/** Name of the readings of single creases among them. */
export const CREASES = Symbol("readings of single creases");

/** Decode numbers that the page contains as little-endian bytes in base64. */
export function unpack(text, Kind) {
  const letters = atob(text);
  const bytes = new Uint8Array(letters.length);
  for (let index = 0; index < letters.length; index++) bytes[index] = letters.charCodeAt(index);
  return new Kind(bytes.buffer);
}

/** Decode numbers of columns that the page contains as 2-byte steps above the least number of each column. */
function unpackSteps({ low, step, steps }) {
  return Float32Array.from(unpack(steps, Uint16Array), (value, at) => low[at % low.length] + step[at % low.length] * value);
}

export function readClip(data) {
  const time = unpack(data.time, Float64Array);
  const points = typeof data.points === "string" ? unpack(data.points, Float32Array) : unpackSteps(data.points);
  const width = 3 * data.pointCount;
  const tables = { [TENDONS]: { width: data.tendonParts.length, values: unpack(data.tendonEnergy_J, Float32Array) } };
  for (const reading of data.readings)
    tables[reading.name] = { width: reading.parts.length, values: unpack(reading.values, Float32Array) };
  const { creases = null } = data;
  // a measure may have any name
  const along = (data.along ?? []).map((each) => ({ ...each, key: Symbol(each.name) }));
  for (const { key, values } of along) tables[key] = { width: 1, values: unpack(values, Float32Array) };
  if (creases) tables[CREASES] = { width: creases.values.low.length, values: unpackSteps(creases.values) };
  const between = Int32Array.from(data.between);
  const share = Float64Array.from(data.share);
  const now = new Float32Array(width);

  /** Write the points at a time, interpolated between frames. */
  function pointsAt(moment, into = now) {
    mix(time, points, width, moment, into);
    return into;
  }

  /** Write the vertices at a time; they lie between the points. */
  function verticesAt(moment, into = new Float32Array(3 * share.length)) {
    return verticesOf(pointsAt(moment), into);
  }

  function verticesOf(place, into) {
    for (let vertex = 0; vertex < share.length; vertex++) {
      const first = 3 * between[2 * vertex];
      const second = 3 * between[2 * vertex + 1];
      for (let axis = 0; axis < 3; axis++) {
        const from = place[first + axis];
        into[3 * vertex + axis] = from + share[vertex] * (place[second + axis] - from);
      }
    }
    return into;
  }

  /** Readings by name, in their unit, or the energies of the tendons, J, at a time. */
  function valuesAt(name, moment, into = new Float32Array(tables[name].width)) {
    mix(time, tables[name].values, tables[name].width, moment, into);
    return into;
  }

  /** One of these values over all frames. */
  function line(name, part) {
    const { width, values } = tables[name];
    return Float32Array.from(time, (_, frame) => values[frame * width + part]);
  }

  const rests = unpack(data.restLength_m, Float32Array);

  /** Lengths below which tendons are slack, m, at a time. */
  function restLengthsAt(moment, into) {
    if (rests.length === into.length) into.set(rests);
    else mix(time, rests, into.length, moment, into);
  }

  const efforts = data.efforts && readEfforts(data.efforts);

  return {
    name: data.name,
    /** Distance beyond the points that drawn parts may reach, m: rods along fixed parts, and arrows. */
    reach: Math.max(data.base.radius, efforts?.pushes.length ? 0.12 * data.span_m : 0, ...(efforts?.turns ?? []).map((turn) => 0.4 * turn.radius)),
    mesh: data,
    marks: data.marks,
    stages: data.stages,
    tendons: data.tendonParts.length,
    readings: data.readings,
    /** Single numbers beside the time: their names and units, and the key of their values. */
    along,
    creases,
    time,
    start: time[0],
    end: time[time.length - 1],
    efforts,
    strained: data.built !== null,
    stressed: Boolean(data.membraneLaw),
    builtVertices: () => verticesOf(unpack(data.built, Float32Array), new Float32Array(3 * share.length)),
    restLengthsAt,
    pointsAt,
    verticesAt,
    verticesOf,
    valuesAt,
    line,
    stageAt: (moment) => data.stages.findLast((stage) => stage.start <= moment) ?? data.stages[0],
    markAt: (moment) => data.marks.find((mark) => Math.abs(mark.time - moment) < 1e-9),
  };
}

/** Write the row of a table at a time, interpolated between two rows. */
function mix(time, rows, width, moment, into) {
  const [frame, part] = placeIn(time, moment);
  const here = frame * width;
  const next = Math.min(frame + 1, time.length - 1) * width;
  for (let column = 0; column < width; column++) {
    const from = rows[here + column];
    into[column] = part === 0 ? from : from + part * (rows[next + column] - from);
  }
}

/** The last frame that is not after a time, and the position between it and the next, 0 to 1. */
export function placeIn(time, moment) {
  if (!(moment > time[0])) return [0, 0];
  const last = time.length - 1;
  if (moment >= time[last]) return [last, 0];
  let low = 0;
  let high = last;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (time[middle] <= moment) low = middle;
    else high = middle;
  }
  return [low, (moment - time[low]) / (time[low + 1] - time[low])];
}

/** The value of a line at a time, interpolated between frames. */
export function valueAt(time, values, moment) {
  const [frame, share] = placeIn(time, moment);
  return share === 0 ? values[frame] : values[frame] + share * (values[frame + 1] - values[frame]);
}
