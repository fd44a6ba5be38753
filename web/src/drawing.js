/**
 * Drawings as lists of shapes, painted on a canvas or written as SVG.
 *
 * A shape is {kind, ...}: "rect" with x, y, width, height; "path" with points [[x, y], ...], whose gaps are null;
 * "circle" with x, y, r; "text" with x, y, text, anchor ("start", "middle", "end"), size, bold, turned (upwards). All may
 * have fill, stroke, lineWidth, dash and opacity. "moved" displaces other shapes by x, y, and "clip" shows them only
 * within a rectangle. A "rect" may have a scale of colours from left to right. A file may also have "svg", the content of a
 * drawing with its viewBox in a rectangle. Lengths are in pixels of the page.
 */

const FONT = "system-ui, -apple-system, 'Segoe UI', Roboto, 'Helvetica Neue', Arial, sans-serif";

/** Paint shapes on a canvas with `ratio` pixels for one of the page, displaced by an offset of the page. */
export function paintShapes(context, shapes, ratio = 1, [left, top] = [0, 0]) {
  context.save();
  context.scale(ratio, ratio);
  context.translate(left, top);
  for (const shape of shapes) paint(context, shape);
  context.restore();
}

function paint(context, shape) {
  if (shape.shapes) {
    context.save();
    if (shape.kind === "moved") context.translate(shape.x, shape.y);
    else {
      context.beginPath();
      context.rect(shape.x, shape.y, shape.width, shape.height);
      context.clip();
    }
    for (const inner of shape.shapes) paint(context, inner);
    context.restore();
    return;
  }
  context.globalAlpha = shape.opacity ?? 1;
  context.setLineDash(shape.dash ?? []);
  context.lineWidth = shape.lineWidth ?? 1;
  if (shape.kind === "text") {
    context.font = `${shape.bold ? "bold " : ""}${shape.size ?? 12}px ${FONT}`;
    context.textAlign = { start: "left", middle: "center", end: "right" }[shape.anchor ?? "start"];
    context.fillStyle = shape.fill;
    context.fillText(shape.text, shape.x, shape.y);
    return;
  }
  context.beginPath();
  if (shape.kind === "rect") context.rect(shape.x, shape.y, shape.width, shape.height);
  if (shape.kind === "circle") context.arc(shape.x, shape.y, shape.r, 0, 2 * Math.PI);
  if (shape.kind === "path") for (const run of runsOf(shape.points)) for (const [index, point] of run.entries()) context[index ? "lineTo" : "moveTo"](...point);
  if (shape.fill || shape.scale) {
    context.fillStyle = shape.scale ? gradientOf(context, shape) : shape.fill;
    context.fill();
  }
  if (shape.stroke) {
    context.strokeStyle = shape.stroke;
    context.stroke();
  }
}

function gradientOf(context, { x, width, scale }) {
  const gradient = context.createLinearGradient(x, 0, x + width, 0);
  for (const [index, colour] of scale.entries()) gradient.addColorStop(index / (scale.length - 1), colour);
  return gradient;
}

/** Parts of a path between its gaps. */
function runsOf(points) {
  const runs = [[]];
  for (const point of points) {
    if (point) runs.at(-1).push(point);
    else if (runs.at(-1).length) runs.push([]);
  }
  return runs.filter((run) => run.length);
}

/** A drawing on white as a file in SVG. */
export function svgText(shapes, width, height, title) {
  const clips = { count: 0 };
  const parts = [{ kind: "rect", x: 0, y: 0, width, height, fill: "#ffffff" }, ...shapes].map((shape) => element(shape, clips));
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" width="${number(width)}" height="${number(height)}" viewBox="0 0 ${number(width)} ${number(height)}" font-family="${FONT}">`,
    `<title>${escaped(title)}</title>`,
    ...parts,
    "</svg>\n",
  ].join("\n");
}

function element(shape, clips) {
  if (shape.kind === "svg") {
    const frame = `x="${number(shape.x)}" y="${number(shape.y)}" width="${number(shape.width)}" height="${number(shape.height)}"`;
    return `<svg ${frame} viewBox="${shape.viewBox}"${shape.stretched ? ' preserveAspectRatio="none"' : ""}>${shape.content}</svg>`;
  }
  if (shape.scale) {
    const name = `scale${++clips.count}`;
    const stops = shape.scale.map((colour, index) => `<stop offset="${number(index / (shape.scale.length - 1))}" stop-color="${colour}"/>`);
    return `<linearGradient id="${name}">${stops.join("")}</linearGradient>${element({ ...shape, scale: null, fill: `url(#${name})` }, clips)}`;
  }
  if (shape.kind === "moved") return `<g transform="translate(${number(shape.x)} ${number(shape.y)})">${shape.shapes.map((inner) => element(inner, clips)).join("\n")}</g>`;
  if (shape.kind === "clip") {
    const name = `clip${++clips.count}`;
    const frame = `<clipPath id="${name}"><rect x="${number(shape.x)}" y="${number(shape.y)}" width="${number(shape.width)}" height="${number(shape.height)}"/></clipPath>`;
    return `${frame}<g clip-path="url(#${name})">${shape.shapes.map((inner) => element(inner, clips)).join("\n")}</g>`;
  }
  const { fill = "none", stroke, lineWidth = 1, dash, opacity } = shape;
  const look = [`fill="${fill}"`];
  if (stroke) look.push(`stroke="${stroke}" stroke-width="${number(lineWidth)}" stroke-linejoin="round"`);
  if (dash?.length) look.push(`stroke-dasharray="${dash.join(" ")}"`);
  if (opacity !== undefined && opacity !== 1) look.push(`opacity="${opacity}"`);
  const { x, y } = shape;
  if (shape.kind === "rect") return `<rect x="${number(x)}" y="${number(y)}" width="${number(shape.width)}" height="${number(shape.height)}" ${look.join(" ")}/>`;
  if (shape.kind === "circle") return `<circle cx="${number(x)}" cy="${number(y)}" r="${number(shape.r)}" ${look.join(" ")}/>`;
  if (shape.kind === "path") {
    const d = runsOf(shape.points).map((run) => `M${run.map((point) => point.map(number).join(" ")).join("L")}`);
    return `<path d="${d.join("")}" ${look.join(" ")}/>`;
  }
  const place = shape.turned ? `transform="translate(${number(x)} ${number(y)}) rotate(-90)"` : `x="${number(x)}" y="${number(y)}"`;
  return `<text ${place} font-size="${shape.size ?? 12}"${shape.bold ? ' font-weight="bold"' : ""} text-anchor="${shape.anchor ?? "start"}" ${look.join(" ")}>${escaped(shape.text)}</text>`;
}

const number = (value) => String(Number(value.toFixed(2)));

const escaped = (text) => text.replace(/[&<>"]/g, (letter) => `&#${letter.charCodeAt(0)};`);
