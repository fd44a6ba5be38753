/** Parts that bend: straps, taut or bowed between their pegs, and rods between a hub and a bar. */

import { Matrix4, Vector3 } from "three";

const ROUND = 28; // corners around an eye or a rod
const STEPS = 24; // along a rod

/** Extension of each strap of a tendon beyond its rest length, m; straps at oblique hinges differ. */
export function strapStretches(strap, poses) {
  return strap.ends.map((places) => {
    const [start, end] = places.map((place, index) =>
      new Vector3(...place).applyMatrix4(poseOf(poses, strap.bodies[index])),
    );
    return start.distanceTo(end) - strap.rest;
  });
}

const STILL = new Matrix4();
const poseOf = (poses, body) => (body < 0 ? STILL : poses[body]);

/**
 * Centre lines of straps: straight if taut, else bowed in planes perpendicular to the hinge, evenly along it.
 * side: +1 to bow away from the hinge, -1 towards it; shift: displacement from their positions.
 */
export function strapLines(strap, poses, side, shift, bows) {
  const wide = new Vector3(...strap.axis).transformDirection(poseOf(poses, strap.bodies[0]));
  const up = new Vector3(...strap.up).transformDirection(poseOf(poses, strap.bodies[0]));
  return strap.ends.map((places) => {
    const ends = places.map((place, index) =>
      new Vector3(...place).applyMatrix4(poseOf(poses, strap.bodies[index])).add(shift),
    );
    const chord = ends[1].clone().sub(ends[0]);
    const along = chord.dot(wide);
    chord.addScaledVector(wide, -along);
    const apart = chord.length();
    const ahead = apart > 1e-9 ? chord.divideScalar(apart) : new Vector3().crossVectors(wide, up);
    const bow = new Vector3().crossVectors(wide, ahead).multiplyScalar(side);
    const slack = strap.rest > Math.hypot(apart, along);
    const length = slack ? Math.sqrt(strap.rest ** 2 - along ** 2) : apart;
    const flat = bowAt(bows, length > 1e-9 ? apart / length : 1);
    const points = flat.map(([x, y], index) =>
      ends[0]
        .clone()
        .addScaledVector(ahead, x * length)
        .addScaledVector(bow, y * length)
        .addScaledVector(wide, (along * index) / (flat.length - 1)),
    );
    return { points, wide, ends };
  });
}

/** The elastica of length 1 with ends at a distance, interpolated between two of the page; straight beyond its length. */
function bowAt({ values, shape }, apart) {
  const [bows, points] = shape;
  const place = Math.sqrt(Math.max(0, 1 - apart)) * (bows - 1);
  const low = Math.min(bows - 2, Math.floor(place));
  const part = Math.min(1, place - low);
  const at = (bow, point, axis) => values[(bow * points + point) * 2 + axis];
  const mixed = (point, axis) => at(low, point, axis) + part * (at(low + 1, point, axis) - at(low, point, axis));
  // interpolation leaves the ends slightly displaced
  const reach = mixed(points - 1, 0);
  const stretch = reach > 1e-6 ? apart / reach : 1;
  return Array.from({ length: points }, (_, point) => [stretch * mixed(point, 0), mixed(point, 1)]);
}

/** Triangles and edges of straps with eyes around their pegs. */
export function strapMesh(strap, lines, poses) {
  const mesh = { triangles: [], edges: [] };
  for (const { points, wide, ends } of lines) {
    const across = wide.clone().multiplyScalar(strap.width / 2);
    const rails = points.map((point, index) => {
      const along = points[Math.min(index + 1, points.length - 1)].clone().sub(points[Math.max(index - 1, 0)]);
      const thick = along.cross(wide).setLength(strap.thickness / 2);
      return [
        [-1, -1],
        [1, -1],
        [1, 1],
        [-1, 1],
      ].map(([side, up]) => point.clone().addScaledVector(across, side).addScaledVector(thick, up));
    });
    addTube(mesh, rails, [0, 1, 2, 3]);
    for (const [index, end] of ends.entries()) {
      const way = new Vector3(...strap.across[index]).transformDirection(poseOf(poses, strap.bodies[index]));
      addRing(mesh, end, way, strap.width, strap.eye / 2, strap.peg / 2);
    }
  }
  return mesh;
}

