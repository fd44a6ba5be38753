/** Pushing a structure without a pointer: a point selected by name, and keys or buttons that push it. */

import { Vector3 } from "three";
import { STEPS, makeArrowPad, pointChoice } from "./arrow-pad.js";
import { pixelOf } from "./camera.js";
import { make } from "./elements.js";
import { short } from "./format.js";

const HELD = 500; // ms for which a button pushes
const SHARES = [
  ["a little", 0.1],
  ["half", 0.5],
  ["as strong as its drives", 1],
];

/** Choice of a point of a stage's only structure, and controls that push it; `push` receives the point and force, N. */
export function makePushKeys(stage, live, names, strongest, push) {
  const points = pointChoice(names.map((name, point) => [name, point]).filter(([, point]) => live.movable[point]));
  const shares = make("select", {}, ...SHARES.map(([name, value]) => make("option", { value, selected: value === SHARES[0][1] }, name)));
  const said = make("span", { className: "note", role: "status" });
  const pad = makeArrowPad("push", { clicked: pushBriefly, pressed: hold });
  const note = make("p", { className: "note" }, "On these buttons, arrow keys push while they are held. Pressing a button pushes for half a second.");
  const element = make(
    "details",
    { className: "push-keys" },
    make("summary", {}, "Push without a pointer"),
    make("div", { className: "choices" }, make("label", {}, "point ", points), make("label", {}, "force ", shares), pad, said),
    note,
  );
  const mark = makeMark(stage, live, () => Number(points.value), element);
  const held = new Set();
  let ending = 0;

  /** Push according to the held keys, or stop pushing. */
  function act() {
    clearTimeout(ending);
    const [across, upwards] = [0, 1].map((axis) => [...held].reduce((sum, key) => sum + STEPS[key][axis], 0));
    if (!across && !upwards) {
      said.textContent = "";
      push(0, null);
      return;
    }
    const { camera } = stage.eye;
    const force = new Vector3().setFromMatrixColumn(camera.matrixWorld, 0).multiplyScalar(across);
    force.addScaledVector(new Vector3().setFromMatrixColumn(camera.matrixWorld, 1), upwards).setLength(Number(shares.value) * strongest);
    said.textContent = `${points.selectedOptions[0].text} pushed with ${short(force.length())} N`;
    push(Number(points.value), force.toArray());
  }

  function leave() {
    if (!held.size) return;
    held.clear();
    act();
  }

  function hold(key) {
    if (held.has(key)) return;
    held.add(key);
    act();
  }

  function pushBriefly(key) {
    held.clear();
    held.add(key);
    act();
    ending = setTimeout(leave, HELD);
  }

  pad.addEventListener("keyup", ({ key }) => {
    if (held.delete(key)) act();
  });
  pad.addEventListener("focusout", leave);
  points.addEventListener("change", () => {
    leave();
    mark();
  });
  element.addEventListener("toggle", mark);
  return element;
}

/** A ring about the selected point, while the choice is open. */
function makeMark(stage, live, chosen, choice) {
  const space = "http://www.w3.org/2000/svg";
  const drawing = document.createElementNS(space, "svg");
  const ring = document.createElementNS(space, "circle");
  ring.setAttribute("r", "9");
  drawing.classList.add("push");
  drawing.setAttribute("aria-hidden", "true");
  drawing.append(ring);
  stage.element.append(drawing);
  const place = new Vector3();

  function mark() {
    drawing.style.display = choice.open ? "" : "none";
    if (!choice.open) return;
    const [x, y] = pixelOf(place.fromArray(live.frame.points, 3 * chosen()), stage.eye.camera, stage.canvas);
    ring.setAttribute("cx", x);
    ring.setAttribute("cy", y);
  }

  live.clock.onChange(mark);
  stage.eye.controls.addEventListener("change", mark);
  mark();
  return mark;
}
