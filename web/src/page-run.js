/** The page of one run. */

import { readClip } from "./clip.js";
import { makeClock } from "./clock.js";
import { mountPlayer } from "./player.js";
import { mountPlots } from "./plots.js";
import { mountReadout } from "./readout.js";
import { playOnceSeen } from "./start.js";

export function showRun(data) {
  const clips = data.clips.map(readClip);
  const clock = makeClock(clips, data.spans);
  const player = mountPlayer(document.getElementById("player"), clips, clock, data);
  const plots = mountPlots(document.getElementById("plots"), data.plots, clips, clock);
  mountReadout(document.getElementById("readout"), clips[0], clock, data.energy);
  playOnceSeen(document.getElementById("player"), clock);
  return { clips, clock, player, plots };
}
