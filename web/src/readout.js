/** Numbers of one run at the clock's time, by hinge and tendon; in a state those of the summary. */

import { TENDONS } from "./clip.js";
import { make } from "./elements.js";
import { capital, fixed, short, timeText } from "./format.js";

const SWINGS = { deg: 0.05 }; // swing from which it is displayed, by unit

/** index: index of the clip on its clock; named: whether its name is displayed, beside other clips. */
export function mountReadout(element, clip, clock, energy, index = 0, named = false) {
  const { heading, names } = clip.mesh.parts;
  const rows = clip.readings.map((reading) => ({
    name: reading.name,
    title: reading.row,
    parts: reading.parts,
    text: (value) => number(value, reading.unit),
    ofState: (mark) => mark.readings[reading.name] && stated(mark.readings[reading.name], reading.unit),
  }));
  const joules = (value) => short(energy.factor * value);
  if (clip.tendons)
    rows.push({
      name: TENDONS,
      title: `tendon energy (${energy.unit})`,
      parts: clip.mesh.tendonParts,
      text: joules,
      ofState: (mark) => mark.tendonEnergy_J?.map(joules),
    });
  const cells = rows.map(() => names.map(() => make("td")));
  const caption = make("caption");
  const head = make(
    "tr",
    {},
    heading ? make("th", { scope: "col" }, heading) : make("td"),
    ...names.map((name) => make("th", { scope: "col" }, name)),
  );
  const body = rows.map((row, index) => make("tr", {}, make("th", { scope: "row" }, row.title), ...cells[index]));
  const table = make("table", { className: "numbers" }, caption, make("thead", {}, head), make("tbody", {}, ...body));
  element.replaceChildren(make("div", { className: "table" }, table));
  element.classList.add("readout");
  return clock.onChange(() => {
    const moment = clock.clipTime(index);
    const mark = clip.markAt(moment);
    const state = mark ? `, ${mark.name}${mark.tendonEnergy_J ? " (means)" : ""}` : "";
    const whose = named ? `${clip.name}: ` : "";
    const what = heading ? `every ${heading}` : "all values";
    caption.textContent = `${capital(`${whose}${what}`)} at ${timeText(clock.time, clock.span)}${state}`;
    for (const [index, row] of rows.entries()) {
      const texts = (mark && row.ofState(mark)) || Array.from(clip.valuesAt(row.name, moment), row.text);
      for (const [place, part] of row.parts.entries()) cells[index][part].textContent = texts[place];
    }
  });
}

function number(value, unit) {
  return unit === "deg" ? fixed(value, 1) : short(value);
}

/** Means, each with half its range if it has one. */
function stated({ mean, swing }, unit) {
  return mean.map((value, place) => {
    const hasSwing = swing[place] > (SWINGS[unit] ?? 0.005 * Math.abs(value));
    return `${number(value, unit)}${hasSwing ? ` \u00b1 ${number(swing[place], unit)}` : ""}`;
  });
}