/** Centre line of a rod: straight in the hub, bent to the bar that holds it, straight in the bar. */
export function rodLine(root, poses, shift) {
  const still = root.places.map((place) => new Vector3(...place).add(shift));
  const [from, free, held, to] = still;
  const pose = poseOf(poses, root.body);
  const [ends, tip] = [held, to].map((place) => place.clone().sub(shift).applyMatrix4(pose).add(shift));
  const leaving = free.clone().sub(from).normalize();
  const arriving = tip.clone().sub(ends).normalize();
  const reach = free.distanceTo(held);
  const points = [from];
  for (let step = 0; step <= STEPS; step++) points.push(between(free, leaving, ends, arriving, reach, step / STEPS));
  return [...points, tip];
}

/** Cubic between two points with given end directions (Hermite). */
function between(start, leaving, end, arriving, reach, t) {
  const [a, b] = [1 - t, t];
  return start
    .clone()
    .multiplyScalar(a * a * (1 + 2 * b))
    .addScaledVector(end, b * b * (1 + 2 * a))
    .addScaledVector(leaving, reach * a * a * b)
    .addScaledVector(arriving, -reach * b * b * a);
}

export function rodMesh(points, diameter) {
  const mesh = { triangles: [], edges: [] };
  const first = points[1].clone().sub(points[0]).normalize();
  let across = new Vector3(Math.abs(first.z) < 0.9 ? 0 : 1, 0, Math.abs(first.z) < 0.9 ? 1 : 0);
  const rails = points.map((point, index) => {
    const along = points[Math.min(index + 1, points.length - 1)].clone().sub(points[Math.max(index - 1, 0)]).normalize();
    // parallel transport, without twist
    across = across.clone().addScaledVector(along, -across.dot(along)).normalize();
    const other = new Vector3().crossVectors(along, across);
    return Array.from({ length: ROUND }, (_, corner) => {
      const turn = (2 * Math.PI * corner) / ROUND;
      return point
        .clone()
        .addScaledVector(across, (Math.cos(turn) * diameter) / 2)
        .addScaledVector(other, (Math.sin(turn) * diameter) / 2);
    });
  });
  addTube(mesh, rails, []);
  return mesh;
}

/** Sides of a tube with constant cross-section, its two ends, and the edges along some of its corners. */
function addTube({ triangles, edges }, rails, sharp) {
  const corners = rails[0].length;
  for (let index = 1; index < rails.length; index++) {
    const [before, here] = [rails[index - 1], rails[index]];
    for (let corner = 0; corner < corners; corner++) {
      const next = (corner + 1) % corners;
      triangles.push(before[corner], before[next], here[next], before[corner], here[next], here[corner]);
      if (sharp.includes(corner)) edges.push(before[corner], here[corner]);
    }
  }
  for (const end of [rails[0], rails.at(-1)])
    for (let corner = 1; corner < corners - 1; corner++) triangles.push(end[0], end[corner], end[corner + 1]);
}

/** A ring around a line, with a width along it, between two radii. */
function addRing({ triangles, edges }, middle, way, width, outer, inner) {
  const across = new Vector3(Math.abs(way.z) < 0.9 ? 0 : 1, 0, Math.abs(way.z) < 0.9 ? 1 : 0);
  across.addScaledVector(way, -across.dot(way)).normalize();
  const other = new Vector3().crossVectors(way, across);
  const corner = (turn, radius, side) =>
    middle
      .clone()
      .addScaledVector(way, (side * width) / 2)
      .addScaledVector(across, radius * Math.cos(turn))
      .addScaledVector(other, radius * Math.sin(turn));
  for (let step = 0; step < ROUND; step++) {
    const [one, two] = [step, step + 1].map((each) => (2 * Math.PI * each) / ROUND);
    const quad = (a, b, c, d) => triangles.push(a, b, c, a, c, d);
    quad(corner(one, outer, -1), corner(two, outer, -1), corner(two, outer, 1), corner(one, outer, 1));
    for (const side of [-1, 1]) {
      quad(corner(one, inner, side), corner(two, inner, side), corner(two, outer, side), corner(one, outer, side));
      edges.push(corner(one, outer, side), corner(two, outer, side));
    }
  }
}
