/** Page of a design whose structure a reader moves: the simulation starts when the page opens. */

import { readClip } from "./clip.js";
import { mountTryIt } from "./try-it.js";

export function showBench(data) {
  const clip = readClip(data.clips[0]);
  const trial = mountTryIt(document.getElementById("try"), clip, data, () => {});
  trial.start();
  return { clips: [clip], trial };
}
