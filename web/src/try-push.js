/** Pushing a structure with the pointer: a grabbed point is pulled by a spring between it and the pointer. */

import { short } from "./format.js";
import { listenToGrabs } from "./grab.js";

const REACH = 0.25; // distance of the largest force, as a share of the structure's size

/** Let a reader push the points of a stage's only structure; `push` receives the point and the force, N, or null. */
export function listenToPushes(stage, live, span, strongest, push) {
  const { say } = listenToGrabs(stage, {
    points: () => live.frame.points,
    movable: live.movable,
    moved([[point]], position, target) {
      const pull = target.sub(position).multiplyScalar(strongest / (REACH * span)).clampLength(0, strongest);
      push(point, pull.toArray());
      say(`pushed with ${short(pull.length())} N`);
    },
    left: () => push(0, null),
  });
}
