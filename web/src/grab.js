/** Grabbing a point of a stage's only structure with the pointer: a line leads from the point to the pointer. */

import { Vector3 } from "three";
import { pixelOf } from "./camera.js";
import { make } from "./elements.js";

const NEAR = 22; // pixels within which a point is grabbed

/**
 * Listen to grabs; the picture does not turn meanwhile. A grabbed place is the weighted mean of points: pairs of an index
 * and a weight.
 *
 * points: returns the present coordinates; movable: whether each point can be grabbed; between: the place at a position
 * in the picture without a point, or null; moved: receives the place, its position, and the position of the pointer at
 * the same distance from the eye; left: called at the end. Returns {say}, which writes into the picture.
 */
export function listenToGrabs(stage, { points, movable, between = () => null, moved, left }) {
  const { canvas, eye } = stage;
  const line = document.createElementNS("http://www.w3.org/2000/svg", "line");
  const drawing = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  drawing.classList.add("push");
  drawing.setAttribute("aria-hidden", "true");
  drawing.append(line);
  const said = make("p", { className: "pushed", "aria-hidden": "true" });
  stage.element.append(drawing, said);
  drawing.style.display = "none";
  const [point, mean] = [new Vector3(), new Vector3()];
  let held = null;
  let at = null; // of the pointer, in pixels

  function positionOf(place) {
    mean.set(0, 0, 0);
    for (const [index, weight] of place) mean.addScaledVector(point.fromArray(points(), 3 * index), weight);
    return mean;
  }

  /** Position of a place on the canvas, in pixels. */
  function seen(place) {
    return pixelOf(positionOf(place), eye.camera, canvas);
  }

  function pointer(event) {
    const box = canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }

  function nearest([x, y]) {
    let best = { place: null, away: NEAR };
    for (let index = 0; index < movable.length; index++) {
      if (!movable[index]) continue;
      const place = [[index, 1]];
      const [across, down] = seen(place);
      const away = Math.hypot(across - x, down - y);
      if (away < best.away) best = { place, away };
    }
    return best.place;
  }

  /** The position in the picture in units of its half width and half height, as cameras have it. */
  const inUnits = ([x, y]) => [(2 * x) / canvas.clientWidth - 1, 1 - (2 * y) / canvas.clientHeight];

  const grabbed = (event) => nearest(pointer(event)) ?? between(...inUnits(pointer(event)));

  function draw() {
    if (!held) return;
    const from = seen(held);
    for (const [name, value] of [["x1", from[0]], ["y1", from[1]], ["x2", at[0]], ["y2", at[1]]]) line.setAttribute(name, value);
    drawing.style.display = "";
  }

  const press = (event) => {
    held = event.button === 0 ? grabbed(event) : null;
    if (!held) return;
    eye.controls.enabled = false;
    canvas.setPointerCapture(event.pointerId);
    event.stopImmediatePropagation();
  };
  stage.listen("pointerdown", press, true);
  stage.listen("pointermove", (event) => {
    if (!held) {
      canvas.classList.toggle("grip", grabbed(event) !== null);
      return;
    }
    at = pointer(event);
    const position = positionOf(held).clone();
    const depth = position.clone().project(eye.camera).z;
    moved(held, position, new Vector3(...inUnits(at), depth).unproject(eye.camera));
    draw();
  });
  const leave = () => {
    if (!held) return;
    held = null;
    eye.controls.enabled = true;
    drawing.style.display = "none";
    said.textContent = "";
    left();
  };
  stage.listen("pointerup", leave);
  stage.listen("pointercancel", leave);
  stage.onDraw(draw);
  return { say: (text) => (said.textContent = text) };
}
