/** Sliders of values that can be changed during the simulation, each with a mark at the value of the page's run. */

import { make } from "./elements.js";
import { capital, short } from "./format.js";

const STEPS = 200;
const WIDE = 20; // ratio of its ends from which a range is logarithmic
const DIGITS = 3; // digits of a slider's value

/** A slider for every value, marked at that of `home`; `changed` receives the key and the value, SI. */
export function makeSliders(knobs, home, changed) {
  const sliders = knobs.map((knob) => makeSlider(knob, home, changed));
  const back = make("button", { type: "button", disabled: true }, `Reset all to ${home}`);
  back.addEventListener("click", () => sliders.forEach((slider) => slider.reset()));
  const element = make("div", { className: "sliders", role: "group", "aria-label": "values to change" });
  element.append(...sliders.map((slider) => slider.element), back);

  return {
    element,
    /** Set values, SI, by key, and reset all others. */
    set(values) {
      for (const slider of sliders) slider.put(values[slider.knob.key] ?? slider.knob.value);
    },
    /** Values that differ from those of the run, SI, by key. */
    get changes() {
      const differing = sliders.filter((slider) => slider.value !== slider.knob.value);
      return Object.fromEntries(differing.map((slider) => [slider.knob.key, slider.value]));
    },
    refresh() {
      back.disabled = sliders.every((slider) => slider.value === slider.knob.value);
    },
  };
}

function makeSlider(knob, where, changed) {
  const { key, title, unit, factor, lowest, highest } = knob;
  const byRatio = lowest > 0 && highest / lowest >= WIDE;
  const valueAt = (share) => (byRatio ? lowest * (highest / lowest) ** share : lowest + share * (highest - lowest));
  const shareOf = (value) => (byRatio ? Math.log(value / lowest) / Math.log(highest / lowest) : (value - lowest) / (highest - lowest));
  const home = Math.round(STEPS * shareOf(knob.value));
  const name = capital(key.replace("protocol.", "").replace("youngs", "Young's").replaceAll(/[._]/g, " "));
  const input = make("input", { type: "range", min: 0, max: STEPS, step: 1, "aria-label": name, "aria-description": title });
  const output = make("output");
  const mark = make("span", { className: "home", title: `in ${where}`, "aria-hidden": "true" });
  mark.style.left = `${(100 * home) / STEPS}%`;
  input.dataset.keys = "own";
  let value = knob.value;

  function show() {
    const text = `${short(factor * value)} ${unit.replaceAll("^2", "\u00b2").replaceAll("^3", "\u00b3")}`;
    output.textContent = text;
    input.setAttribute("aria-valuetext", value === knob.value ? `${text}, as in ${where}` : text);
    element.classList.toggle("changed", value !== knob.value);
  }

  function put(other) {
    value = other;
    input.value = Math.round(STEPS * shareOf(value));
    show();
    changed(key, value);
  }

  input.addEventListener("input", () => {
    const at = Number(input.value);
    // a file has a number with few digits in its unit
    value = at === home ? knob.value : Number((factor * valueAt(at / STEPS)).toPrecision(DIGITS)) / factor;
    show();
    changed(key, value);
  });

  const element = make(
    "label",
    { className: "slider", title: `${key}: ${title}` },
    make("span", { className: "name" }, name),
    output,
    make("span", { className: "rail" }, input, mark),
  );
  input.value = home;
  show();
  return {
    element,
    knob,
    get value() {
      return value;
    },
    put,
    reset: () => put(knob.value),
  };
}
