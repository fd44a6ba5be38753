/** Settings as a design file: the text of the run's file, with other values on their lines. */

import { make } from "./elements.js";

/** The file's text with values, SI, by key. */
function designText(live, changes) {
  const lines = live.design.text.split("\n");
  for (const { key, unit, factor, line } of live.knobs)
    if (key in changes) lines[line.number] = `${line.before}${quantity(changes[key], unit, factor)}${line.after}`;
  return lines.join("\n");
}

/** The text of a value, SI, of a key that can be changed. */
export function valueText({ knobs }, key, value) {
  const { unit, factor } = knobs.find((knob) => knob.key === key);
  return quantity(value, unit, factor);
}

/** A value as written in a design file. */
function quantity(value, unit, factor) {
  return `${Number((factor * value).toPrecision(12))} ${unit}`;
}

/** A link to the file, and the command that runs it; `refresh` receives the changes. */
export function makeDesignLink(live) {
  const link = make("a", { className: "button", download: "design.toml" }, "This setting as a design file");
  const command = make("code");
  const note = make("p", { className: "note" }, "This page does not check the energy balance; a run of the file does.");
  const element = make("div", { className: "setting" }, link, make("pre", {}, command), note);

  function refresh(changes) {
    const bytes = new TextEncoder().encode(designText(live, changes));
    link.href = `data:application/toml;base64,${btoa(String.fromCharCode(...bytes))}`;
    command.textContent = "forficula run design.toml";
  }

  refresh({});
  return { element, refresh };
}
