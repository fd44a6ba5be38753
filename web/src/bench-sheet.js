/** The crease pattern of a workbench's design, drawn by the package. */

import { ask } from "./bench-ask.js";
import { asAddress } from "./bench-file.js";
import { make } from "./elements.js";

/** asked: returns the present request. */
export function makeSheet(asked) {
  const element = make("div");
  let drawn = null;

  /** Draw the pattern, unless it is displayed already. */
  async function seen() {
    const wanted = asked();
    if (!wanted) return;
    const key = JSON.stringify(wanted);
    if (key === drawn) return;
    drawn = key;
    if (!element.querySelector("img")) element.replaceChildren(make("p", { className: "note", role: "status" }, "Drawing \u2026"));
    const reply = await ask("pattern", wanted);
    if (drawn !== key) return;
    if (reply.refused) {
      element.replaceChildren(make("p", { className: "note", role: "status" }, `No pattern is drawn: ${reply.refused}.`));
      return;
    }
    const image = make("img", { src: `data:image/svg+xml;base64,${reply.drawing}`, alt: reply.said });
    const link = (text, name, href) => make("a", { className: "button", download: name, href }, text);
    const fold = asAddress(reply.fold, "application/json");
    element.replaceChildren(
      make("figure", { className: "drawn" }, image),
      make("p", { className: "choices" }, link("Drawing as SVG", "pattern.svg", image.src), link("Pattern as FOLD", "pattern.fold", fold)),
    );
  }

  return { element, seen };
}
