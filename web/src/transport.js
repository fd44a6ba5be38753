/**
 * Controls of a clock: play and pause, the time line with its states, the speed, and the displayed span. A span of
 * another quantity than time names its unit; it has no speed.
 */

import { drawn, icon, make } from "./elements.js";
import { fixed, short, timeText } from "./format.js";
import { SPEEDS } from "./pace.js";

const PLAY = "M7 4.5v15l12-7.5z";
const PAUSE = "M7 5h3.5v14H7zM13.5 5H17v14h-3.5z";
const TICKS = 10_000;
const CLOSE = 0.02; // of the line: letters of marks closer than this would be on top of each other

export function makeTransport(clips, clock) {
  const play = make("button", { type: "button", className: "play" });
  const slider = make("input", { type: "range", min: 0, max: TICKS, step: 1, "aria-label": clock.span.unit ? clock.span.name : "time" });
  const bands = make("div", { className: "bands", "aria-hidden": "true" });
  const ticks = make("div", { className: "ticks", "aria-hidden": "true" });
  const readout = make("p", { className: clips[0].along.length ? "time long" : "time" });
  const spoken = make("p", { className: "spoken", role: "status" });
  const row = make("div", { className: "states" });
  // a fold path that is refined replaces its marks
  let marks = null;
  let states = [];

  function nameStates() {
    if (clips.length > 1 || clips[0].marks === marks) return;
    marks = clips[0].marks;
    states = marks.map((mark) => stateButton(mark, clock));
    row.replaceChildren(...states);
  }

  nameStates();
  const element = make(
    "div",
    { className: "transport" },
    make("div", { className: "line" }, play, make("div", { className: "tracks" }, ...profiles(clips[0], clock), make("div", { className: "track" }, bands, slider, ticks))),
    make(
      "div",
      { className: "choices" },
      readout,
      row,
      ...(clock.span.unit ? [] : [speedChoice(clock)]),
      ...spanChoice(clock),
      spoken,
    ),
  );
  play.addEventListener("click", () => (clock.playing ? clock.pause() : clock.play()));
  slider.addEventListener("input", () => {
    clock.pause();
    clock.seek(clock.momentAt(slider.value / TICKS));
  });
  let drawn = {};
  let wasPlaying = null;
  let quiet = 0;
  clock.onChange(() => {
    nameStates();
    const { span, stretched } = clock;
    if (span !== drawn.span || stretched !== drawn.stretched) drawTrack(clips, clock, bands, ticks);
    drawn = { span, stretched };
    slider.value = Math.round(TICKS * clock.shareAt(clock.time));
    slider.setAttribute("aria-valuetext", momentText(clips, clock));
    const stage = clips.length === 1 ? stageText(clips[0], clock.clipTime(0)) : "";
    const since = clips.length === 1 ? (stage && ` \u00b7 ${stage}`) : clock.span.label.replace("time", "");
    const slow = clock.playing && !clock.span.unit ? `, ${slowness(clock.slowness)}` : "";
    readout.textContent = `${timeText(clock.time, clock.span)}${since}${slow}${alongText(clips[0], clock.clipTime(0), " \u00b7 ")}`;
    for (const [index, mark] of (marks ?? []).entries()) {
      states[index].setAttribute("aria-pressed", String(Math.abs(mark.time - clock.clipTime(0)) < 1e-9));
    }
    if (clock.playing !== wasPlaying) {
      play.replaceChildren(icon(clock.playing ? PAUSE : PLAY));
      play.setAttribute("aria-label", clock.playing ? "pause" : "play");
      wasPlaying = clock.playing;
    }
    // announced once it has come to rest
    clearTimeout(quiet);
    if (!clock.playing)
      quiet = setTimeout(() => {
        spoken.textContent = momentText(clips, clock);
      }, 600);
  });
  return element;
}

/** The first number beside the time as a curve above the slider, with a ball; none for a clip without such numbers. */
function profiles(clip, clock) {
  if (!clip.along.length) return [];
  const curve = drawn("", 100);
  const ball = make("span", { className: "profile-ball" });
  const name = make("small");
  const across = (moment) => 100 * clock.shareAt(moment);
  let up = null;
  let shown = null;

  /** Draw the curve; a fold path that grows replaces its numbers. */
  function draw(first) {
    const values = clip.line(first.key, 0);
    const [low, high] = [Math.min(0, ...values), Math.max(...values)];
    up = (value) => 100 - (100 * (value - low)) / (high - low || 1);
    const points = Array.from(values, (value, frame) => `${across(clip.time[frame]).toFixed(2)} ${up(value).toFixed(2)}`);
    curve.querySelector("path").setAttribute("d", `M${points.join("L")}`);
    name.textContent = first.name;
    // above the lower end of the curve
    name.classList.toggle("at-start", values[0] < values.at(-1));
    shown = first;
  }

  clock.onChange(() => {
    const [first] = clip.along;
    if (first !== shown) draw(first);
    const moment = clock.clipTime(0);
    ball.style.left = `${across(moment).toFixed(2)}%`;
    ball.style.top = `${up(clip.valuesAt(first.key, moment)[0]).toFixed(2)}%`;
  });
  // hidden from screen readers: the slider reads its value aloud, and a plot below shows the curve
  return [make("div", { className: "profile", "aria-hidden": "true" }, curve, ball, name)];
}

