/** Parts of the page: meshes, and their positions at hinge angles, assembled or taken apart. */

import { Matrix4, Vector3 } from "three";
import { placeIn } from "./clip.js";
import { rodLine, rodMesh, strapLines, strapMesh, strapStretches } from "./parts-bends.js";
import { makeTurns } from "./parts-turns.js";

// directions whose outermost points determine a view
const WAYS = [-1, 0, 1].flatMap((x) => [-1, 0, 1].flatMap((y) => [-1, 0, 1].map((z) => [x, y, z])));
const STILL = new Matrix4();

export function readModel(data, take) {
  const parts = data.parts.map((part) => ({ ...part, ...(part.mesh ? readMesh(part.mesh, take) : {}) }));
  const bows = { values: take(data.bows), shape: data.bows.shape };
  const turn = makeTurns(data.bodies, data.turns);
  const lowest = Math.min(...data.joints.map((joint) => joint.lower));
  const highest = Math.max(...data.joints.map((joint) => joint.upper));
  const angles = new Float64Array(data.turns.length);
  const fold = data.fold && take(data.fold);

  /** Angles of all hinges if all joints have one angle, rad, limited by their stops. */
  function anglesTogether(angle) {
    if (fold) return anglesAlong(angle);
    for (const [index, each] of data.turns.entries()) angles[index] = each.built;
    for (const joint of data.joints) angles[joint.turn] = Math.min(joint.upper, Math.max(joint.lower, angle));
    return angles;
  }

  /** Angles of all hinges of thick panels at a largest fold angle, rad. */
  function anglesAlong(angle) {
    const [count, width] = data.fold.shape;
    const place = highest > 0 ? (angle / highest) * (count - 1) : 0;
    const frame = Math.min(Math.floor(place), Math.max(count - 2, 0));
    const next = Math.min(frame + 1, count - 1);
    for (let hinge = 0; hinge < width; hinge++) {
      const from = fold[frame * width + hinge];
      angles[hinge] = from + (place - frame) * (fold[next * width + hinge] - from);
    }
    return angles;
  }

  const shiftOf = (part, apart) => new Vector3(...part.apart).multiplyScalar(apart);

  /** Matrix from a part's built position to its present position. */
  function matrixOf(part, poses, apart, into = new Matrix4()) {
    const shift = shiftOf(part, apart);
    return into
      .copy(part.body === null || part.body < 0 ? STILL : poses[part.body])
      .multiply(new Matrix4().makeTranslation(shift.x, shift.y, shift.z));
  }

  /** Triangles and edges of a part that bends. */
  function bentMesh(part, poses, { apart, side }) {
    const shift = shiftOf(part, apart);
    if (part.root) return rodMesh(rodLine(part.root, poses, shift), part.root.diameter);
    return strapMesh(part.strap, strapLines(part.strap, poses, side, shift, bows), poses);
  }

  /** Points that determine a view of some parts, (place, 3). */
  function outline(chosen, poses, { apart, side }) {
    const found = [];
    for (const part of chosen) {
      if (part.outer) {
        const matrix = matrixOf(part, poses, apart);
        for (const place of part.outer) found.push(...place.clone().applyMatrix4(matrix).toArray());
        continue;
      }
      const shift = shiftOf(part, apart);
      const lines = part.root
        ? [rodLine(part.root, poses, shift)]
        : strapLines(part.strap, poses, side, shift, bows).map((line) => line.points);
      for (const points of lines)
        for (let at = 0; at < points.length; at += 4) found.push(...points[at].toArray());
    }
    return Float64Array.from(found);
  }

  return {
    parts,
    looks: data.looks,
    joints: data.joints,
    folds: Boolean(fold),
    turns: data.turns,
    lowest,
    highest,
    turn,
    anglesTogether,
    matrixOf,
    bentMesh,
    outline,
    straps: parts.filter((part) => part.strap).map((part) => part.strap),
    strapStretches,
  };
}

function readMesh({ points, triangles, stops, edges }, take) {
  const places = take(points);
  const corners = take(triangles);
  const count = points.shape[0];
  for (let at = 0; at < corners.length; at += 3) {
    corners[at + 1] = (corners[at] + corners[at + 1]) % count;
    corners[at + 2] = (corners[at] + corners[at + 2]) % count;
  }
  return { places, corners, stops, edges: take(edges), outer: outermost(places) };
}

function outermost(places) {
  const found = new Set();
  for (const [x, y, z] of WAYS) {
    let [best, most] = [0, -Infinity];
    for (let at = 0; at < places.length; at += 3) {
      const reach = x * places[at] + y * places[at + 1] + z * places[at + 2];
      if (reach > most) [best, most] = [at, reach];
    }
    found.add(best);
  }
  return Array.from(found, (at) => new Vector3().fromArray(places, at));
}

/** Angles of all hinges over a recorded run, at a time. */
export function readMotion(motion, take) {
  const time = take(motion.time);
  const values = take(motion.angles);
  const [, width] = motion.angles.shape;
  const now = new Float64Array(width);

  function anglesAt(moment) {
    const [frame, part] = placeIn(time, moment);
    const next = Math.min(frame + 1, time.length - 1);
    for (let hinge = 0; hinge < width; hinge++) {
      const from = values[frame * width + hinge];
      now[hinge] = from + part * (values[next * width + hinge] - from);
    }
    return now;
  }

  return { time, anglesAt, marks: motion.marks, stages: motion.stages, spans: motion.spans };
}
