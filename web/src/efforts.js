/** Actions of drives: their strengths at a time, and arrows about an axis or along a direction. */

import { Color, ConeGeometry, CylinderGeometry, Group, InstancedMesh } from "three";
import { placeIn, unpack } from "./clip.js";
import { barMaterial, placeTube } from "./bars.js";
import { styleColour } from "./scheme.js";

const WHOLE = 32767; // integer that stands for a component of 1
const PIECES = 24; // pieces of an arc
const MOST_TURNED = (5 / 3) * Math.PI; // length of the arc of a run's largest moment
const LONGEST = 0.22; // length of the arrow of the largest force, as a share of the structure's span
const THICKNESS = 0.11; // thickness of an arrow, as a share of the radius of its arc
const HEAD = 0.7; // length of its head, in the same unit
const THICK_HEAD = 3; // thickness of its head, as a multiple of the arrow's
const LEAST = 1e-6; // share of the largest effort below which no arrow is drawn

/** Arrays of a clip's drives, read on first use. */
export function readEfforts(data) {
  const turns = data.turns.map((turn) => ({
    ...turn,
    pivot: unpack(turn.pivot, Float32Array),
    axis: Float32Array.from(unpack(turn.axis, Int16Array), (part) => part / WHOLE),
    left: turn.left && unpack(turn.left, Float32Array),
  }));
  const pushes = data.pushes.map((push) => ({ ...push, force: push.force && unpack(push.force, Float32Array) }));
  const { drives, stages } = data;

  /** Strength of every drive at a time, in its SI unit: 0 if no stage uses it. */
  function strengthsAt(moment) {
    // a drive acts until the last moment of its stage
    const stage = stages.find(({ start, end }) => moment > start && moment <= end);
    return drives.map(({ strength, rise }, drive) => {
      if (!stage?.drives.includes(drive)) return 0;
      return strength * (rise > 0 ? Math.min(1, (moment - stage.start) / rise) : 1);
    });
  }

  const summed = (shares, strengths) => shares.reduce((sum, share, drive) => sum + share * strengths[drive], 0);
  const largest = (parts) =>
    parts.reduce((most, { shares }) => {
      const each = stages.map((stage) => Math.abs(summed(shares, drives.map(({ strength }, drive) => (stage.drives.includes(drive) ? strength : 0)))));
      return Math.max(most, ...each);
    }, 0);
  return { ...data, time: unpack(data.time, Float64Array), turns, pushes, strengthsAt, summed, largestTurn: largest(turns), largestPush: largest(pushes) };
}

/** A text for every drive that acts at a time. */
export function effortTexts({ drives, strengthsAt }, moment, number) {
  const strengths = strengthsAt(moment);
  return drives.flatMap(({ text, unit, factor }, drive) =>
    strengths[drive] ? [`${text}: ${number(factor * strengths[drive])} ${unit}`] : [],
  );
}

