/** Where the structures are seen from: one camera for all of them. */

import { PerspectiveCamera, Vector3 } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";

const FIELD = 28; // deg, upwards
const ROOM = 1.1;
const TURN = Math.PI / 24;
const ZOOM = 1.15;

// towards the eye; seen from exactly above there would be no up
export const VIEWS = [
  { name: "3-D", text: "obliquely from above", towards: [0.37, -0.695, 0.616] },
  { name: "top", text: "from above", towards: [0, -0.0005, 1] },
  { name: "side", text: "from the side, level with what lies flat", towards: [0, -1, 0.0001] },
  { name: "along", text: "from the far end, along the middle", towards: [1, 0, 0.0001] },
];

/** A camera that turns about what the clips ever show, by pointer, wheel and keys. */
export function makeCamera(canvas, clips, onChange) {
  const seen = sample(clips);
  const target = centre(seen);
  const size = largest(seen, (point) => point.distanceTo(target));
  const camera = new PerspectiveCamera(FIELD, 1, 0.02 * size, 60 * size);
  camera.up.set(0, 0, 1);
  const controls = new OrbitControls(camera, canvas);
  controls.minDistance = 0.3 * size;
  controls.maxDistance = 20 * size;
  controls.addEventListener("change", onChange);
  let view = VIEWS[0];
  let moved = false;
  controls.addEventListener("start", () => {
    moved = true;
  });
  // a wheel over the picture scrolls the page, until the picture is chosen
  const hold = (event) => {
    if (document.activeElement !== canvas && !event.ctrlKey) event.stopImmediatePropagation();
  };
  canvas.parentElement.addEventListener("wheel", hold, { capture: true });

  function show(chosen) {
    view = chosen;
    moved = false;
    const towards = new Vector3(...chosen.towards).normalize();
    const fit = fitted(seen, towards, camera);
    controls.target.copy(fit.target);
    camera.position.copy(fit.target).addScaledVector(towards, fit.distance);
    controls.update();
    onChange();
  }

  function turn(across, upwards) {
    moved = true;
    const offset = camera.position.clone().sub(controls.target);
    offset.applyAxisAngle(camera.up, across * TURN);
    const side = new Vector3().crossVectors(camera.up, offset).normalize();
    const lifted = offset.clone().applyAxisAngle(side, -upwards * TURN);
    // not over the top
    if (Math.abs(lifted.z) < 0.9999 * lifted.length()) offset.copy(lifted);
    camera.position.copy(controls.target).add(offset);
    controls.update();
    onChange();
  }

  function zoom(steps) {
    moved = true;
    const offset = camera.position
      .clone()
      .sub(controls.target)
      .multiplyScalar(ZOOM ** -steps);
    offset.clampLength(controls.minDistance, controls.maxDistance);
    camera.position.copy(controls.target).add(offset);
    controls.update();
    onChange();
  }

  /** Fit the picture's shape; a view that nobody has turned is fitted anew. */
  function resize(aspect, rows) {
    camera.aspect = aspect;
    camera.updateProjectionMatrix();
    controls.rotateSpeed = rows;
    controls.panSpeed = rows;
    if (!moved) show(view);
  }

  return { camera, controls, size, target, show, turn, zoom, resize, dispose: () => controls.dispose() };
}

/** Points of all structures at moments all through, as many as a view needs. */
function sample(clips) {
  const seen = [];
  for (const clip of clips) {
    const step = Math.max(1, Math.floor(clip.time.length / 60));
    for (let frame = 0; frame < clip.time.length; frame += step) {
      const points = clip.pointsAt(clip.time[frame]);
      for (let at = 0; at < points.length; at += 3) seen.push(new Vector3(points[at], points[at + 1], points[at + 2]));
    }
  }
  return seen;
}

/** The middle of the box around points. */
function centre(points) {
  const low = new Vector3(Infinity, Infinity, Infinity);
  const high = new Vector3(-Infinity, -Infinity, -Infinity);
  for (const point of points) {
    low.min(point);
    high.max(point);
  }
  return low.add(high).multiplyScalar(0.5);
}

/** What to look at, and from how far away, so that all points are in the picture. */
function fitted(points, towards, camera) {
  const right = new Vector3().crossVectors(camera.up, towards).normalize();
  const upwards = new Vector3().crossVectors(towards, right);
  const axes = [right, upwards, towards];
  const places = points.map((point) => axes.map((axis) => point.dot(axis)));
  const high = Math.tan((FIELD * Math.PI) / 360) / ROOM;
  const slopes = [high * camera.aspect, high];
  const middle = axes.map(
    (_, axis) => (largest(places, (place) => place[axis]) - largest(places, (place) => -place[axis])) / 2,
  );
  let distance = 0;
  // what is nearer looks larger: shift the middle until both sides need the same distance
  for (let round = 0; round < 20; round++) {
    const needed = [0, 1].map((axis) =>
      [-1, 1].map((side) =>
        largest(places, (place) => (side * (place[axis] - middle[axis])) / slopes[axis] + place[2] - middle[2]),
      ),
    );
    distance = Math.max(...needed.flat());
    for (const axis of [0, 1]) middle[axis] += ((needed[axis][1] - needed[axis][0]) * slopes[axis]) / 2;
  }
  const target = new Vector3();
  for (const [index, axis] of axes.entries()) target.addScaledVector(axis, middle[index]);
  return { target, distance: distance || 1 };
}

/** The largest of a number of each, of very many, too. */
function largest(all, number) {
  let most = -Infinity;
  for (const each of all) most = Math.max(most, number(each));
  return most;
}
