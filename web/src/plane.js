/** Plane drawings: two axes, and elements of SVG. */

import { numberText } from "./study-model.js";

const SPACE = "http://www.w3.org/2000/svg";

export function draw(tag, properties, ...children) {
  const element = document.createElementNS(SPACE, tag);
  for (const [name, value] of Object.entries(properties)) element.setAttribute(name, value);
  element.append(...children);
  return element;
}

/**
 * Scale of a column's values between two ends: words in equal steps, numbers with `log` by their logarithms.
 * `share` is from 0 to 1, `value` its inverse for numbers, `ticks` round values; `others` are included in the range.
 */
export function scaleOf({ values, log }, others = []) {
  const words = [...new Set(values.filter((value) => typeof value === "string"))];
  if (words.length) {
    const share = (value) => (words.indexOf(value) + 0.5) / words.length;
    return { words, share, ticks: words, value: (at) => words[Math.min(words.length - 1, Math.max(0, Math.floor(at * words.length)))] };
  }
  const numbers = [...values, ...others].filter((value) => typeof value === "number");
  const logarithmic = log && numbers.every((value) => value > 0);
  const [lie, back] = logarithmic ? [Math.log, Math.exp] : [(value) => value, (value) => value];
  const low = numbers.reduce((least, value) => Math.min(least, lie(value)), Infinity);
  const high = numbers.reduce((most, value) => Math.max(most, lie(value)), -Infinity);
  const share = (value) => (high > low ? (lie(value) - low) / (high - low) : 0.5);
  const ticks = numbers.length ? (logarithmic ? roundPowers : roundNumbers)(back(low), back(high)) : [];
  return { words, share, ticks, value: (at) => back(low + at * (high - low)) };
}

/** Positions of values, and of others, on an axis between two ends of the drawing; missing values beside its start. */
export function makeAxis(values, column, from, to, others = []) {
  const label = column.unit ? `${column.name} (${column.unit})` : column.name;
  const scale = scaleOf({ values, log: column.log }, others);
  const margin = 0.04 * (to - from);
  const at = (value) => from + margin + scale.share(value) * (to - from - 2 * margin);
  const ticks = scale.ticks.map((value) => [at(value), typeof value === "number" ? numberText(value) : value]);
  return { label, from, to, ticks, at, place: (point) => (values[point] === null ? from + 0.75 * margin : at(values[point])) };
}

function roundNumbers(low, high) {
  if (!(high > low)) return [low];
  const rough = (high - low) / 5;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = power * ([1, 2, 5].find((each) => each * power >= rough) ?? 10);
  const found = [];
  for (let value = Math.ceil(low / step) * step; value <= high + 1e-9 * step; value += step) found.push(Number(value.toPrecision(12)));
  return found;
}

/** Round numbers of a logarithmic axis: 1, 2 and 5 of each power, or only powers if there are many. */
function roundPowers(low, high) {
  if (!(high > low)) return [low];
  const parts = high / low > 200 ? [1] : [1, 2, 5];
  const found = [];
  for (let power = Math.floor(Math.log10(low)); power <= Math.ceil(Math.log10(high)); power++)
    for (const part of parts) {
      const value = Number((part * 10 ** power).toPrecision(12));
      if (value >= low * (1 - 1e-9) && value <= high * (1 + 1e-9)) found.push(value);
    }
  return found.length > 1 ? found : roundNumbers(low, high);
}

/** Lines and letters of two axes; `height` is the lower end of the drawing. */
export function axisParts(across, upwards, height) {
  const parts = [draw("path", { class: "axis", d: `M${across.from} ${upwards.to}V${upwards.from}H${across.to}` })];
  const write = (text, properties) => parts.push(draw("text", { class: "label", ...properties }, text));
  for (const [x, text] of across.ticks) write(text, { x, y: upwards.from + 18, "text-anchor": "middle" });
  for (const [y, text] of upwards.ticks) write(text, { x: across.from - 8, y, dy: "0.35em", "text-anchor": "end" });
  write(across.label, { x: (across.from + across.to) / 2, y: height - 8, "text-anchor": "middle" });
  write(upwards.label, { transform: `translate(14 ${(upwards.from + upwards.to) / 2}) rotate(-90)`, "text-anchor": "middle" });
  return parts;
}
