/** A grid under the structure; the size of its squares is stated. */

import { BufferGeometry, Float32BufferAttribute, LineBasicMaterial, LineSegments } from "three";

const SQUARES = 2.4; // approximate number of squares across half of it

/** The side of a square: 1, 2 or 5 times a power of ten, m. */
export function squareSide(size) {
  const power = 10 ** Math.floor(Math.log10(size / SQUARES));
  return power * [5, 2, 1].find((step) => step * power <= size / SQUARES);
}

export function makeFloor(size, target) {
  const side = squareSide(size);
  const half = side * Math.ceil((1.25 * size) / side);
  const lines = [];
  const [x, y] = [target.x, target.y].map((value) => side * Math.round(value / side));
  for (let at = -half; at <= half + side / 2; at += side) {
    lines.push(x + at, y - half, 0, x + at, y + half, 0, x - half, y + at, 0, x + half, y + at, 0);
  }
  const geometry = new BufferGeometry().setAttribute("position", new Float32BufferAttribute(lines, 3));
  const grid = new LineSegments(
    geometry,
    new LineBasicMaterial({ transparent: true, opacity: 0.5, depthWrite: false }),
  );
  grid.frustumCulled = false;
  return grid;
}
