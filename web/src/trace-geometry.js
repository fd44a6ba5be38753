/** Geometry of a picture's plane: points in pixels, and the homography that maps them to the sheet. */

export const distance = (one, other) => Math.hypot(other[0] - one[0], other[1] - one[1]);

/** Map a point by a homography, a matrix of three rows; without a matrix the y axis only turns upwards. */
export function onSheet(matrix, [x, y]) {
  if (!matrix) return [x, -y];
  const [u, v, w] = matrix.map(([a, b, c]) => a * x + b * y + c);
  return [u / w, v / w];
}

/** The inverse of a matrix of three rows. */
export function inverse([[a, b, c], [d, e, f], [g, h, i]]) {
  const determinant = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g);
  return [
    [e * i - f * h, c * h - b * i, b * f - c * e],
    [f * g - d * i, a * i - c * g, c * d - a * f],
    [d * h - e * g, b * g - a * h, a * e - b * d],
  ].map((row) => row.map((value) => value / determinant));
}

/** The position of the nearest point on a line from one point to another, as a share, and its distance. */
export function nearestOn(start, end, point) {
  const along = [end[0] - start[0], end[1] - start[1]];
  const square = along[0] ** 2 + along[1] ** 2;
  const share = square ? ((point[0] - start[0]) * along[0] + (point[1] - start[1]) * along[1]) / square : 0;
  const near = between(start, end, Math.min(Math.max(share, 0), 1));
  return { share, near, distance: distance(near, point) };
}

export const between = (start, end, share) => [start[0] + share * (end[0] - start[0]), start[1] + share * (end[1] - start[1])];

/** The shares at which two lines cross, or null if they are parallel or do not reach each other. */
export function crossing([a, b], [c, d]) {
  const [one, other] = [[b[0] - a[0], b[1] - a[1]], [d[0] - c[0], d[1] - c[1]]];
  const sine = one[0] * other[1] - one[1] * other[0];
  if (Math.abs(sine) < 1e-9 * Math.hypot(...one) * Math.hypot(...other)) return null;
  const offset = [c[0] - a[0], c[1] - a[1]];
  const first = (offset[0] * other[1] - offset[1] * other[0]) / sine;
  const second = (offset[0] * one[1] - offset[1] * one[0]) / sine;
  return first > 0 && first < 1 && second > 0 && second < 1 ? [first, second] : null;
}

/** Four points clockwise in the picture, whose y axis points downwards, from the upper left one. */
export function clockwise(points) {
  const middle = [0, 1].map((axis) => points.reduce((sum, point) => sum + point[axis], 0) / points.length);
  const turn = ([x, y]) => Math.atan2(y - middle[1], x - middle[0]);
  const sorted = [...points].sort((one, other) => turn(one) - turn(other));
  const sums = sorted.map(([x, y]) => x + y);
  const first = sums.indexOf(Math.min(...sums));
  return [...sorted.slice(first), ...sorted.slice(0, first)];
}

/** A map of points of the picture that is a map of the sheet. */
export function imageOnSheet(matrix, map) {
  const back = matrix ? inverse(matrix) : [[1, 0, 0], [0, -1, 0], [0, 0, 1]];
  return (point) => onSheet(back, map(onSheet(matrix, point)));
}

/** The reflection at the line through two points. */
export function mirror([x, y], [u, v]) {
  const square = (u - x) ** 2 + (v - y) ** 2;
  const [c, s] = [((u - x) ** 2 - (v - y) ** 2) / square, (2 * (u - x) * (v - y)) / square];
  return (point) => [x + c * (point[0] - x) + s * (point[1] - y), y + s * (point[0] - x) - c * (point[1] - y)];
}

/** The rotation about a point by an angle, rad. */
export function rotation([x, y], angle) {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return (point) => [x + c * (point[0] - x) - s * (point[1] - y), y + s * (point[0] - x) + c * (point[1] - y)];
}
