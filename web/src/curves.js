/**
 * Curves of energy over an angle, with balls: at the position of a run or of a fold path at the clock's time or, without
 * either, at a slider's position. Pressing the curve of a run or path moves the clock to the nearest time.
 */

import uPlot from "uplot";
import { unpack, valueAt } from "./clip.js";
import { lineSample, make } from "./elements.js";
import { short } from "./format.js";
import { ALONG, HEIGHT, axisLook, figureOf, lineSeries, onDrag, paintOver, saveButtons, valueAxis } from "./plots.js";
import { lineLook, onSchemeChange, styleColour } from "./scheme.js";

const ANGLES = [0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 30, 45, 60, 90, 180];
const TALLER = 1.35;

/** Put curves into an element; clips and clock belong to the page's run or fold path, if any. */
export function mountCurves(element, curves, clips = [], clock = null) {
  const made = curves.map((curve) => makeCurve(curve, clips[0], clock));
  element.replaceChildren(...made.map((each) => each.element));
  element.classList.add("plots");
  for (const each of made) each.start();
  return made;
}

function makeCurve(data, clip, clock) {
  const [lines, balls, marks] = [data.lines, data.balls, data.marks].map((courses) => courses.map(readCourse));
  const { element, head, key, place } = figureOf(data);
  const dots = (balls.length ? balls : [lines[0]]).map((ball) =>
    make("span", { className: "ball" }, balls.length && ball.name.length < 3 ? ball.name : ""),
  );
  const now = balls.map((ball) => [ball.places[0], ball.values[0]]);
  const height = Math.round(TALLER * HEIGHT);
  const whole = endsOf(lines);
  let shown = whole;
  let chart = null;
  let stops = [];

  function drawKey() {
    const samples = lines.map((line, index) => make("li", {}, lineSample(lineLook(index)), line.name));
    const what = balls.length ? `the ${data.along} now` : "moved by the slider";
    key.replaceChildren(...samples, make("li", {}, make("span", { className: "ball still" }), what));
  }

  /** Place the balls; balls outside the displayed part of the curve are hidden. */
  function placeBalls() {
    for (const [index, [angle, energy]] of now.entries()) {
      const [x, y] = [chart.valToPos(angle, "x"), chart.valToPos(energy, "y")];
      dots[index].style.transform = `translate(${x.toFixed(2)}px, ${y.toFixed(2)}px)`;
    }
  }

  function follow() {
    const moment = clock.clipTime(0);
    for (const [index, { places, values }] of balls.entries()) now[index] = [places, values].map((line) => valueAt(clip.time, line, moment));
    placeBalls();
  }

  function show(range) {
    shown = range;
    chart.setScale("x", { min: range[0], max: range[1] });
  }

  /** Range of energy: of the whole curve including zero and the run; of a part of it only that of the first line. */
  function energyRange(_, low, high) {
    if (shown !== whole) {
      const { places, values } = lines[0];
      const part = values.filter((_, at) => places[at] >= shown[0] && places[at] <= shown[1]);
      const [least, most] = [Math.min(...part), Math.max(...part)];
      return [least - 0.25 * (most - least), most + 0.25 * (most - least)];
    }
    const most = balls.reduce((found, ball) => Math.max(found, ball.most), high);
    const least = Math.min(0, low);
    return [least - 0.06 * (most - least || 1), most + 0.1 * (most - least || 1)];
  }

  function start() {
    const table = uPlot.join(lines.map((line) => [line.sorted.places, line.sorted.values]));
    chart = new uPlot(options({ data, lines, balls, marks, energyRange }, place.clientWidth, height), table, place);
    chart.over.append(...dots);
    const watch = new ResizeObserver(() => chart.setSize({ width: place.clientWidth, height }));
    watch.observe(place);
    chart.hooks.setSize = [placeBalls];
    chart.hooks.setScale = [placeBalls];
    drawKey();
    const repaint = onSchemeChange(() => {
      drawKey();
      chart.redraw(false);
    });
    head.append(saveButtons(data, () => chart, { under: () => [], over: () => [...runShapes(chart, data.along === "run" ? balls : []), ...stateShapes(chart, marks)] }));
    stops = [repaint, () => watch.disconnect(), () => chart.destroy()];
    if (data.top) place.after(views(whole, data.top, show));
    if (balls.length) {
      clock.onChange(follow);
      seekByPointer(chart, balls, clip, clock);
    } else {
      slide(data, lines[0], place, (angle, energy) => {
        now[0] = [angle, energy];
        placeBalls();
      });
    }
    show(whole);
  }

  return {
    element,
    start,
    dispose: () => stops.forEach((stop) => stop()),
    now,
    get chart() {
      return chart;
    },
  };
}

function readCourse({ name, places, values }) {
  const course = { name, places: unpack(places, Float32Array), values: unpack(values, Float32Array) };
  const order = Array.from(course.places.keys()).sort((one, other) => course.places[one] - course.places[other]);
  course.most = course.values.reduce((most, value) => Math.max(most, value), 0);
  course.sorted = { places: order.map((at) => course.places[at]), values: order.map((at) => course.values[at]) };
  return course;
}

