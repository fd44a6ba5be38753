/** The numbers of one wing at the clock's time, vein by vein; in a state those that the summary states for it. */

import { make } from "./elements.js";
import { fixed, short, timeText } from "./format.js";

export function mountReadout(element, clip, clock, energy) {
  const degrees = (value) => fixed(value, 1);
  const joules = (value) => short(energy.factor * value);
  const rows = [
    { name: "distalAngle", title: "distal angle (deg)", text: degrees, ofState: statedAngle },
    { name: "turnAngle", title: "turn (deg)", text: degrees },
    {
      name: "tendonEnergy",
      title: `tendon energy (${energy.unit})`,
      text: joules,
      ofState: (mark, vein) => joules(mark.tendonEnergy_J[vein]),
    },
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
    const mark = clip.markAt(moment);
    const state = mark ? `, ${mark.name} (means)` : "";
    caption.textContent = `Every vein at ${timeText(clock.time, clock.span)}${state}`;
    for (const [index, row] of rows.entries()) {
      if (mark && row.ofState) {
        for (const vein of veins) cells[index][vein].textContent = row.ofState(mark, vein);
        continue;
      }
      const values = clip.valuesAt(row.name, moment);
      for (const vein of veins) cells[index][vein].textContent = row.text(values[vein]);
    }
  });
}

/** A mean, and half the swing where there is one. */
function statedAngle(mark, vein) {
  const swing = mark.distalSwing_deg[vein];
  return `${fixed(mark.distalAngle_deg[vein], 1)}${swing > 0.05 ? ` \u00b1 ${fixed(swing, 1)}` : ""}`;
}
