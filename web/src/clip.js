/**
 * A run that can be played: frames of points that move, numbers that go with them, and what is drawn between them.
 * Lengths are in m, times in s, readings in the unit that stands with them, energies in J.
 */

import { readEfforts } from "./efforts.js";

/** Name of the energies of the tendons among what a clip tells. */
export const TENDONS = "tendon energy";

/** Numbers that the page holds as little-endian bytes in base64, as every browser's machine has them. */
export function unpack(text, Kind) {
  const letters = atob(text);
  const bytes = new Uint8Array(letters.length);
  for (let index = 0; index < letters.length; index++) bytes[index] = letters.charCodeAt(index);
  return new Kind(bytes.buffer);
}

export function readClip(data) {
  const time = unpack(data.time, Float64Array);
  const points = unpack(data.points, Float32Array);
  const width = 3 * data.pointCount;
  const tables = { [TENDONS]: { width: data.tendonParts.length, values: unpack(data.tendonEnergy_J, Float32Array) } };
  for (const reading of data.readings)
    tables[reading.name] = { width: reading.parts.length, values: unpack(reading.values, Float32Array) };
  const between = Int32Array.from(data.between);
  const share = Float64Array.from(data.share);
  const now = new Float32Array(width);

  /** Write the points at a time; between two frames they are on a straight way. */
  function pointsAt(moment, into = now) {
    mix(time, points, width, moment, into);
    return into;
  }

  /** Write the vertices, which lie between the points, at a time. */
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

  /** Readings by their name, in their unit, or the energies of the tendons, J, at a time. */
  function valuesAt(name, moment, into = new Float32Array(tables[name].width)) {
    mix(time, tables[name].values, tables[name].width, moment, into);
    return into;
  }

  /** One of the same over all frames. */
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
    /** How far what is drawn about points may reach, m: rods of what is held fast, and arrows. */
    reach: Math.max(data.base.radius, efforts?.pushes.length ? 0.12 * data.span_m : 0, ...(efforts?.turns ?? []).map((turn) => 0.4 * turn.radius)),
    mesh: data,
    marks: data.marks,
    stages: data.stages,
    tendons: data.tendonParts.length,
    readings: data.readings,
    time,
    start: time[0],
    end: time[time.length - 1],
    efforts,
    strained: data.built !== null,
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

/** Write the row of a table at a time, between two rows in proportion. */
function mix(time, rows, width, moment, into) {
  const [frame, part] = placeIn(time, moment);
  const here = frame * width;
  const next = Math.min(frame + 1, time.length - 1) * width;
  for (let column = 0; column < width; column++) {
    const from = rows[here + column];
    into[column] = part === 0 ? from : from + part * (rows[next + column] - from);
  }
}

/** The last frame that is not after a time, and how far it is on the way to the next, 0 to 1. */
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
