/** Dragging a structure along its equilibria: the package computes the shape and the force that holds the grabbed place. */

import { Raycaster, Triangle, Vector2, Vector3 } from "three";
import { STEPS, makeArrowPad, pointChoice } from "./arrow-pad.js";
import { ask } from "./bench-ask.js";
import { unpack } from "./clip.js";
import { make } from "./elements.js";
import { listenToGrabs } from "./grab.js";

const STEP = 0.02; // of the structure's size, by which a key drags

/**
 * Let a reader drag the structure of a stage; returns the element with its controls, and a function that ends a drag.
 *
 * moving: clip whose shape is held while it is dragged; shape: returns its present points; names: of the points, null
 * for points that cannot move; asked: returns the present request with the position of the slider; held: receives
 * whether the structure is dragged.
 */
export function listenToDrags(stage, { moving, shape, names, asked, held }) {
  const said = make("p", { className: "note", role: "status" });
  const panels = make("button", { type: "button", "aria-pressed": "false", title: "drag panels as well; otherwise dragging a panel turns the picture" }, "drag panels");
  panels.addEventListener("click", () => panels.setAttribute("aria-pressed", String(panels.getAttribute("aria-pressed") !== "true")));
  let wanted = null; // the next request
  let busy = false;
  let begins = true;
  let released = true;

  /** Request the equilibrium for the last position of the pointer, one request after another. */
  async function send() {
    if (busy || !wanted) return;
    const { place, target } = wanted;
    const request = { ...asked(), weights: Object.fromEntries(place), target, begins };
    wanted = null;
    begins = false;
    busy = true;
    const reply = await ask("drag", request);
    busy = false;
    // released in the meantime
    if (!released) show(reply);
    send();
  }

  function show(reply) {
    const text = reply.refused ? `Not dragged: ${reply.refused}.` : reply.text;
    if (reply.points) {
      moving.hold(unpack(reply.points, Float32Array));
      held(true);
    }
    grabs.say(text);
    said.textContent = text;
  }

  function drag(place, target) {
    if (released) begins = true;
    released = false;
    wanted = { place, target: target.toArray() };
    send();
  }

  function release() {
    released = true;
    wanted = null;
    moving.hold(null);
    held(false);
  }

  /** The place on a panel at a position in the picture, as the weighted mean of points. */
  function between(x, y) {
    if (panels.getAttribute("aria-pressed") !== "true") return null;
    const ray = new Raycaster();
    ray.setFromCamera(new Vector2(x, y), stage.eye.camera);
    const { mesh } = moving;
    let best = null;
    const corners = [new Vector3(), new Vector3(), new Vector3()];
    const hit = new Vector3();
    const { vertices } = stage.views[0].shape;
    for (let first = 0; first < mesh.triangles.length; first += 3) {
      const numbers = mesh.triangles.slice(first, first + 3);
      for (const [corner, number] of numbers.entries()) corners[corner].fromArray(vertices, 3 * number);
      if (!ray.ray.intersectTriangle(...corners, false, hit)) continue;
      const away = hit.distanceTo(ray.ray.origin);
      if (!best || away < best.away) best = { away, numbers, shares: Triangle.getBarycoord(hit, ...corners, new Vector3()).toArray() };
    }
    if (!best) return null;
    const weights = new Map();
    for (const [corner, number] of best.numbers.entries())
      for (const [point, share] of [[mesh.between[2 * number], 1 - mesh.share[number]], [mesh.between[2 * number + 1], mesh.share[number]]])
        if (share) weights.set(point, (weights.get(point) ?? 0) + share * best.shares[corner]);
    return [...weights];
  }

  const grabs = listenToGrabs(stage, {
    points: shape,
    movable: names.map((name) => name !== null),
    between,
    moved: (place, _, target) => drag(place, target),
    left: release,
  });
  const controls = makeDragKeys(stage, shape, names, drag, release);
  const hint = make("p", { className: "note" }, "Drag a vertex: the package computes the equilibrium with the springs of the creases, and the force that holds it.");
  const element = make("div", { className: "drag" }, hint, said, controls.element);
  // beside the views, so that it is in sight together with the picture
  const row = stage.element.parentElement.querySelector(".views");
  row.prepend(make("span", { className: "panels" }, panels));
  return { element, end: controls.end };
}

/** Controls that drag a point, chosen by its name, by arrow keys or buttons. */
function makeDragKeys(stage, shape, names, drag, release) {
  const points = pointChoice(names.map((name, point) => [name, point]).filter(([name]) => name !== null));
  const pad = makeArrowPad("drag", { clicked: move, pressed: move });
  const back = make("button", { type: "button" }, "Release");
  const note = make("p", { className: "note" }, "On these buttons, every arrow key drags the vertex by 2 % of the structure's size. It stays there until it is released.");
  let target = null;

  function move(key) {
    const [across, upwards] = STEPS[key];
    const point = Number(points.value);
    target ??= new Vector3().fromArray(shape(), 3 * point);
    const { camera, size } = stage.eye;
    target.addScaledVector(new Vector3().setFromMatrixColumn(camera.matrixWorld, 0), STEP * size * across);
    target.addScaledVector(new Vector3().setFromMatrixColumn(camera.matrixWorld, 1), STEP * size * upwards);
    drag([[point, 1]], target);
  }

  function end() {
    target = null;
    release();
  }

  points.addEventListener("change", end);
  back.addEventListener("click", end);
  const element = make(
    "details",
    { className: "push-keys" },
    make("summary", {}, "Drag without a pointer"),
    make("div", { className: "choices" }, make("label", {}, "point ", points), pad, back),
    note,
  );
  return { element, end };
}
