/** The drawing of a pattern over its picture, and of what the pointer or the keys are about to do. */

import { make } from "./elements.js";

const SPACE = "http://www.w3.org/2000/svg";
const ALLOWED = Math.PI / 180; // [chosen] rad, deviation from Kawasaki's condition below which a vertex is not marked

/** Make an element of a drawing. */
function draw(tag, attributes, ...children) {
  const element = document.createElementNS(SPACE, tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children);
  return element;
}

/** Whether a vertex cannot fold flat. */
export const failsAt = ({ kawasaki, maekawa }) => kawasaki === null || kawasaki > ALLOWED || (maekawa ?? 0) !== 0;

/** Whether both conditions hold: "failing", "holding", or "unknown" where an edge is unassigned. */
export const verdictAt = (condition) => (failsAt(condition) ? "failing" : condition.maekawa === null ? "unknown" : "holding");

/** The deviation from Kawasaki's condition as text. */
export const kawasakiText = ({ kawasaki }) => (kawasaki === null ? "odd" : `${((kawasaki * 180) / Math.PI).toFixed(kawasaki > 0.17 ? 0 : 2)}\u00b0`);

/** A picture with a drawing on it; the drawing receives the focus. */
export function makeDrawing() {
  const image = make("img", { alt: "the picture that is traced" });
  const [bands, lines, marks, texts, above] = Array.from({ length: 5 }, () => draw("g", {}));
  const drawing = draw("svg", { class: "trace-drawing", tabindex: "0", role: "application" }, bands, lines, marks, texts, above);
  const sheet = make("div", { className: "trace-sheet" }, image, drawing);
  const element = make("div", { className: "trace-stage" }, sheet);
  const view = { element, drawing, image, width: 1, height: 1, zoom: 1 };

  /** Length in the picture of a pixel of the screen. */
  Object.defineProperty(view, "unit", { get: () => view.width / (drawing.getBoundingClientRect().width || view.width) });

  view.size = (width, height) => {
    Object.assign(view, { width, height, zoom: 1 });
    // positions are counted from the middle of the first pixel
    drawing.setAttribute("viewBox", `-0.5 -0.5 ${width} ${height}`);
    sheet.style.aspectRatio = `${width} / ${height}`;
    sheet.style.width = "100%";
  };

  view.magnify = (factor) => {
    view.zoom = Math.min(Math.max(view.zoom * factor, 1), 16);
    sheet.style.width = `${100 * view.zoom}%`;
  };

  /** The point of the picture under a pointer. */
  view.pointOf = ({ clientX, clientY }) => {
    const box = drawing.getBoundingClientRect();
    return [((clientX - box.left) / box.width) * view.width - 0.5, ((clientY - box.top) / box.height) * view.height - 0.5];
  };

  view.show = (state) => {
    const { unit } = view;
    const { pattern, selected, conditions, doubts } = state;
    const line = ([x1, y1], [x2, y2], name) => draw("line", { x1, y1, x2, y2, class: name });
    const circle = ([cx, cy], radius, name) => draw("circle", { cx, cy, r: radius * unit, class: name });
    const text = ([x, y], words, name) => draw("text", { x: x + 8 * unit, y: y - 8 * unit, "font-size": 13 * unit, class: name }, words);
    bands.replaceChildren(
      ...doubts.lines.map(([start, end]) => line(start, end, "doubtful")),
      ...doubts.places.map((point) => circle(point, 9, "doubtful")),
    );
    lines.replaceChildren(
      ...pattern.edges.flatMap(([one, other], number) => {
        const ends = [pattern.vertices[one], pattern.vertices[other]];
        const chosen = selected.edge === number ? " chosen" : "";
        return [line(...ends, `ground${chosen}`), line(...ends, `crease crease-${pattern.letters[number]}`)];
      }),
    );
    const failing = new Map(conditions.map((condition) => [condition.vertex, verdictAt(condition)]));
    marks.replaceChildren(
      ...state.points.map((point) => circle(point, 2.5, "junction")),
      ...pattern.vertices.map((point, number) => circle(point, 4.5, `vertex ${failing.get(number) ?? ""}${selected.vertex === number ? " chosen" : ""}`)),
    );
    texts.replaceChildren(
      ...conditions.filter(failsAt).map((condition) => {
        const count = condition.maekawa ? `, |M\u2212V| = ${condition.maekawa + 2}` : "";
        return text(pattern.vertices[condition.vertex], `${kawasakiText(condition)}${count}`, "condition");
      }),
    );
    const { cursor, pen, aim, clicks } = state;
    above.replaceChildren(
      ...(clicks.length > 1 ? clicks.map((point, place) => line(point, clicks[(place + 1) % clicks.length], "measured")) : []),
      ...clicks.map((point, place) => circle(point, 6, `click${selected.click === place ? " chosen" : ""}`)),
      ...(pen && aim ? [line(pen, aim.point, "pen")] : []),
      ...(pen ? [circle(pen, 6, "pen")] : []),
      ...(aim?.what ? [circle(aim.point, 9, "aim")] : []),
      ...(cursor ? cross(cursor, 14 * unit, line) : []),
    );
  };

  return view;
}

const cross = ([x, y], size, line) => [line([x - size, y], [x + size, y], "cursor"), line([x, y - size], [x, y + size], "cursor")];
