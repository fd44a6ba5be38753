/**
 * Elements of the page as a drawing to save, in the colours of a light page: their backgrounds, borders, letters and
 * inline SVG, placed as the page shows them.
 */

import { svgText } from "./drawing.js";

const EDGE = 8; // margin around the drawing
const PROPERTIES = ["fill", "stroke", "stroke-width", "stroke-dasharray", "stroke-linejoin", "stroke-linecap", "opacity", "font-size", "font-weight", "paint-order", "text-anchor"];
const COLOURED = new Set(["fill", "stroke"]);

/** Return {svg, width, height} of elements that lie in one column of the page; those within `without` are left out. */
export function elementDrawing(elements, title, without = null) {
  for (const element of elements) element.classList.add("paper");
  try {
    const boxes = elements.map((element) => element.getBoundingClientRect());
    const [left, top] = [Math.min(...boxes.map((box) => box.left)) - EDGE, Math.min(...boxes.map((box) => box.top)) - EDGE];
    const [width, height] = [Math.max(...boxes.map((box) => box.right)) - left + EDGE, Math.max(...boxes.map((box) => box.bottom)) - top + EDGE];
    const shapes = elements.flatMap((element) => shapesOf(element, left, top, without));
    return { svg: svgText(shapes, width, height, title), width, height };
  } finally {
    for (const element of elements) element.classList.remove("paper");
  }
}

/** An element as shapes from its upper left corner, and its size. */
export function elementShapes(element) {
  element.classList.add("paper");
  try {
    const { left, top, width, height } = element.getBoundingClientRect();
    return { shapes: shapesOf(element, left, top, null), width, height };
  } finally {
    element.classList.remove("paper");
  }
}

function shapesOf(element, left, top, without) {
  const style = getComputedStyle(element);
  if (style.display === "none" || style.visibility === "hidden" || (without && element.matches(without))) return [];
  const box = element.getBoundingClientRect();
  const place = { x: box.left - left, y: box.top - top, width: box.width, height: box.height };
  if (element.localName === "svg") return [{ kind: "svg", ...place, viewBox: element.getAttribute("viewBox"), stretched: element.getAttribute("preserveAspectRatio") === "none", content: contentOf(element) }];
  const shapes = [];
  if (box.width && box.height) shapes.push(...groundOf(style, place));
  shapes.push(...linesAround(style, place));
  for (const child of element.childNodes) {
    if (child.nodeType === Node.TEXT_NODE) shapes.push(...lettersOf(child, style, left, top));
    else if (child.nodeType === Node.ELEMENT_NODE) shapes.push(...shapesOf(child, left, top, without));
  }
  return shapes;
}

/** The background: a colour, a scale of colours or both. */
function groundOf(style, place) {
  const colour = plain(style.backgroundColor);
  const round = style.borderTopLeftRadius === "50%" && place.width === place.height;
  const shapes = [];
  if (colour.opacity > 0 && !round) shapes.push({ kind: "rect", ...place, fill: colour.text, opacity: colour.opacity });
  const scale = /^linear-gradient\(to right, (.*)\)$/.exec(style.backgroundImage);
  if (scale) shapes.push({ kind: "rect", ...place, scale: scale[1].match(/rgb\([^)]*\)/g) });
  if (round) shapes.push({ kind: "circle", x: place.x + place.width / 2, y: place.y + place.height / 2, r: place.width / 2 - 1, stroke: plain(style.borderTopColor).text, lineWidth: parseFloat(style.borderTopWidth), ...(colour.opacity ? { fill: colour.text } : {}) });
  return shapes;
}

/** Borders that are drawn above or to the right, as in samples of lines. */
function linesAround(style, { x, y, width, height }) {
  if (style.borderTopLeftRadius === "50%") return [];
  const sides = { Top: [[x, y], [x + width, y]], Right: [[x + width, y], [x + width, y + height]], Bottom: [[x, y + height], [x + width, y + height]], Left: [[x, y], [x, y + height]] };
  return Object.entries(sides).flatMap(([side, points]) => {
    const [line, wide] = [style[`border${side}Style`], parseFloat(style[`border${side}Width`])];
    if (line === "none" || !wide) return [];
    const colour = plain(style[`border${side}Color`]);
    return colour.opacity ? [{ kind: "path", points, stroke: colour.text, lineWidth: wide, opacity: colour.opacity, ...(line === "dashed" ? { dash: [2 * wide, wide] } : {}) }] : [];
  });
}

/** The lines of a text as the page breaks them. */
function lettersOf(node, style, left, top) {
  const size = parseFloat(style.fontSize);
  const look = { size, bold: Number(style.fontWeight) >= 600, fill: plain(style.color).text };
  const range = document.createRange();
  const rows = [];
  for (const { index, 0: word } of node.data.matchAll(/\S+/g)) {
    range.setStart(node, index);
    range.setEnd(node, index + word.length);
    const [box] = range.getClientRects();
    if (!box) continue;
    const row = rows.at(-1);
    const upright = style.writingMode === "horizontal-tb";
    if (row && (upright ? Math.abs(row.box.top - box.top) : Math.abs(row.box.left - box.left)) < 2) {
      row.words.push(word);
      row.last = box;
    } else rows.push({ words: [word], box, last: box });
  }
  if (style.writingMode === "horizontal-tb") return rows.map(({ words, box }) => ({ kind: "text", x: box.left - left, y: box.top - top + box.height / 2 + 0.35 * size, text: words.join(" "), ...look }));
  return rows.map(({ words, box, last }) => ({
    kind: "text",
    x: (box.left + box.right) / 2 - left + 0.35 * size,
    y: (Math.min(box.top, last.top) + Math.max(box.bottom, last.bottom)) / 2 - top,
    text: words.join(" "),
    anchor: "middle",
    turned: true,
    ...look,
  }));
}

/** The content of an inline SVG with its styles written into the elements, without what only the page needs. */
function contentOf(drawing) {
  const copy = drawing.cloneNode(true);
  const [parts, copies] = [drawing, copy].map((each) => [...each.querySelectorAll("*")]);
  for (const [index, part] of parts.entries()) {
    const style = getComputedStyle(part);
    const target = copies[index];
    for (const { name } of [...target.attributes]) if (/^(aria-|data-|class$|role$|tabindex$|style$)/.test(name)) target.removeAttribute(name);
    if (part.localName === "g" || part.localName === "title") continue;
    for (const name of PROPERTIES) {
      const value = style.getPropertyValue(name);
      if (!COLOURED.has(name)) target.setAttribute(name, value);
      else {
        const { text, opacity } = value === "none" ? { text: "none", opacity: 1 } : plain(value);
        target.setAttribute(name, opacity ? text : "none");
        if (opacity && opacity < 1) target.setAttribute(`${name}-opacity`, opacity);
      }
    }
  }
  return new XMLSerializer().serializeToString(copy).replace(/^<svg[^>]*>|<\/svg>$/g, "");
}

/** A computed colour as rgb() with its opacity; mixed colours are written by browsers as color(). */
function plain(colour) {
  const numbers = (colour.match(/[\d.]+(?:e-?\d+)?%?/g) ?? []).map(Number);
  const parts = colour.startsWith("color(") ? numbers.slice(0, 3).map((part) => 255 * part) : numbers.slice(0, 3);
  return { text: `rgb(${parts.map(Math.round).join(",")})`, opacity: numbers[3] ?? 1 };
}
