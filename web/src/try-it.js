/** "Try it": the structure of a run's page, live, once a button is pressed; until then the page is as it was. */

import { make } from "./elements.js";
import { hasEngine, startEngine } from "./engine.js";
import { makePanel } from "./try-panel.js";

/** Put the offer into an element, where the page has one; `before` is done when it is taken. */
export function mountTryIt(element, clip, data, before) {
  if (!element) return null;
  const trial = { panel: null, failed: "", start: null };
  const text = document.getElementById("live").textContent;
  const button = make("button", { type: "button", className: "try" }, "Try it");
  const said = make("p", { className: "note" });
  said.textContent = `Move this ${data.whole} yourself: change it, drive it, let go, push it; the simulator runs in this page.`;
  element.append(make("div", { className: "offer" }, button, said));

  function refuse(why) {
    trial.failed = why;
    button.disabled = true;
    said.textContent = `This ${data.whole} cannot be moved here: ${why}. The command line can: forficula run.`;
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
  button.addEventListener("click", trial.start);
  return trial;
}