function stateButton(mark, clock) {
  const button = make("button", { type: "button", className: "state" }, make("b", {}, mark.letter), ` ${mark.name}`);
  button.addEventListener("click", () => {
    clock.pause();
    clock.seekClip(0, mark.time);
  });
  return button;
}

function speedChoice(clock) {
  const options = SPEEDS.map(({ name, value }) => make("option", { value: String(value) }, name));
  const select = make("select", {}, ...options);
  select.addEventListener("change", () => clock.setSpeed(select.value === "even" ? "even" : Number(select.value)));
  return make("label", {}, "speed ", select);
}

function spanChoice(clock) {
  if (clock.spans.length < 2) return [];
  const options = clock.spans.map((span, index) => make("option", { value: String(index) }, span.name));
  const select = make("select", {}, ...options);
  select.addEventListener("change", () => clock.setSpan(clock.spans[Number(select.value)]));
  clock.onChange(() => {
    select.value = String(clock.spans.indexOf(clock.span));
  });
  return [make("label", {}, "show ", select)];
}

/** Bands where torques act, and ticks at the states; with several clips a tick in each clip's colour. Close ones are one. */
function drawTrack(clips, clock, bands, ticks) {
  const { span } = clock;
  const place = (moment) => Math.min(1, Math.max(0, clock.shareAt(moment)));
  bands.replaceChildren();
  ticks.replaceChildren();
  for (const [index, clip] of clips.entries()) {
    const origin = span.origins[index];
    for (const stage of clip.stages.filter((each) => each.driven && clips.length === 1)) {
      const [left, right] = [place(stage.start - origin), place(stage.end - origin)];
      const band = make("span", { className: "band" });
      band.style.left = `${100 * left}%`;
      band.style.width = `${100 * (right - left)}%`;
      if (right > left) bands.append(band);
    }
    for (const mark of clip.marks) {
      const moment = mark.time - origin;
      if (moment < span.start - 1e-9 || moment > span.end + 1e-9) continue;
      const [at, last] = [place(moment), ticks.lastElementChild];
      if (last && clips.length === 1 && at - last.at < CLOSE) {
        last.append(` ${mark.letter}`);
        continue;
      }
      const tick = make("span", { className: "tick", at }, clips.length === 1 ? mark.letter : "");
      tick.style.left = `${100 * at}%`;
      if (clips.length > 1) tick.style.setProperty("--tick", `var(--line-${index % 7})`);
      ticks.append(tick);
    }
  }
}

function slowness(times) {
  if (times < 1.05) return "real time";
  return `${times < 10 ? fixed(times, 1) : Math.round(times)} times slower`;
}

export function stageText(clip, moment) {
  const mark = clip.markAt(moment);
  return mark ? `${mark.letter} ${mark.name}` : clip.stageAt(moment).name;
}

/** The single numbers of a clip, each after a separator, with three digits. */
function alongText(clip, moment, before) {
  const text = ({ name, unit, key }) => `${before}${name} ${short(Number(clip.valuesAt(key, moment)[0].toPrecision(3)))} ${unit}`;
  return clip.along.map(text).join("");
}

/** The moment in words: its time, and what every structure does. */
function momentText(clips, clock) {
  const parts = clips.map((clip, index) => {
    const moment = clock.clipTime(index);
    return `${clips.length > 1 ? `${clip.name}: ` : ""}${stageText(clip, moment) || clock.span.name}${alongText(clip, moment, ", ")}${readingText(clip, moment)}`;
  });
  return `${timeText(clock.time, clock.span)}: ${parts.join("; ")}`;
}

/** The first readings of a clip: their range. */
function readingText(clip, moment) {
  const [reading] = clip.readings;
  if (!reading) return "";
  const values = clip.markAt(moment)?.readings[reading.name]?.mean ?? clip.valuesAt(reading.name, moment);
  const unit = reading.unit === "deg" ? "degrees" : reading.unit;
  const ends = [Math.min(...values), Math.max(...values)].map((value) => fixed(value, 1));
  const several = values.length > 1;
  return `, ${reading.label}${several ? "s" : ""} ${several ? ends.join(" to ") : ends[0]} ${unit}`;
}
