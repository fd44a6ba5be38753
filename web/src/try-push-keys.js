/** Pushing a structure without a pointer: a point selected by name, and keys or buttons that push it. */

import { Vector3 } from "three";
import { make } from "./elements.js";
import { short } from "./format.js";

const HELD = 500; // ms for which a button pushes
const SHARES = [
  ["a little", 0.1],
  ["half", 0.5],
  ["as strong as its drives", 1],
];
const WAYS = [
  ["\u2190", "left", "ArrowLeft", [-1, 0]],
  ["\u2191", "up", "ArrowUp", [0, 1]],
  ["\u2193", "down", "ArrowDown", [0, -1]],
  ["\u2192", "right", "ArrowRight", [1, 0]],
];

/** Choice of a point of a stage's only structure, and controls that push it; `push` receives the point and force, N. */
export function makePushKeys(stage, live, names, strongest, push) {
  const movable = names.map((name, point) => [name, point]).filter(([, point]) => live.movable[point]);
  const points = make("select", {}, ...movable.map(([name, value]) => make("option", { value }, name)));
  const shares = make("select", {}, ...SHARES.map(([name, value]) => make("option", { value, selected: value === SHARES[0][1] }, name)));
  const said = make("span", { className: "note", role: "status" });
  const buttons = WAYS.map(([text, way, key]) => make("button", { type: "button", title: `push ${way}`, "aria-label": `push ${way}`, "data-way": key }, text));
  const pad = make("span", { className: "pad", role: "group", "aria-label": "push in the plane of the picture" }, ...buttons);
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
    const [across, upwards] = [0, 1].map((axis) => WAYS.reduce((sum, [, , key, way]) => sum + (held.has(key) ? way[axis] : 0), 0));
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

  pad.addEventListener("keydown", (event) => {
    if (!event.key.startsWith("Arrow") || event.shiftKey || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    event.stopPropagation();
    if (held.has(event.key)) return;
    held.add(event.key);
    act();
  });
  pad.addEventListener("keyup", ({ key }) => {
    if (held.delete(key)) act();
  });
  pad.addEventListener("focusout", leave);
  for (const button of buttons)
    button.addEventListener("click", () => {
      held.clear();
      held.add(button.dataset.way);
      act();
      ending = setTimeout(leave, HELD);
    });
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
    const { x, y } = place.fromArray(live.frame.points, 3 * chosen()).project(stage.eye.camera);
    ring.setAttribute("cx", ((x + 1) / 2) * stage.canvas.clientWidth);
    ring.setAttribute("cy", ((1 - y) / 2) * stage.canvas.clientHeight);
  }

  live.clock.onChange(mark);
  stage.eye.controls.addEventListener("change", mark);
  mark();
  return mark;
}
