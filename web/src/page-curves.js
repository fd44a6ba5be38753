/** Page of curves without a run: a slider moves a ball on each, and the structure into its pose. */

import { readClip } from "./clip.js";
import { mountCurves } from "./curves.js";
import { mountStill } from "./player.js";
import { makePoseClock } from "./pose-clock.js";

export function showCurves(data) {
  const place = document.getElementById("curves");
  if (!data.clips) return { curves: mountCurves(place, data.curves) };
  const clips = data.clips.map(readClip);
  const clock = makePoseClock(clips[0]);
  const player = mountStill(document.getElementById("player"), clips, clock, data);
  return { clips, clock, player, curves: mountCurves(place, data.curves, [], null, clock) };
}
