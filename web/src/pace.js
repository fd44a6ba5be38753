/** Speed of a clock: a share of real time, or such that motion looks even. */

import { valueAt } from "./clip.js";

// share of even playback that follows the clips' own time, so that rest is visible as rest
const BY_TIME = 0.3;
const SECONDS = 4;
const SECONDS_BY_DRIVE = 4;

export const SPEEDS = [
  { name: "even motion", value: "even" },
  { name: "real time", value: 1 },
  { name: "1/2", value: 1 / 2 },
  { name: "1/5", value: 1 / 5 },
  { name: "1/10", value: 1 / 10 },
  { name: "1/20", value: 1 / 20 },
  { name: "1/50", value: 1 / 50 },
  { name: "1/100", value: 1 / 100 },
];

/**
 * A path through a span on which the fastest point of all structures covers about equal distances per second of
 * playback. The path runs from 0 to 1 and takes a number of seconds.
 */
export function evenPace(clips, span) {
  const times = sampleTimes(clips, span);
  const way = new Float64Array(times.length);
  for (const [index, clip] of clips.entries()) addMotion(clip, span.origins[index], times, way);
  for (let index = 1; index < way.length; index++) way[index] += way[index - 1];
  const total = way[way.length - 1];
  const share = total > 0 ? BY_TIME : 1;
  for (let index = 0; index < way.length; index++) {
    const passed = (times[index] - times[0]) / (times[times.length - 1] - times[0] || 1);
    way[index] = share * passed + (1 - share) * (way[index] / (total || 1));
  }
  const inside = (stage) =>
    stage.drive !== "none" && stage.start - span.origins[0] < span.end && stage.end - span.origins[0] > span.start;
  const drives = clips[0].stages.filter(inside).length;
  return {
    seconds: span.seconds ?? SECONDS + SECONDS_BY_DRIVE * drives,
    wayAt: (moment) => valueAt(times, way, moment),
    timeAt: (part) => valueAt(way, times, part),
  };
}

function sampleTimes(clips, span) {
  const times = new Set([span.start, span.end]);
  for (const [index, clip] of clips.entries()) {
    for (const moment of clip.time) {
      const shared = moment - span.origins[index];
      if (shared > span.start && shared < span.end) times.add(shared);
    }
  }
  return Float64Array.from(times).sort();
}

/** Add the motion of a clip's fastest point up to each sample since the one before. */
function addMotion(clip, origin, times, way) {
  let before = clip.pointsAt(times[0] + origin).slice();
  let after = before.slice();
  for (let index = 1; index < times.length; index++) {
    clip.pointsAt(times[index] + origin, after);
    let furthest = 0;
    for (let at = 0; at < after.length; at += 3) {
      const step = Math.hypot(after[at] - before[at], after[at + 1] - before[at + 1], after[at + 2] - before[at + 2]);
      if (step > furthest) furthest = step;
    }
    way[index] = Math.max(way[index], furthest);
    [before, after] = [after, before];
  }
}
