/** Results that the package computes for a workbench: requested, awaited or stopped, and displayed as their page. */

import { follow } from "./bench-ask.js";
import { make } from "./elements.js";

/** what: "landscape" or "run"; text: a sentence about the result; asked: returns the present request. */
export function makeResults(what, { button: words, text, title }, asked) {
  const start = make("button", { type: "button", className: "try" }, words);
  const stop = make("button", { type: "button", hidden: true }, "Stop");
  const said = make("p", { className: "note", role: "status" }, text);
  const place = make("div");
  const element = make("div", { className: "results" }, make("div", { className: "offer" }, start, stop, said), place);
  let shown = null;
  let doing = null;

  async function find() {
    if (doing) return;
    const wanted = asked();
    const began = performance.now();
    doing = new AbortController();
    start.disabled = true;
    stop.hidden = false;
    said.textContent = "Starting \u2026";
    let found = false;
    try {
      const reply = await follow(what, wanted, doing.signal, (line) => {
        if (line.doing) said.textContent = `${line.doing} \u2026`;
      });
      if (reply.refused) said.textContent = `No result: ${reply.refused}.`;
      else show(reply.done, wanted, (performance.now() - began) / 1000);
      found = !reply.refused;
    } catch {
      said.textContent = "Stopped.";
    }
    doing = null;
    start.disabled = false;
    stop.hidden = true;
    if (found) changed();
  }

  function show(address, wanted, seconds) {
    shown = JSON.stringify(wanted);
    said.textContent = `Done in ${seconds.toFixed(seconds < 10 ? 1 : 0)} s.`;
    const alone = make("a", { href: address, target: "_blank", rel: "noopener" }, "Open in a new window");
    const frame = make("iframe", { src: address, title, sandbox: "allow-scripts allow-downloads" });
    place.replaceChildren(make("p", {}, alone), frame);
  }

  /** Display a note if the design has changed since. */
  function changed() {
    if (shown !== null && !doing && shown !== JSON.stringify(asked())) said.textContent = "This result belongs to the design before its last change.";
  }

  start.addEventListener("click", find);
  stop.addEventListener("click", () => doing?.abort());
  return { element, find, seen: changed };
}
