/** Angles of single creases: of the one that the reader points at or touches in the picture, or chooses in a list. */

import { Vector3 } from "three";
import { pixelOf } from "./camera.js";
import { CREASES } from "./clip.js";
import { make } from "./elements.js";
import { fixed, short } from "./format.js";

const NEAR = 16; // pixels between the pointer and a crease that it points at
const STILL = 6; // pixels that a finger may move and still touch

/**
 * Show the readings of one crease of a stage's only structure; returns the element with the list of creases.
 *
 * A crease stays chosen when it is pressed. A pointer over another one shows that one as long as it is there.
 */
export function showCreases(stage, clip, clock) {
  const { lines } = clip.creases;
  const [canvas, cell] = [stage.canvas, stage.cells[0]];
  const label = make("p", { className: "crease-label", "aria-hidden": "true", hidden: true });
  const mark = make("span", { className: "crease-mark", "aria-hidden": "true", hidden: true });
  cell.append(mark, label);
  const list = make("select", {}, make("option", { value: "" }, "none"), ...lines.map(({ name }, index) => make("option", { value: String(index) }, name)));
  const said = make("output", { "aria-live": "off" });
  const hint = make("span", {}, "or point at one in the picture, or touch it");
  const point = new Vector3();
  let chosen = null;
  let pointed = null;
  let pressed = null;

  /** Position of a vertex in the picture, pixels. */
  function seen(vertex) {
    return pixelOf(point.fromArray(stage.views[0].shape.vertices, 3 * vertex), stage.eye.camera, cell);
  }

  /** Index of the crease at a pointer; null if none is near. Of equally near ones, the nearest to the eye. */
  function at(event) {
    const box = canvas.getBoundingClientRect();
    const place = [event.clientX - box.left, event.clientY - box.top];
    let [best, least] = [null, NEAR];
    for (const [index, { ends }] of lines.entries()) {
      const away = distance(place, ...ends.map(seen)) + depth(ends);
      if (away < least) [best, least] = [index, away];
    }
    return best;
  }

  /** Distance of a crease's middle from the eye as a fraction of a pixel, which decides between equally near ones. */
  const depth = (ends) => point.fromArray(middle(ends)).distanceTo(stage.eye.camera.position) / (1e3 * stage.eye.size);

  function middle(ends) {
    const { vertices } = stage.views[0].shape;
    return [0, 1, 2].map((axis) => (vertices[3 * ends[0] + axis] + vertices[3 * ends[1] + axis]) / 2);
  }

  function text(index) {
    // a fold path that is refined may have other units
    const { lines: now, columns } = clip.creases;
    const values = clip.valuesAt(CREASES, clock.clipTime(0));
    return now[index].columns.map((column) => {
      const { name, unit } = columns[column];
      const value = unit === "\u00b0" ? `${fixed(values[column], 1)}\u00b0` : `${short(Number(values[column].toPrecision(3)))} ${unit}`;
      return `${name} ${value}`;
    }).join(", ");
  }

  function show() {
    const index = pointed ?? chosen;
    label.hidden = mark.hidden = index === null;
    said.textContent = chosen === null ? "" : text(chosen);
    hint.hidden = chosen !== null;
    if (index === null) return;
    label.textContent = `${lines[index].name}: ${text(index)}`;
    const [from, to] = lines[index].ends.map(seen);
    const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
    const angle = Math.atan2(to[1] - from[1], to[0] - from[0]);
    mark.style.width = `${length.toFixed(1)}px`;
    mark.style.transform = `translate(${from[0].toFixed(1)}px, ${from[1].toFixed(1)}px) rotate(${angle.toFixed(4)}rad)`;
  }

  const pointAt = (index) => {
    if (index === pointed) return;
    pointed = index;
    show();
  };
  const choose = (index) => {
    chosen = index;
    list.value = index === null ? "" : String(index);
    show();
  };
  stage.listen("pointermove", (event) => {
    if (event.pointerType === "mouse") pointAt(event.buttons ? null : at(event));
  });
  stage.listen("pointerleave", () => pointAt(null));
  stage.listen("pointerdown", (event) => {
    pressed = event.isPrimary ? [event.clientX, event.clientY] : null;
  });
  stage.listen("pointerup", (event) => {
    if (!pressed || Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) > STILL) return;
    const index = at(event);
    choose(index === chosen ? null : index);
  });
  list.addEventListener("change", () => choose(list.value === "" ? null : Number(list.value)));
  stage.onDraw(show);
  return make("div", { className: "crease-choice" }, make("label", {}, `${clip.creases.kind} `, list), said, hint);
}

/** Distance of a point from a segment, pixels. */
function distance([x, y], [ax, ay], [bx, by]) {
  const [dx, dy] = [bx - ax, by - ay];
  const share = Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy || 1)));
  return Math.hypot(x - ax - share * dx, y - ay - share * dy);
}
