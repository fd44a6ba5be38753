/** Page of several runs side by side. */

import { TENDONS, readClip } from "./clip.js";
import { makeClock } from "./clock.js";
import { lineSample, make } from "./elements.js";
import { fixed, short } from "./format.js";
import { mountPlayer } from "./player.js";
import { mountPlots } from "./plots.js";
import { lineLook, onSchemeChange } from "./scheme.js";
import { playOnceSeen } from "./start.js";

export function showComparison(data) {
  const clips = data.clips.map(readClip);
  const clock = makeClock(clips, data.spans);
  const player = mountPlayer(document.getElementById("player"), clips, clock, data);
  nameCells(player.stage.cells, clips, clock, data.energy);
  const plots = mountPlots(document.getElementById("plots"), data.plots, clips, clock);
  playOnceSeen(document.getElementById("player"), clock);
  return { clips, clock, player, plots };
}

/** Write on every structure its name, the look of its lines in the plots, and its present state. */
export function nameCells(cells, clips, clock, energy) {
  const states = clips.map((clip, index) => {
    const state = make("span", { className: "state-now" });
    const name = make("b", {}, lineSample(lineLook(index)), clip.name);
    onSchemeChange(() => name.replaceChild(lineSample(lineLook(index)), name.firstChild));
    cells[index].append(name, state);
    return state;
  });
  clock.onChange(() => {
    for (const [index, clip] of clips.entries()) {
      const moment = clock.clipTime(index);
      const over = clock.time + clock.span.origins[index] > clip.end;
      const parts = [over ? "ended" : clip.stageAt(moment).name];
      const [reading] = clip.readings;
      if (reading) parts.push(rangeText(clip.valuesAt(reading.name, moment), reading.unit));
      const stored = clip.valuesAt(TENDONS, moment).reduce((sum, value) => sum + value, 0);
      if (clip.tendons) parts.push(`${short(energy.factor * stored)} ${energy.unit}`);
      states[index].textContent = parts.join(" \u00b7 ");
    }
  });
}

/** Range of some values, with few digits. */
function rangeText(values, unit) {
  const text = (value) => (unit === "deg" ? `${fixed(value, 0)}\u00b0` : `${short(value)} ${unit}`);
  const ends = [Math.min(...values), Math.max(...values)].map(text);
  return ends[0] === ends[1] ? ends[0] : ends.join(" to ");
}
