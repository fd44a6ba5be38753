/** A chart as a drawing to save: its lines over axes with units and labels, a legend, and what is drawn under and over it. */

import { svgText } from "./drawing.js";
import { capital } from "./format.js";
import { lineLook, onPaper, styleColour } from "./scheme.js";

const LABEL = 20; // room for the name of an axis
const [BELOW, RIGHT, TICK] = [46, 14, 4];
const ROW = 18; // height of a row of the legend
const SAMPLE = 26; // length of a line in the legend, with the gap after it
const GAP = 16; // between entries of the legend
const LETTERS = 12;

/**
 * Return {svg, width, height} of a chart in the colours of a light page.
 *
 * name: of the vertical axis, with its unit; lines: names for the legend; word: before them; under, over: functions that
 * return shapes relative to the plot's upper left corner; lookOf: look of a line by index, by default that of its number.
 */
export function chartDrawing(chart, { name, lines, word = "", under = () => [], over = () => [], lookOf = lineLook }) {
  return onPaper(() => {
    const looks = chart.data.slice(1).map((_, index) => lookOf(index));
    const [across, upwards] = [chart.bbox.width / devicePixelRatio, chart.bbox.height / devicePixelRatio];
    const sideways = LABEL + chart.axes[1]._size;
    const width = sideways + across + RIGHT;
    const legend = legendShapes(word, lines, looks, sideways, width - RIGHT);
    const top = legend.height + 8;
    const plot = [
      ...under(),
      ...gridShapes(chart, across, upwards),
      { kind: "clip", x: 0, y: 0, width: across, height: upwards, shapes: lineShapes(chart, looks) },
      { kind: "path", points: [[0, 0], [0, upwards], [across, upwards]], stroke: styleColour("--ink") },
      ...over(),
      ...labelShapes(chart, name, across, upwards, sideways),
    ];
    const height = top + upwards + BELOW;
    return { svg: svgText([...legend.shapes, { kind: "moved", x: sideways, y: top, shapes: plot }], width, height, name), width, height };
  });
}

/** Entries of the legend in rows between two ends, and the height of the rows. */
function legendShapes(word, lines, looks, left, right) {
  const measure = document.createElement("canvas").getContext("2d");
  measure.font = `${LETTERS}px system-ui, sans-serif`;
  const shapes = [];
  let [x, y] = [left, ROW - 4];
  const fill = styleColour("--ink");
  const place = (text, room) => {
    const width = room + measure.measureText(text).width;
    if (x > left && x + width > right) [x, y] = [left, y + ROW];
    const at = x;
    x += width + GAP;
    return at;
  };
  if (word) shapes.push({ kind: "text", x: place(word, 0), y, text: word, size: LETTERS, fill });
  for (const [index, text] of lines.entries()) {
    const at = place(text, SAMPLE);
    const { colour, dash, area } = looks[index];
    if (area) shapes.push({ kind: "rect", x: at, y: y - 9, width: SAMPLE - 6, height: 9, fill: colour });
    else shapes.push({ kind: "path", points: [[at, y - 4], [at + SAMPLE - 6, y - 4]], stroke: colour, lineWidth: 1.6, dash });
    shapes.push({ kind: "text", x: at + SAMPLE, y, text, size: LETTERS, fill });
  }
  return { shapes, height: shapes.length ? y + 4 : 0 };
}

/** Numbers of an axis with their positions; uPlot keeps them after it has drawn the axis. */
function ticksOf(chart, index, scale) {
  const { _splits: splits, _values: texts } = chart.axes[index];
  return splits.flatMap((value, at) => (texts[at] ? [[chart.valToPos(value, scale), texts[at]]] : []));
}

function gridShapes(chart, across, upwards) {
  const line = (...points) => ({ kind: "path", points, stroke: styleColour("--grid") });
  return [...ticksOf(chart, 0, "x").map(([x]) => line([x, 0], [x, upwards])), ...ticksOf(chart, 1, "y").map(([y]) => line([0, y], [across, y]))];
}

function lineShapes(chart, looks) {
  const [moments, ...columns] = chart.data;
  return columns.map((values, index) => {
    const { colour, dash, area } = looks[index];
    const points = [];
    for (let at = 0; at < moments.length; at++) {
      if (values[at] === null || values[at] === undefined || Number.isNaN(values[at])) continue;
      points.push([chart.valToPos(moments[at], "x"), chart.valToPos(values[at], "y")]);
    }
    if (!area || !points.length) return { kind: "path", points, stroke: colour, lineWidth: 1.6, dash };
    const foot = chart.valToPos(0, "y");
    const ends = [points.at(-1), points[0]].map(([x]) => [x, foot]);
    return { kind: "path", points: [...points, ...ends], fill: colour, stroke: styleColour("--page"), lineWidth: 0.5 };
  });
}

function labelShapes(chart, name, across, upwards, sideways) {
  const [fill, stroke] = [styleColour("--ink"), styleColour("--ink")];
  const text = (x, y, words, more) => ({ kind: "text", x, y, text: words, size: LETTERS, fill, ...more });
  const { label } = chart.axes[0];
  return [
    ...ticksOf(chart, 0, "x").flatMap(([x, words]) => [{ kind: "path", points: [[x, upwards], [x, upwards + TICK]], stroke }, text(x, upwards + TICK + 13, words, { anchor: "middle" })]),
    ...ticksOf(chart, 1, "y").flatMap(([y, words]) => [{ kind: "path", points: [[0, y], [-TICK, y]], stroke }, text(-TICK - 4, y + 4, words, { anchor: "end" })]),
    text(across / 2, upwards + 38, typeof label === "function" ? label() : label, { anchor: "middle" }),
    text(12 - sideways, upwards / 2, capital(name), { anchor: "middle", turned: true }),
  ];
}
