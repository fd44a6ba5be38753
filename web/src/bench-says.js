/** Messages of a workbench, and the download of its design. */

import { asAddress } from "./bench-file.js";
import { make } from "./elements.js";

const PATIENCE = 1500; // ms after which building can be stopped

/** Messages about work in progress and about refusals. */
export function makeSays() {
  const said = make("p", { role: "status" });
  const wrong = make("p", { className: "wrong", role: "alert" });
  const stop = make("button", { type: "button", hidden: true }, "Stop building");
  let waiting = 0;
  let end = null;
  stop.addEventListener("click", () => end?.());

  function show(text, refused = "") {
    clearTimeout(waiting);
    stop.hidden = true;
    said.textContent = text;
    wrong.textContent = refused;
  }

  return {
    element: make("div", { className: "says" }, said, stop, wrong),
    wait(text, ending) {
      show(`${text} \u2026`);
      end = ending;
      if (ending) waiting = setTimeout(() => (stop.hidden = false), PATIENCE);
    },
    done: (text) => show(text),
    refuse: (why) => show("", why.endsWith(".") ? why : `${why}.`),
  };
}

/** The design to download, and the command that runs it. */
export function makeTaking() {
  const link = make("a", { className: "button" }, "Download the design");
  const command = make("code");
  const line = make("pre", { tabIndex: 0, role: "group", "aria-label": "the command that runs it" }, command);
  return {
    element: make("div", { className: "taking" }, link, line),
    show(reply) {
      link.href = asAddress(reply.text, "application/toml");
      link.download = `${reply.name}.toml`;
      command.textContent = reply.command;
    },
  };
}
