/** "Try it": the structure of a run's page, simulated live, once a button is pressed. */

import { make } from "./elements.js";
import { hasEngine, startEngine } from "./engine.js";
import { makePanel } from "./try-panel.js";

/**
 * Add the offer to an element, if the page has one; `before` is called when it is accepted. `fold` shows the fold path of
 * the page, if it has one; it is offered for a structure that the page cannot simulate.
 */
export function mountTryIt(element, clip, data, before, fold = null) {
  if (!element) return null;
  const trial = { panel: null, failed: "", start: null };
  const text = document.getElementById("live").textContent;
  const button = make("button", { type: "button", className: "try" }, "Try it");
  const said = make("p", { className: "note" });
  said.textContent = `Move this ${data.whole} yourself: change values, switch drives, release it, push it. The simulator runs in this page.`;
  element.append(make("div", { className: "offer" }, button, said));

  function refuse(why) {
    trial.failed = why;
    button.disabled = true;
    const drag = `To drag its vertices, open the design in the workbench, with the command forficula open.`;
    const reason = `A page cannot simulate the motion in time of this ${data.whole}: ${why}.`;
    said.textContent = `${fold ? `A slider folds this ${data.whole} along its quasi-static path. ` : ""}${drag} ${reason}`;
    if (!fold) return;
    const slow = make("button", { type: "button", className: "try" }, "Fold it slowly");
    slow.addEventListener("click", fold);
    button.replaceWith(slow);
  }

  const live = JSON.parse(text.startsWith('{"refused"') ? text : "null");
  if (live !== null) refuse(live.refused);
  else if (!hasEngine()) refuse("this page was written without the engine");
  trial.start = async () => {
    if (button.disabled) return;
    button.disabled = true;
    said.setAttribute("role", "status");
    said.textContent = "Starting the simulator \u2026";
    before();
    try {
      trial.panel = await makePanel(clip, data, text, startEngine);
      element.replaceChildren(make("h2", {}, "Try it"), trial.panel.element);
      trial.panel.begin();
    } catch (error) {
      refuse(error.message);
    }
  };
  button.addEventListener("click", async () => {
    await trial.start();
    if (!trial.failed) element.scrollIntoView({ block: "start" });
  });
  return trial;
}
