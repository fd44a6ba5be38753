/** The numbers of one wing at the clock's time, vein by vein. */

import { make } from "./elements.js";
import { fixed, short, timeText } from "./format.js";

export function mountReadout(element, clip, clock, energy) {
  const rows = [
    { name: "distalAngle", title: "distal angle (deg)", text: (value) => fixed(value, 1) },
    { name: "turnAngle", title: "turn (deg)", text: (value) => fixed(value, 1) },
    { name: "tendonEnergy", title: `tendon energy (${energy.unit})`, text: (value) => short(energy.factor * value) },
  ];
  const veins = Array.from({ length: clip.veins }, (_, vein) => vein);
  const cells = rows.map(() => veins.map(() => make("td")));
  const caption = make("caption");
  const head = make(
    "tr",
    {},
    make("th", { scope: "col" }, "vein"),
    ...veins.map((vein) => make("th", { scope: "col" }, String(vein))),
  );
  const body = rows.map((row, index) => make("tr", {}, make("th", { scope: "row" }, row.title), ...cells[index]));
  const table = make("table", { className: "numbers" }, caption, make("thead", {}, head), make("tbody", {}, ...body));
  element.replaceChildren(make("div", { className: "table" }, table));
  element.classList.add("readout");
  return clock.onChange(() => {
    const moment = clock.clipTime(0);
    caption.textContent = `Every vein at ${timeText(clock.time, clock.span)}`;
    for (const [index, row] of rows.entries()) {
      const values = clip.valuesAt(row.name, moment);
      for (const vein of veins) cells[index][vein].textContent = row.text(values[vein]);
    }
  });
}
