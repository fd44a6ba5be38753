/** The structure of a workbench, simulated live; at its start, with the reason, if the page cannot simulate it. */

import { firstLook } from "./camera.js";
import { readClip } from "./clip.js";
import { make } from "./elements.js";
import { startEngine } from "./engine.js";
import { mountStill } from "./player.js";
import { makePoseClock } from "./pose-clock.js";
import { makePanel } from "./try-panel.js";

/** set: receives the key and the text of a value that was changed during the simulation; run: requests a run. */
export function makeWing(set, run) {
  const element = make("div");
  const wing = { element, panel: null, refused: "", engine: null };
  let still = null;
  let look;
  let pace;

  function clear() {
    wing.panel?.leave();
    still?.dispose();
    wing.panel = still = null;
  }

  /** Display a model in place of another; the view is kept. */
  wing.show = async ({ bench, live, warnings }) => {
    const clip = readClip(bench.clips[0]);
    wing.refused = live.refused ?? "";
    pace = wing.panel?.pace ?? pace;
    if (!wing.refused) {
      try {
        const panel = await makePanel(clip, bench, JSON.stringify(live), take, { look, pace, set });
        clear();
        element.replaceChildren(panel.element, ...toKnow(warnings));
        panel.begin();
        wing.panel = panel;
        look = panel.stage?.eye.look;
        return;
      } catch (error) {
        wing.engine?.end();
        wing.engine = null;
        wing.refused = error.message;
      }
    }
    clear();
    showStill(clip, bench, warnings);
  };

  /** Start the engine once; it takes one structure after another. */
  async function take(text, hear) {
    if (wing.engine) return wing.engine.take(text, hear);
    wing.engine = await startEngine(text, hear);
    return wing.engine;
  }

  function showStill(clip, bench, warnings) {
    const why = make("p", { className: "note" }, `The picture shows the start. A page cannot simulate this ${bench.whole}: ${wing.refused}. The package can:`);
    const button = make("button", { type: "button" }, "Run it");
    button.addEventListener("click", run);
    const picture = make("div");
    element.replaceChildren(make("div", { className: "offer" }, why, button), picture, ...toKnow(warnings));
    const begun = look ?? { ...firstLook(), following: false };
    const { stage } = mountStill(picture, [clip], makePoseClock(clip), { ...bench, text: `${bench.shape}, at its start.` }, begun);
    picture.setAttribute("aria-label", `the ${bench.whole} at its start`);
    still = stage;
    look = stage?.eye.look ?? look;
  }

  return wing;
}

function toKnow(warnings) {
  if (!warnings.length) return [];
  const sentence = (text) => `${text.replace(/^[a-z](?=\S* )/, (letter) => letter.toUpperCase()).replace(/\.$/, "")}.`;
  return [make("h2", {}, "What to know"), make("ul", { className: "warnings" }, ...warnings.map((each) => make("li", {}, sentence(each))))];
}
