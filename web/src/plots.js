/** Plots over time, with a cursor at the clock's time; pressing a plot moves the clock there. */

import uPlot from "uplot";
import { chartDrawing } from "./chart-drawing.js";
import { unpack, valueAt } from "./clip.js";
import { paintShapes } from "./drawing.js";
import { lineSample, make } from "./elements.js";
import { capital, short, timeUnit } from "./format.js";
import { fileName, makeSaveButtons } from "./saving.js";
import { lineLook, onSchemeChange, styleColour } from "./scheme.js";

export const HEIGHT = 210;
const STRETCHED_SPACE = 64; // pixels between times of a stretched time line
const VARIES = 0.02; // least change of values for an axis without zero, as a share of the largest
const DEGREES = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 30, 45, 90, 180, 360, ...powers(3, 20)];

/**
 * Put plots into an element, all over the span of the clock.
 *
 * A plot of one clip has its stages and states. Plots with the same `sharing` have one range of values, so that they can
 * be compared; `owner` is the name of a plot's clip, if several clips have plots of their own.
 */
export function mountPlots(element, plots, clips, clock) {
  const lines = plots.map((plot) => linesOf(plot, clips));
  const made = plots.map((plot, index) => {
    const sharing = plot.sharing ? lines.filter((_, each) => plots[each].sharing === plot.sharing).flat() : null;
    return makePlot(plot, lines[index].map((line) => line.values), sharing, clips, clock);
  });
  element.replaceChildren(...made.map((plot) => plot.element));
  element.classList.add("plots");
  for (const plot of made) plot.start();
  return { charts: made.map((plot) => plot.chart), dispose: () => made.forEach((plot) => plot.dispose()) };
}

/** Readings of each line of a plot at every frame of its clip. */
function linesOf(plot, clips) {
  return plot.lines.map((line) => ({
    clip: line.clip,
    values: line.readings ? clips[line.clip].line(line.readings, line.part) : unpack(line.values, Float32Array),
  }));
}

/** Range of the readings of several lines within a span; values that are not finite are left out. */
function endsWithin(lines, clips, span) {
  const ends = [Infinity, -Infinity];
  for (const { clip, values } of lines) {
    const moments = clips[clip].time;
    for (let frame = 0; frame < moments.length; frame++) {
      const moment = moments[frame] - span.origins[clip];
      if (moment < span.start || moment > span.end) continue;
      if (values[frame] < ends[0]) ends[0] = values[frame];
      if (values[frame] > ends[1]) ends[1] = values[frame];
    }
  }
  return ends;
}

/** Index of the clip to which all lines of a plot belong; null for several clips. */
function clipOf(plot) {
  const [first, ...others] = plot.lines.map((line) => line.clip);
  return others.every((each) => each === first) ? (first ?? null) : null;
}

