/** Controls of parts: turn the joints, take them apart, hide some, select one. */

import { icon, make } from "./elements.js";
import { fixed } from "./format.js";

const PLAY = "M7 4.5v15l12-7.5z";
const PAUSE = "M7 5h3.5v14H7zM13.5 5H17v14h-3.5z";
const DEGREES = 180 / Math.PI;
const STEP = 1; // deg, step of an arrow key
const FURTHER = 10;
const SAMPLES = 720; // samples of the range of angles, to find where straps go slack

/** Slider of the joints' angle, with its stops, a play button, and the state of the straps. */
export function makeHinge(model, clock, angleOf, momentOf) {
  const [low, high] = [model.lowest, model.highest].map((angle) => angle * DEGREES);
  const taut = tautRanges(model);
  const named = marksOf(model, low, high, taut);
  const play = make("button", { type: "button", className: "play" });
  const slider = make("input", { type: "range", min: low, max: high, step: "any", "aria-label": "hinge angle" });
  slider.dataset.keys = "own";
  const readout = make("p", { className: "time" });
  const go = (angle) => {
    clock.pause();
    clock.seek(momentOf(Math.min(high, Math.max(low, angle)) / DEGREES));
  };
  const toggle = () => (clock.playing ? clock.pause() : clock.play());
  const buttons = named.map(({ angle, name }) => {
    const button = make("button", { type: "button" }, make("b", {}, degrees(angle)), ` ${name}`);
    button.addEventListener("click", () => go(angle));
    return button;
  });
  slider.addEventListener("input", () => go(Number(slider.value)));
  listenToSteps(slider, () => angleOf(clock.time) * DEGREES, go, toggle);
  play.addEventListener("click", toggle);
  clock.onChange(() => {
    const angle = angleOf(clock.time) * DEGREES;
    slider.value = angle;
    readout.textContent = `${degrees(angle, 1)}${strapText(model, angle)}`;
    slider.setAttribute("aria-valuetext", `${fixed(angle, 1)} degrees${strapText(model, angle)}`);
    for (const [index, each] of named.entries())
      buttons[index].setAttribute("aria-pressed", String(Math.abs(each.angle - angle) < 0.005));
    const label = clock.playing ? "pause" : "play: fold from stop to stop";
    if (play.getAttribute("aria-label") !== label) play.replaceChildren(icon(clock.playing ? PAUSE : PLAY));
    play.setAttribute("aria-label", label);
  });
  return make(
    "div",
    { className: "transport" },
    make("div", { className: "line" }, play, makeTrack(slider, low, high, taut, named)),
    make("div", { className: "choices" }, readout, make("div", { className: "states" }, ...buttons)),
  );
}

/** A slider above bands of taut straps, with ticks at named angles. */
function makeTrack(slider, low, high, taut, named) {
  const bands = make("div", { className: "bands", "aria-hidden": "true" });
  const ticks = make("div", { className: "ticks", "aria-hidden": "true" });
  const share = (angle) => `${(100 * angle) / (high - low)}%`;
  for (const [from, to] of taut) {
    const band = make("span", { className: "band" });
    Object.assign(band.style, { left: share(from - low), width: share(to - from) });
    bands.append(band);
  }
  for (const { angle, stop } of named) {
    const tick = make("span", { className: stop ? "tick stop" : "tick" });
    tick.style.left = share(angle - low);
    ticks.append(tick);
  }
  return make("div", { className: "track" }, bands, slider, ticks);
}

/** Keys of the slider: whole degrees, tens, and the stops. */
function listenToSteps(slider, now, go, toggle) {
  const steps = { ArrowLeft: -STEP, ArrowDown: -STEP, ArrowRight: STEP, ArrowUp: STEP };
  const further = { PageDown: -FURTHER, PageUp: FURTHER, Home: -Infinity, End: Infinity };
  slider.addEventListener("keydown", (event) => {
    if (event.shiftKey || event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === " ") toggle();
    else if (event.key in steps) go(Math.round(now() + steps[event.key]));
    else if (event.key in further) go(now() + further[event.key]);
    else return;
    event.preventDefault();
  });
}

const degrees = (angle, digits = null) =>
  `${digits === null ? fixed(angle, Number.isInteger(Number(angle.toFixed(3))) ? 0 : 1) : fixed(angle, digits)}\u00b0`;

