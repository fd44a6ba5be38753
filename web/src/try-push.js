/** Pushing a structure with the pointer: a dragged point is pulled by a spring between it and the pointer. */

import { Vector3 } from "three";
import { make } from "./elements.js";
import { short } from "./format.js";

const NEAR = 22; // pixels within which a point is grabbed
const REACH = 0.25; // distance of the largest force, as a share of the structure's size

/**
 * Let a reader push the points of a stage's only structure; `push` receives the point and the force, N, or null.
 * The picture does not turn while something is pushed.
 */
export function listenToPushes(stage, live, span, strongest, push) {
  const { canvas, eye } = stage;
  const line = document.createElementNS("http://www.w3.org/2000/svg", "line");
  const drawing = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  drawing.classList.add("push");
  drawing.setAttribute("aria-hidden", "true");
  drawing.append(line);
  const said = make("p", { className: "pushed", "aria-hidden": "true" });
  stage.element.append(drawing, said);
  drawing.style.display = "none";
  const place = new Vector3();
  let held = null;

  /** Position of a point on the canvas, in pixels. */
  function seen(point) {
    const shown = place.fromArray(live.frame.points, 3 * point).project(eye.camera);
    return [((shown.x + 1) / 2) * canvas.clientWidth, ((1 - shown.y) / 2) * canvas.clientHeight];
  }

  function pointer(event) {
    const box = canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }

  function nearest([x, y]) {
    let best = { point: -1, away: NEAR };
    for (let point = 0; point < live.movable.length; point++) {
      if (!live.movable[point]) continue;
      const [across, down] = seen(point);
      const away = Math.hypot(across - x, down - y);
      if (away < best.away) best = { point, away };
    }
    return best.point;
  }

  /** Force towards the pointer, at the point's distance from the eye. */
  function force(event) {
    const [x, y] = pointer(event);
    const at = new Vector3().fromArray(live.frame.points, 3 * held);
    const depth = at.clone().project(eye.camera).z;
    const target = new Vector3((2 * x) / canvas.clientWidth - 1, 1 - (2 * y) / canvas.clientHeight, depth).unproject(eye.camera);
    const pull = target.sub(at).multiplyScalar(strongest / (REACH * span));
    return pull.clampLength(0, strongest).toArray();
  }

  function draw(event, size) {
    const [from, to] = [seen(held), pointer(event)];
    for (const [name, value] of [["x1", from[0]], ["y1", from[1]], ["x2", to[0]], ["y2", to[1]]]) line.setAttribute(name, value);
    drawing.style.display = "";
    said.textContent = `pushed with ${short(size)} N`;
  }

  canvas.addEventListener(
    "pointerdown",
    (event) => {
      const point = event.button === 0 ? nearest(pointer(event)) : -1;
      if (point < 0) return;
      held = point;
      eye.controls.enabled = false;
      canvas.setPointerCapture(event.pointerId);
      event.stopImmediatePropagation();
    },
    { capture: true },
  );
  canvas.addEventListener("pointermove", (event) => {
    if (held === null) {
      canvas.classList.toggle("grip", nearest(pointer(event)) >= 0);
      return;
    }
    const pulled = force(event);
    push(held, pulled);
    draw(event, Math.hypot(...pulled));
  });
  const leave = () => {
    if (held === null) return;
    held = null;
    eye.controls.enabled = true;
    drawing.style.display = "none";
    said.textContent = "";
    push(0, null);
  };
  canvas.addEventListener("pointerup", leave);
  canvas.addEventListener("pointercancel", leave);
}