/** sharing: lines of all plots with the same range of values; null for a range of its own. */
function makePlot(plot, values, sharing, clips, clock) {
  const { element, head, key, place } = figureOf(plot, plot.owner);
  const cursor = make("div", { className: "cursor" });
  // the ball is on one of the lines, if the plot has one
  const ball = plot.ball === undefined ? null : make("div", { className: "ball" });
  let chart = null;
  let span = null;
  let stretched = false;
  let stops = [];
  const watch = new ResizeObserver(() => chart?.setSize({ width: place.clientWidth, height: HEIGHT }));

  function drawKey() {
    const { word } = plot;
    const samples = keyTexts(plot).map((text, index) =>
      make("li", {}, lineSample(lookOf(plot, index)), text),
    );
    key.replaceChildren(...(word ? [make("li", {}, word)] : []), ...samples);
  }

  function follow() {
    if (clock.span !== span || clock.stretched !== stretched) {
      span = clock.span;
      stretched = clock.stretched;
      chart.setData(tables(plot, values, clips, span), false);
      chart.setScale("x", { min: span.start, max: span.end });
    }
    const x = chart.valToPos(clock.time, "x").toFixed(2);
    cursor.style.transform = `translateX(${x}px)`;
    if (ball) ball.style.transform = `translate(${x}px, ${chart.valToPos(valueNow(), "y").toFixed(2)}px)`;
  }

  /** Value of the ball's line at the clock's time. */
  function valueNow() {
    const { clip } = plot.lines[plot.ball];
    return valueAt(clips[clip].time, values[plot.ball], clock.clipTime(clip));
  }

  function start() {
    span = clock.span;
    stretched = clock.stretched;
    chart = new uPlot(options(plot, sharing, clips, clock, place.clientWidth), tables(plot, values, clips, span), place);
    chart.setScale("x", { min: span.start, max: span.end });
    chart.over.append(cursor, ...(ball ? [ball] : []));
    seekByPointer(chart, clock);
    watch.observe(place);
    chart.hooks.setSize = [follow];
    const repaint = () => {
      drawKey();
      chart.redraw(false);
    };
    stops = [clock.onChange(follow), onSchemeChange(repaint)];
    drawKey();
    const only = clipOf(plot);
    head.append(
      saveButtons(plot, () => chart, {
        under: () => stageShapes(chart, clips, only, clock.span),
        over: () => markShapes(chart, clips, only, clock.span),
      }),
    );
  }

  function dispose() {
    for (const stop of stops) stop();
    watch.disconnect();
    chart.destroy();
  }

  return {
    element,
    start,
    dispose,
    get chart() {
      return chart;
    },
  };
}

/** The figure of a plot: its head, an empty legend and a place for its chart; owner: its clip's name, if needed. */
export function figureOf(plot, owner = null) {
  const text = owner ? `${capital(owner)}. ${plot.text}` : plot.text;
  const place = make("div", { className: "chart", role: "img", "aria-label": text });
  const key = make("ul", { className: "key" });
  const heading = make("h2", {}, `${capital(plot.title)} (${plot.unit})`);
  if (owner) heading.append(make("small", {}, owner));
  const head = make("div", { className: "head" }, heading);
  return { element: make("figure", {}, head, key, place, make("figcaption", {}, plot.text)), head, key, place };
}

/** Names of the lines for the legend, in which their common word stands once. */
function keyTexts({ lines, word }) {
  return lines.map(({ name }) => (word ? name.slice(word.length + 1) : name));
}

/** Look of a line of a plot: that of its number, of an area, or of the line over stacked areas. */
function lookOf({ lines, stacked }, index) {
  const { area, look } = lines[index];
  if (area) return { colour: area.startsWith("--") ? styleColour(area) : area, dash: [], area: true };
  return stacked ? { colour: styleColour("--ink"), dash: [] } : lineLook(look ?? index);
}

/** Buttons that save a chart; under, over: as for `chartDrawing`. */
export function saveButtons(plot, chartOf, { under, over }) {
  const what = plot.owner ? `${plot.title}, ${plot.owner}` : plot.title;
  const drawing = () => chartDrawing(chartOf(), { name: `${plot.title} (${plot.unit})`, lines: keyTexts(plot), word: plot.word, under, over, lookOf: plot.stacked ? (index) => lookOf(plot, index) : undefined });
  return makeSaveButtons(what, () => fileName(what), drawing);
}

/** The lines over the clock's time; those of several clips share one row of times. */
function tables(plot, values, clips, span) {
  if (plot.stacked) return stackedTable(plot, values, clips[plot.lines[0].clip], span.origins[plot.lines[0].clip] + span.start, span);
  const byLine = plot.lines.map((line, index) => [
    Float64Array.from(clips[line.clip].time, (moment) => moment - span.origins[line.clip]),
    values[index],
  ]);
  if (clipOf(plot) !== null) {
    return [byLine[0]?.[0] ?? [], ...byLine.map((table) => table[1])];
  }
  return uPlot.join(byLine);
}

/** Upper edges of stacked areas, the topmost first, then lines over them; some count from the start of the span. */
function stackedTable({ lines }, values, clip, start, span) {
  const counted = lines.map(({ since }, index) => {
    const first = since === undefined ? 0 : valueAt(clip.time, values[since], start);
    return Float64Array.from(values[index], (value) => value - first);
  });
  const below = new Float64Array(clip.time.length);
  for (let index = lines.length - 1; index >= 0; index--) {
    if (!lines[index].area) continue;
    for (let frame = 0; frame < below.length; frame++) below[frame] += counted[index][frame];
    counted[index].set(below);
  }
  return [Float64Array.from(clip.time, (moment) => moment - span.origins[lines[0].clip]), ...counted];
}