/** Range of the angles of all lines, with a margin. */
function endsOf(lines) {
  const all = lines.flatMap((line) => [line.sorted.places[0], line.sorted.places.at(-1)]);
  const [low, high] = [Math.min(...all), Math.max(...all)];
  return [low - 0.03 * (high - low), high + 0.03 * (high - low)];
}

function options({ data, lines, balls, marks, energyRange }, width, height) {
  const look = axisLook();
  const values = valueAxis(data);
  return {
    width,
    height,
    legend: { show: false },
    cursor: { show: false },
    pxAlign: 0,
    padding: [10, 12, 0, 0],
    scales: {
      x: { time: false, auto: false, dir: data.backwards ? -1 : 1 },
      y: { range: energyRange },
    },
    series: [
      {},
      ...lineSeries(lines),
    ],
    axes: [
      {
        ...look,
        ...ALONG,
        labelFont: look.font,
        label: `${data.axis} (deg)`,
        values: values.values,
        incrs: ANGLES,
        space: 44,
      },
      values,
    ],
    hooks: { draw: [(chart) => paintOver(chart, [...runShapes(chart, data.along === "run" ? balls : []), ...stateShapes(chart, marks)])] },
  };
}

/** The run's positions as faint dots, because nothing is known between two frames of a snap. */
function runShapes(chart, balls) {
  const [width, height] = [chart.bbox.width / devicePixelRatio, chart.bbox.height / devicePixelRatio];
  const dots = balls.flatMap(({ places, values }) => Array.from(places, (place, frame) => [chart.valToPos(place, "x"), chart.valToPos(values[frame], "y")]));
  return dots
    .filter(([x, y]) => x > 0 && x < width && y > 0 && y < height)
    .map(([x, y]) => ({ kind: "rect", x: x - 0.8, y: y - 0.8, width: 1.6, height: 1.6, fill: styleColour("--accent"), opacity: 0.55 }));
}

/** Rings at stable states, wide lines along stable ranges, with their names. */
function stateShapes(chart, marks) {
  const [width, height] = [chart.bbox.width / devicePixelRatio, chart.bbox.height / devicePixelRatio];
  const shapes = marks.flatMap(({ name, places, values }) => {
    const points = Array.from(places, (place, at) => [chart.valToPos(place, "x"), chart.valToPos(values[at], "y")]);
    const [x, y] = points[points.length >> 1];
    const look =
      points.length === 1
        ? { kind: "circle", x, y, r: 4.5, fill: styleColour("--page"), stroke: styleColour("--ink"), lineWidth: 1.4 }
        : { kind: "path", points, stroke: styleColour("--line-2"), lineWidth: 7, opacity: 0.35 };
    const side = points.length > 1 ? 0 : x > width / 2 ? -1 : 1;
    return [look, { kind: "text", x: x + 12 * side, y: y - 9, text: name, anchor: ["end", "middle", "start"][side + 1], fill: styleColour("--ink") }];
  });
  return [{ kind: "clip", x: -6, y: 0, width: width + 12, height: height + 6, shapes }];
}

/** Buttons for the whole curve and for its barrier. */
function views(whole, top, show) {
  const buttons = [["whole curve", whole], ["barrier enlarged", top]].map(([text, range], index) => {
    const button = make("button", { type: "button", "aria-pressed": String(index === 0) }, text);
    button.addEventListener("click", () => {
      for (const each of buttons) each.setAttribute("aria-pressed", String(each === button));
      show(range);
    });
    return button;
  });
  return make("div", { className: "ranges", role: "group", "aria-label": "part of the curve" }, ...buttons);
}

/** Move the clock to the time at which the run was nearest to the pointer. */
function seekByPointer(chart, balls, clip, clock) {
  const seek = (event) => {
    const box = chart.over.getBoundingClientRect();
    const [x, y] = [event.clientX - box.left, event.clientY - box.top];
    let [nearest, least] = [0, Infinity];
    for (const { places, values } of balls)
      for (let frame = 0; frame < places.length; frame++) {
        const away = Math.hypot(chart.valToPos(places[frame], "x") - x, chart.valToPos(values[frame], "y") - y);
        if (away < least) [nearest, least] = [frame, away];
      }
    clock.pause();
    clock.seekClip(0, clip.time[nearest]);
  };
  onDrag(chart, seek);
}

/** A slider that moves the ball along a line, from the line's start, and displays its position. */
function slide(data, line, place, moved) {
  const last = line.places.length - 1;
  const slider = make("input", { type: "range", min: "0", max: String(last), value: "0" });
  slider.setAttribute("aria-label", `${data.axis} along the curve`);
  // screen readers hear the slider instead
  const said = make("output", { "aria-live": "off" });
  const move = () => {
    const at = Number(slider.value);
    moved(line.places[at], line.values[at]);
    const [angle, energy] = [short(line.places[at]), `${short(line.values[at])} ${data.unit}`];
    said.textContent = `${angle}\u00b0, ${energy}`;
    slider.setAttribute("aria-valuetext", `${data.axis} ${angle} degrees, energy ${energy}`);
  };
  slider.addEventListener("input", move);
  place.after(make("div", { className: "slide" }, slider, said));
  move();
}
