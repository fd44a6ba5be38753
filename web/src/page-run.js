/** Page of one run, and of a landscape with a run: curves with the run's position. */

import { readClip } from "./clip.js";
import { makeClock } from "./clock.js";
import { mountCurves } from "./curves.js";
import { mountPlayer } from "./player.js";
import { mountPlots } from "./plots.js";
import { mountReadout } from "./readout.js";
import { playOnceSeen } from "./start.js";
import { mountTryIt } from "./try-it.js";

export function showRun(data) {
  const clips = data.clips.map(readClip);
  const clock = makeClock(clips, data.spans);
  const player = mountPlayer(document.getElementById("player"), clips, clock, data);
  const curves = data.curves ? mountCurves(document.getElementById("curves"), data.curves, clips, clock) : [];
  const plots = mountPlots(document.getElementById("plots"), data.plots, clips, clock);
  mountReadout(document.getElementById("readout"), clips[0], clock, data.energy);
  playOnceSeen(document.getElementById("player"), clock);
  const trial = mountTryIt(document.getElementById("try"), clips[0], data, () => clock.pause());
  return { clips, clock, player, curves, plots, trial };
}
