/**
 * The structure of a workbench: simulated live, if the page's engine can do that, or moved along its fold path, which the
 * package computes.
 */

import { makeFold } from "./bench-fold.js";
import { readClip } from "./clip.js";
import { make } from "./elements.js";
import { startEngine } from "./engine.js";
import { makeModes } from "./modes.js";
import { makePanel, ROOM } from "./try-panel.js";

const MODES = [
  { name: "live", title: "simulated in time" },
  { name: "fold", title: "slowly along its path" },
];

/**
 * asked: returns the present request; set: receives the key and the text of a value that was changed during the
 * simulation; run: requests a run.
 */
export function makeWing(asked, set, run) {
  const element = make("div");
  const fold = makeFold();
  const wing = { element, fold, panel: null, whole: "structure", refused: "", engine: null };
  let mode = "live"; // what the reader chose
  let model = null; // of the present design
  let look;
  let pace;

  /** Keep the reader's view and speed; a live structure, whose motion is unknown, is seen from further away. */
  function remember() {
    const live = wing.panel?.stage?.eye.look;
    look = live ? { ...live, closer: live.closer / ROOM } : (fold.look ?? look);
    pace = wing.panel?.pace ?? pace;
  }

  function clear() {
    remember();
    wing.panel?.leave();
    wing.panel = null;
  }

  /** Request a picture; returns {shown: true}, {refused}, or {} if the structure is simulated live. */
  wing.begin = async (wanted, fresh) => {
    if (!fresh && wing.panel) return {};
    const first = await fold.show(wanted, { fresh, look, begins: clear });
    if (first.shown) {
      wing.whole = fold.whole;
      if (!element.contains(fold.element)) element.replaceChildren(fold.element);
    }
    return first;
  };

  wing.resume = () => fold.resume();

  /** Display the model of a design that is accepted; the view is kept. */
  wing.show = async (next) => {
    model = next;
    wing.whole = model.bench?.whole ?? fold.whole;
    wing.refused = model.live.refused ?? "";
    if (!wing.refused && mode === "live") await showLive();
    else await showFold();
  };

  async function showLive() {
    const { bench, live, warnings } = model;
    remember();
    try {
      const panel = await makePanel(readClip(bench.clips[0]), bench, JSON.stringify(live), take, { look: further(look), pace, set });
      clear();
      fold.clear();
      element.replaceChildren(modes(), panel.element, ...toKnow(warnings));
      panel.begin();
      wing.panel = panel;
    } catch (error) {
      wing.engine?.end();
      wing.engine = null;
      wing.refused = error.message;
      await showFold();
    }
  }

  async function showFold() {
    clear();
    element.replaceChildren(...(wing.refused ? [] : [modes()]), fold.element, ...(wing.refused ? [offer()] : []), ...toKnow(model.warnings));
    if (!fold.shows(asked())) await fold.show(asked(), { look });
  }

  /** Choice between the simulation and the fold path. */
  function modes() {
    const choice = makeModes(wing.whole, MODES, async (name) => {
      if (name === mode) return;
      mode = name;
      await (name === "live" ? showLive() : showFold());
      [...element.querySelectorAll(".modes button")].find((button) => button.textContent === mode)?.focus();
    });
    choice.mark(mode);
    return choice.element;
  }

  /** Start the engine once; it takes one structure after another. */
  async function take(text, hear) {
    if (wing.engine) return wing.engine.take(text, hear);
    wing.engine = await startEngine(text, hear);
    return wing.engine;
  }

  function offer() {
    const why = make("p", { className: "note" }, `The motion in time is not simulated in this page: ${wing.refused}. The package simulates it.`);
    const button = make("button", { type: "button" }, "Run it");
    button.addEventListener("click", run);
    return make("div", { className: "offer" }, button, why);
  }

  return wing;
}

const further = (look) => look && { ...look, following: false, closer: ROOM * look.closer };

function toKnow(warnings) {
  if (!warnings.length) return [];
  const sentence = (text) => `${text.replace(/^[a-z](?=\S* )/, (letter) => letter.toUpperCase()).replace(/\.$/, "")}.`;
  return [make("h2", {}, "What to know"), make("ul", { className: "warnings" }, ...warnings.map((each) => make("li", {}, sentence(each))))];
}
