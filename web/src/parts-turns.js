/** Positions of bodies from hinge angles: each body turns against its parent about a line of the built shape. */

import { Matrix4, Vector3 } from "three";

/**
 * bodies: the parent of each, parents first; turns: {body, origin, axis, built}, those of one body in the order in which
 * each turns the axes of the next. The returned function writes the matrices of all bodies, from built to turned.
 */
export function makeTurns(bodies, turns) {
  const lines = turns.map(({ origin, axis }) => [new Vector3(...origin), new Vector3(...axis)]);
  const of = bodies.map((_, body) => turns.flatMap((turn, index) => (turn.body === body ? [index] : [])));
  const matrices = bodies.map(() => new Matrix4());
  const turned = new Matrix4();
  const moved = new Vector3();

  return function pose(angles) {
    for (const [body, parent] of bodies.entries()) {
      const matrix = matrices[body];
      if (parent < 0) matrix.identity();
      else matrix.copy(matrices[parent]);
      for (const index of of[body]) {
        const [origin, axis] = lines[index];
        turned.makeRotationAxis(axis, angles[index] - turns[index].built);
        // points on the line stay in place
        moved.copy(origin).applyMatrix4(turned);
        turned.setPosition(origin.x - moved.x, origin.y - moved.y, origin.z - moved.z);
        matrix.multiply(turned);
      }
    }
    return matrices;
  };
}