/** Named angles: the stops, flat, and where straps go slack. */
function marksOf(model, low, high, taut) {
  if (model.folds) {
    const ends = [
      { angle: low, name: "flat", stop: true },
      { angle: high, name: "folded", stop: true },
    ];
    return high > low ? ends : ends.slice(0, 1);
  }
  const stops = (key) => [...new Set(model.joints.map((joint) => Number((joint[key] * DEGREES).toFixed(6))))];
  const found = [
    ...stops("lower").map((angle) => ({ angle, name: "folding stop", stop: true })),
    ...taut.flatMap(([from, to]) => [from, to].map((angle) => ({ angle, name: "all straps slack" }))),
    ...(low < 0 && high > 0 ? [{ angle: 0, name: "flat" }] : []),
    ...stops("upper").map((angle) => ({ angle, name: high > 0 ? "overbend stop" : "stop, flat", stop: true })),
  ];
  const ends = (angle) => Math.abs(angle - low) < 1e-6 || Math.abs(angle - high) < 1e-6;
  return found
    .filter((mark) => mark.stop || mark.name === "flat" || !ends(mark.angle))
    .sort((one, other) => one.angle - other.angle);
}

/** Ranges of angles, deg, in which a strap of any joint is taut. */
function tautRanges(model) {
  const slackAt = (angle) => strapsAt(model, angle).every(({ longer }) => longer < 0);
  const [low, high] = [model.lowest * DEGREES, model.highest * DEGREES];
  const edge = (from, to) => {
    const before = slackAt(from);
    for (let step = 0; step < 40; step++) {
      const middle = (from + to) / 2;
      if (slackAt(middle) === before) from = middle;
      else to = middle;
    }
    return to;
  };
  const ranges = [];
  if (!model.straps.length) return ranges;
  let start = slackAt(low) ? null : low;
  for (let step = 1; step <= SAMPLES; step++) {
    const [from, to] = [step - 1, step].map((each) => low + ((high - low) * each) / SAMPLES);
    if (slackAt(from) === slackAt(to)) continue;
    if (start === null) start = edge(from, to);
    else {
      ranges.push([start, edge(from, to)]);
      start = null;
    }
  }
  if (start !== null) ranges.push([start, high]);
  return ranges;
}

/** Extension of each strap beyond its rest length, m, and its rest length. */
function strapsAt(model, angle) {
  const poses = model.turn(model.anglesTogether(angle / DEGREES));
  return model.straps.flatMap((strap) =>
    model.strapStretches(strap, poses).map((longer) => ({ longer, rest: strap.rest })),
  );
}

function strapText(model, angle) {
  const straps = strapsAt(model, angle);
  if (!straps.length) return "";
  const slack = straps.filter(({ longer }) => longer < 0).length;
  const longest = Math.max(...straps.map(({ longer }) => longer));
  if (slack === straps.length) return `, straps slack by ${fixed(-1e3 * longest, 1)} mm or more`;
  const most = Math.max(...straps.map(({ longer, rest }) => longer / rest));
  const stretched = `stretched by up to ${fixed(1e3 * longest, 1)} mm (${fixed(100 * most, 1)} %)`;
  return slack ? `, ${slack} of ${straps.length} straps slack, others ${stretched}` : `, straps ${stretched}`;
}

/** Slider of the distance between parts. */
export function makeApart(change) {
  const slider = make("input", { type: "range", min: 0, max: 100, step: 1, value: 0 });
  slider.dataset.keys = "own";
  slider.addEventListener("input", () => change(Number(slider.value) / 100));
  slider.setAttribute("aria-valuetext", "together");
  slider.addEventListener("input", () => {
    slider.setAttribute("aria-valuetext", slider.value === "0" ? "together" : `${slider.value} % apart`);
  });
  return make("label", { className: "slide" }, "take apart ", slider);
}

/** A check box with a colour for each kind of part: whether it is displayed. */
export function makeKinds(looks, counts, change) {
  const boxes = looks.map((look, index) => {
    const box = make("input", { type: "checkbox", checked: true });
    box.dataset.keys = "own";
    box.addEventListener("change", () => change(index, box.checked));
    const swatch = make("span", { className: "swatch panel", "aria-hidden": "true" });
    swatch.style.background = look.colour;
    return make("label", {}, box, swatch, `${look.name}${counts[index] > 1 ? `, ${counts[index]}` : ""}`);
  });
  return make("fieldset", { className: "kinds" }, make("legend", {}, "show"), ...boxes);
}

/** A choice between a few texts. */
export function makeChoice(name, texts, change) {
  const select = make("select", {}, ...texts.map((text, index) => make("option", { value: String(index) }, text)));
  select.addEventListener("change", () => change(Number(select.value)));
  return make("label", {}, `${name} `, select);
}
