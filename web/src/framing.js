/** Data for a view in which structures fill the picture at every moment, smoothed so that the eye moves calmly. */

import { Vector3 } from "three";

const MOMENTS = 120; // samples of a span, in equal steps of playback
const CALM = 2; // samples on either side over which a view is smoothed
const SUPPORTS = 6;

/**
 * Framing of some clips, by index, on a clock.
 *
 * A point at (x, y, z), with z towards the eye, is in the picture of an eye at (X, Y, Z) if x - X and y - Y are at most
 * the slopes of the picture's edges times Z - z. The largest x + slope z, -x + slope z and so on of all points are
 * therefore all that a view needs.
 */
export function makeFraming(clips, numbers, clock) {
  const places = new WeakMap();
  // parts beyond the points: bars and joints
  const radius = numbers.reduce(
    (most, index) => clips[index].mesh.tubes.reduce((thickest, tube) => Math.max(thickest, tube.radius), Math.max(most, clips[index].reach)),
    Math.max(...numbers.map((index) => (clips[index].mesh.joints.length ? clips[index].mesh.jointRadius : 0))),
  );
  let last = null;

  /** All points at samples of the clock's span, (moment, point, 3). */
  function sampled() {
    const { span } = clock;
    if (!places.has(span)) {
      const moments = Array.from({ length: MOMENTS + 1 }, (_, step) => clock.timeAt(step / MOMENTS));
      places.set(
        span,
        moments.map((moment) =>
          numbers.map((index) => clips[index].pointsAt(clock.clipTime(index, moment)).slice()),
        ),
      );
    }
    return places.get(span);
  }

  function prepare(axes, slopes) {
    const key = [...axes.flatMap((axis) => axis.toArray()), ...slopes].join();
    if (last?.key === key && last.span === clock.span) return last;
    const rows = sampled().map((parts) => supports(parts, axes, slopes, radius));
    last = { key, span: clock.span, rows: evened(rows), whole: largest(rows) };
    return last;
  }

  /** Point to look at, and distance: at the clock's time, or such that the whole span is in the picture. */
  return function fit(towards, up, slopes, following) {
    const right = new Vector3().crossVectors(up, towards).normalize();
    const axes = [right, new Vector3().crossVectors(towards, right), towards];
    const { rows, whole } = prepare(axes, slopes);
    const needed = following ? between(rows, clock.wayAt(clock.time) * MOMENTS) : whole;
    const [right1, left1, above, below, near, far] = needed;
    const middle = [(right1 - left1) / 2, (above - below) / 2, (near - far) / 2];
    const eye = Math.max((right1 + left1) / (2 * slopes[0]), (above + below) / (2 * slopes[1]));
    const target = new Vector3();
    for (const [index, axis] of axes.entries()) target.addScaledVector(axis, middle[index]);
    return { target, distance: eye - middle[2] || 1 };
  };
}

function supports(parts, axes, slopes, radius) {
  const found = new Float64Array(SUPPORTS).fill(-Infinity);
  const around = slopes.map((slope) => radius * Math.hypot(1, slope));
  const rounds = [around[0], around[0], around[1], around[1], 0, 0];
  const [right, upwards, towards] = axes.map((axis) => axis.toArray());
  const along = (axis, points, at) => axis[0] * points[at] + axis[1] * points[at + 1] + axis[2] * points[at + 2];
  for (const points of parts) {
    for (let at = 0; at < points.length; at += 3) {
      const [x, y, z] = [along(right, points, at), along(upwards, points, at), along(towards, points, at)];
      const [across, high] = [slopes[0] * z, slopes[1] * z];
      const each = [x + across, across - x, y + high, high - y, z, -z];
      for (let index = 0; index < SUPPORTS; index++) if (each[index] > found[index]) found[index] = each[index];
    }
  }
  return found.map((value, index) => value + rounds[index]);
}

function largest(rows) {
  return rows.reduce((most, row) => most.map((value, index) => Math.max(value, row[index])));
}

/** Smooth by means of the largest values around each sample: never less than the sample itself requires. */
function evened(rows) {
  const around = (all, index) => all.slice(Math.max(0, index - CALM), index + CALM + 1);
  const most = rows.map((_, index) => largest(around(rows, index)));
  return rows.map((_, index) => {
    const near = around(most, index);
    return near[0].map((_, part) => near.reduce((sum, row) => sum + row[part], 0) / near.length);
  });
}

function between(rows, place) {
  const index = Math.min(rows.length - 2, Math.max(0, Math.floor(place)));
  const part = Math.min(1, Math.max(0, place - index));
  return rows[index].map((value, each) => value + part * (rows[index + 1][each] - value));
}
