/** Choice of a sheet's colours: its regions, or strain or stress with the scale in the legend. */

import { make } from "./elements.js";
import { readable, short } from "./format.js";
import { scaleEntry } from "./legend.js";
import { STRAIN_COLOURS } from "./scheme.js";

const CHOICES = [
  { quantity: null, name: "panels" },
  { quantity: "strain", name: "strain", text: "largest Green strain of the membrane", value: (largest) => `${short(100 * largest)} %` },
  {
    quantity: "stress",
    name: "stress",
    text: "largest stress of the membrane (second Piola-Kirchhoff)",
    value: (largest, unit) => readable(largest, unit),
  },
];

/** Buttons for a stage whose clips have a sheet that stretches, and the scale in the legend. */
export function makeSheetColours(stage, legend, clips) {
  const scale = make("li", { className: "energy", hidden: true });
  legend.append(scale);
  const unit = clips.find((clip) => clip.stressed)?.mesh.membraneLaw.unit;
  const known = CHOICES.filter(({ quantity }) => quantity !== "stress" || clips.every((clip) => clip.stressed || !clip.strained));
  const buttons = known.map(({ quantity, name, text, value }, index) => {
    const button = make("button", { type: "button", "aria-pressed": String(index === 0) }, name);
    button.addEventListener("click", () => {
      const largest = stage.colourSheets(quantity);
      if (quantity) scale.replaceChildren(...scaleEntry(text, "0", STRAIN_COLOURS, value(largest, unit)).childNodes);
      scale.hidden = !quantity;
      for (const entry of legend.querySelectorAll(".of-region")) entry.hidden = Boolean(quantity);
      for (const each of buttons) each.setAttribute("aria-pressed", String(each === button));
    });
    return button;
  });
  return make("div", { className: "colours", role: "group", "aria-label": "colour of the sheet" }, "colour:", make("span", {}, ...buttons));
}