/** Areas down to zero, each over those below it, and lines over them. */
function stackedSeries(plot) {
  return plot.lines.map(({ area }, index) => ({
    stroke: () => (area ? styleColour("--page") : lookOf(plot, index).colour),
    ...(area ? { fill: () => lookOf(plot, index).colour, fillTo: 0 } : {}),
    width: area ? 0.5 : 1.6,
    points: { show: false },
  }));
}

function options(plot, sharing, clips, clock, width) {
  const axis = axisLook();
  const range = (_, low, high) => yRange(plot, ...(sharing ? endsWithin(sharing, clips, clock.span) : [low, high]));
  return {
    width,
    height: HEIGHT,
    legend: { show: false },
    cursor: { show: false },
    padding: [8, 10, 0, 0],
    scales: { x: { time: false, auto: false, distr: 100, fwd: clock.shareAt, bwd: clock.momentAt }, y: { range } },
    series: [
      {},
      ...(plot.stacked ? stackedSeries(plot) : lineSeries(plot.lines)),
    ],
    axes: [
      {
        ...axis,
        ...ALONG,
        labelFont: axis.font,
        label: () => `${clock.span.label} (${timeUnit(clock.span).unit})${clock.stretched ? ", stretched" : ""}`,
        // on a nonlinear scale others than 1, 2 and 5 would be left out
        filter: (_, splits) => splits,
        splits: (chart, number, low, high, step) => (clock.stretched ? stretchedSplits(chart, clock) : evenSplits(low, high, step)),
        values: (_, splits) =>
          splits.map((value) => (value === null ? "" : tickText(value * timeUnit(clock.span).factor))),
        space: 56,
      },
      valueAxis(plot),
    ],
    hooks: {
      drawClear: [(chart) => paintOver(chart, stageShapes(chart, clips, clipOf(plot), clock.span))],
      draw: [(chart) => paintOver(chart, markShapes(chart, clips, clipOf(plot), clock.span))],
    },
  };
}

/** Round times at about equal distances along a stretched time line. */
function stretchedSplits(chart, clock) {
  const count = Math.max(2, Math.floor(chart.bbox.width / devicePixelRatio / STRETCHED_SPACE));
  const { factor } = timeUnit(clock.span);
  const splits = new Set();
  for (let step = 0; step <= count; step++) {
    const moment = clock.momentAt(step / count);
    const round = [1, 2, 3, 4, 5, 6].map((digits) => Number((factor * moment).toPrecision(digits)) / factor);
    const near = (each) => Math.abs(clock.shareAt(each) - step / count) < 0.2 / count;
    splits.add(round.find(near) ?? round[round.length - 1]);
  }
  return [...splits].filter((each) => each >= clock.span.start && each <= clock.span.end);
}

function evenSplits(low, high, step) {
  const first = Math.ceil(low / step - 1e-9);
  return Array.from({ length: Math.floor(high / step + 1e-9) - first + 1 }, (_, index) => (first + index) * step);
}

/** Looks of lines, by their numbers or by index. */
export function lineSeries(lines) {
  return lines.map(({ look }, index) => ({
    stroke: () => lineLook(look ?? index).colour,
    dash: lineLook(look ?? index).dash,
    width: 1.6,
    points: { show: false },
    spanGaps: true,
  }));
}

/** Layout of a plot's horizontal axis: positions of its name and numbers. */
export const ALONG = { size: 24, gap: 3, labelSize: 18, labelGap: 0 };

export function axisLook() {
  return {
    stroke: () => styleColour("--muted"),
    grid: { stroke: () => styleColour("--grid"), width: 1 },
    ticks: { stroke: () => styleColour("--grid"), width: 1, size: 4 },
    font: "12px system-ui, sans-serif",
  };
}