/** Arrows of a clip's torques and forces; `pose` positions them with lengths that are proportional to the efforts. */
export function makeEfforts(clip) {
  const { time, turns, pushes, strengthsAt, summed, largestTurn, largestPush } = clip.efforts;
  const radius = Math.max(0, ...turns.map((turn) => turn.radius));
  const straight = 0.05 * clip.mesh.span_m; // radius that sets thickness and head of a straight arrow
  const material = barMaterial(Math.max(radius, straight));
  const rods = new InstancedMesh(new CylinderGeometry(1, 1, 1, 10), material, turns.length * PIECES + pushes.length);
  const heads = new InstancedMesh(new ConeGeometry(1, 1, 16), material, turns.length + pushes.length);
  const group = new Group();
  for (const object of [rods, heads]) {
    object.frustumCulled = false;
    group.add(object);
  }
  const points = new Float32Array(3 * (PIECES + 2));
  let [rod, tip] = [0, 0];

  const add = (object, first, second, thickness, index) =>
    placeTube(points, 3 * first, 3 * second, thickness, object.instanceMatrix.array, 16 * index);

  function write(index, place) {
    for (let axis = 0; axis < 3; axis++) points[3 * index + axis] = place[axis];
  }

  function addTurn(turn, place, moment, strengths) {
    const [frame, share] = placeIn(time, moment);
    const left = turn.left ? rowAt(turn.left, 1, frame, share)[0] : 1;
    const part = (left * summed(turn.shares, strengths)) / largestTurn;
    if (!(Math.abs(part) > LEAST)) return;
    const [pivot, axis] = turn.ends ? alongCrease(place, turn.ends) : [turn.pivot, turn.axis].map((rows) => rowAt(rows, 3, frame, share));
    const across = square(axis, turn);
    const aside = cross(axis, across);
    const turned = MOST_TURNED * Math.min(1.2, Math.abs(part)) * Math.sign(part);
    const on = (angle) => pivot.map((each, at) => each + turn.radius * (Math.cos(angle) * across[at] + Math.sin(angle) * aside[at]));
    for (let piece = 0; piece <= PIECES; piece++) write(piece, on(turned * (piece / PIECES - 0.5)));
    // the head continues the arc
    const behind = turned / 2;
    write(PIECES + 1, on(behind + Math.sign(part) * HEAD));
    const thick = THICKNESS * turn.radius;
    for (let piece = 0; piece < PIECES; piece++) add(rods, piece, piece + 1, thick, rod++);
    add(heads, PIECES, PIECES + 1, THICK_HEAD * thick, tip++);
  }

  function addPush(push, place, moment, strengths) {
    const [frame, share] = placeIn(time, moment);
    const part = push.force ? rowAt(push.force, 1, frame, share)[0] : summed(push.shares, strengths) / largestPush;
    if (!(Math.abs(part) > LEAST)) return;
    const length = LONGEST * clip.mesh.span_m * part;
    const start = place.subarray(3 * push.point, 3 * push.point + 3);
    const at = (way) => push.direction.map((each, axis) => start[axis] + way * each);
    write(0, start);
    write(1, at(length));
    write(2, at(length + Math.sign(part) * HEAD * straight));
    add(rods, 0, 1, THICKNESS * straight, rod++);
    add(heads, 1, 2, THICK_HEAD * THICKNESS * straight, tip++);
  }

  function pose(moment) {
    [rod, tip] = [0, 0];
    const strengths = strengthsAt(moment);
    const place = clip.pointsAt(moment);
    for (const turn of turns) addTurn(turn, place, moment, strengths);
    for (const push of pushes) addPush(push, place, moment, strengths);
    [rods.count, heads.count] = [rod, tip];
    for (const object of [rods, heads]) {
      object.visible = object.count > 0;
      object.instanceMatrix.needsUpdate = true;
    }
  }

  const paint = () => material.color.set(new Color(styleColour("--effort")));

  function dispose() {
    for (const object of [rods, heads]) {
      object.dispose();
      object.geometry.dispose();
    }
  }

  /** Number of arrows drawn now. */
  const count = () => tip;

  return { group, pose, paint, count, dispose };
}

/** A row of a table, interpolated between two rows; the only row of a constant table. */
function rowAt(rows, width, frame, share) {
  if (rows.length === width) return Array.from(rows);
  const next = Math.min(frame + 1, rows.length / width - 1);
  return Array.from({ length: width }, (_, part) => {
    const from = rows[frame * width + part];
    return from + share * (rows[next * width + part] - from);
  });
}

function alongCrease(place, [tail, head]) {
  const [from, to] = [tail, head].map((end) => Array.from(place.subarray(3 * end, 3 * end + 3)));
  const way = from.map((each, axis) => to[axis] - each);
  const length = Math.hypot(...way) || 1;
  return [from.map((each, axis) => (each + to[axis]) / 2), way.map((each) => each / length)];
}

function cross(one, other) {
  return [0, 1, 2].map((axis) => one[(axis + 1) % 3] * other[(axis + 2) % 3] - one[(axis + 2) % 3] * other[(axis + 1) % 3]);
}

/** A unit vector perpendicular to an axis, the same for all moments: from the coordinate axis least along it at first. */
function square(axis, turn) {
  turn.side ??= axis.map(Math.abs).reduce((least, each, at, all) => (each < all[least] - 1e-3 ? at : least), 2);
  const along = axis[turn.side];
  const across = axis.map((each, at) => (at === turn.side ? 1 : 0) - along * each);
  const length = Math.hypot(...across) || 1;
  return across.map((each) => each / length);
}