/** The axis of a plot's values, as wide as its numbers. */
export function valueAxis(plot) {
  return {
    ...axisLook(),
    size: (_, texts) => Math.max(48, 16 + 7 * Math.max(0, ...(texts ?? []).map((text) => text.length))),
    gap: 3,
    values: (_, splits) => splits.map((value) => (value === null ? "" : tickText(value))),
    ...(plot.unit === "deg" ? { incrs: DEGREES, space: 26 } : { space: 30 }),
  };
}

/** Range of the values, with zero unless all are far from it, and with a margin for the letters of the states. */
function yRange(plot, low, high) {
  const [least, most] = awayFromZero(low, high) ? [low, high] : [Math.min(0, low ?? 0), Math.max(0, high ?? 0)];
  const room = 0.06 * (most - least || 1);
  return [plot.unit === "deg" || least !== 0 ? least - room : least, most + 2 * room];
}

/** Whether values that vary lie on one side of zero, further from it than half of the furthest. */
function awayFromZero(low, high) {
  const furthest = Math.max(Math.abs(low), Math.abs(high));
  return low * high > 0 && Math.min(Math.abs(low), Math.abs(high)) > furthest / 2 && high - low > VARIES * furthest;
}

function tickText(value) {
  const text = Math.abs(value) < 1e-12 ? "0" : String(Number(value.toPrecision(6)));
  return text.length > 7 ? short(value) : text.replace("-", "\u2212");
}

/** Paint shapes on a chart; they are placed from the plot's upper left corner. */
export function paintOver(chart, shapes) {
  const { ctx, bbox } = chart;
  paintShapes(ctx, shapes, devicePixelRatio, [bbox.left / devicePixelRatio, bbox.top / devicePixelRatio]);
}

/** Grey bands where torques act on the plot's only clip. */
function stageShapes(chart, clips, only, span) {
  if (only === null) return [];
  const [width, height] = [chart.bbox.width / devicePixelRatio, chart.bbox.height / devicePixelRatio];
  return clips[only].stages
    .filter((each) => each.driven)
    .map((stage) => {
      const [left, right] = [stage.start, stage.end].map((moment) => Math.min(width, Math.max(0, chart.valToPos(moment - span.origins[only], "x"))));
      return { kind: "rect", x: left, y: 0, width: right - left, height, fill: styleColour("--band") };
    });
}

/** Dotted lines with letters a, b and c at the states of the plot's only clip. */
function markShapes(chart, clips, only, span) {
  if (only === null) return [];
  const [width, height] = [chart.bbox.width / devicePixelRatio, chart.bbox.height / devicePixelRatio];
  return clips[only].marks.flatMap((mark) => {
    const x = chart.valToPos(mark.time - span.origins[only], "x");
    if (x < -1 || x > width + 1) return [];
    const side = x > width - 16 ? -1 : 1;
    return [
      { kind: "path", points: [[x, 0], [x, height]], stroke: styleColour("--muted"), dash: [2, 3] },
      // a line under a letter would hide it
      { kind: "rect", x: x + (side > 0 ? 2 : -14), y: 1, width: 12, height: 15, fill: styleColour("--page") },
      { kind: "text", x: x + side * 8, y: 13, text: mark.letter, anchor: "middle", bold: true, fill: styleColour("--ink") },
    ];
  });
}

function seekByPointer(chart, clock) {
  onDrag(chart, (event) => {
    clock.pause();
    clock.seek(chart.posToVal(event.clientX - chart.over.getBoundingClientRect().left, "x"));
  });
}

/** Call `seek` when a chart is pressed, and while the pointer is dragged. */
export function onDrag(chart, seek) {
  chart.over.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    chart.over.setPointerCapture(event.pointerId);
    seek(event);
  });
  chart.over.addEventListener("pointermove", (event) => {
    if (chart.over.hasPointerCapture(event.pointerId)) seek(event);
  });
}

/** 1, 2 and 5 times powers of ten. */
function powers(first, last) {
  return Array.from({ length: last - first }, (_, power) =>
    [1, 2, 5].map((step) => step * 10 ** (first + power)),
  ).flat();
}
