/** Viewpoint of the structures: one camera for all, which follows them as they move. */

import { PerspectiveCamera, Vector3 } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { makeFraming } from "./framing.js";

const FIELD = 28; // deg, vertical field of view
const ROOM = 1.05; // distance of the eye, as a multiple of the least one that frames everything
const TURN = Math.PI / 24;
const ZOOM = 1.15;

// directions towards the eye; exactly above there would be no upward direction
export const VIEWS = [
  { name: "3-D", text: "obliquely from above", towards: [0.37, -0.695, 0.616] },
  { name: "top", text: "from above", towards: [0, -0.0005, 1] },
  { name: "side", text: "from the side, along the flat plane", towards: [0, -1, 0.0001] },
  { name: "along", text: "from the far end, along the centre line", towards: [1, 0, 0.0001] },
];

/**
 * A camera that frames the clips, and that is turned, moved and zoomed by pointer, wheel and keys.
 *
 * `aim` positions it for the clock's time: for all structures or, if each has a scale of its own, for one. `look` holds
 * the reader's choices; a camera made with the look of another one continues with its view.
 */
export function makeCamera(canvas, clips, clock, onChange, look = firstLook()) {
  const { size, target } = extent(clips);
  const all = clips.map((_, index) => index);
  const together = makeFraming(clips, all, clock);
  const alone = all.map((index) => makeFraming(clips, [index], clock));
  const camera = new PerspectiveCamera(FIELD, 1, 0.02 * size, 60 * size);
  camera.up.set(0, 0, 1);
  const controls = new OrbitControls(camera, canvas);
  controls.minDistance = 0.1 * size;
  controls.maxDistance = 20 * size;
  let fitted = null;

  function aim(index = 0) {
    const frame = look.oneScale ? together : alone[index];
    const high = Math.tan((FIELD * Math.PI) / 360) / ROOM;
    fitted = frame(look.towards, camera.up, [high * camera.aspect, high], look.following);
    if (look.oneScale) fitted.distance *= look.scale;
    controls.target.copy(fitted.target).addScaledVector(look.aside, fitted.distance);
    camera.position.copy(controls.target).addScaledVector(look.towards, look.closer * fitted.distance);
    camera.lookAt(controls.target);
    camera.updateMatrixWorld();
  }

  function changed() {
    aim();
    onChange();
  }

  // the reader's choices are kept relative to the view that frames the structures
  controls.addEventListener("change", () => {
    const away = camera.position.clone().sub(controls.target);
    look.closer = away.length() / fitted.distance;
    look.towards.copy(away).normalize();
    look.aside.copy(controls.target).sub(fitted.target).divideScalar(fitted.distance);
    changed();
  });
  // the wheel scrolls the page until the picture is clicked
  const hold = (event) => {
    if (document.activeElement !== canvas && !event.ctrlKey) event.stopImmediatePropagation();
  };
  canvas.parentElement.addEventListener("wheel", hold, { capture: true });

  function show({ towards }) {
    look.towards.set(...towards).normalize();
    look.closer = 1;
    look.aside.set(0, 0, 0);
    changed();
  }

  function turn(across, upwards) {
    const turned = look.towards.clone().applyAxisAngle(camera.up, across * TURN);
    const side = new Vector3().crossVectors(camera.up, turned).normalize();
    const lifted = turned.clone().applyAxisAngle(side, -upwards * TURN);
    // not beyond the vertical
    look.towards.copy(Math.abs(lifted.z) < 0.9999 ? lifted : turned);
    changed();
  }

  function zoom(steps) {
    const distance = look.closer * fitted.distance * ZOOM ** -steps;
    look.closer = Math.min(controls.maxDistance, Math.max(controls.minDistance, distance)) / fitted.distance;
    changed();
  }

  function choose(choice) {
    Object.assign(look, choice);
    changed();
  }

  /** Adapt to the shape of the picture. */
  function resize(aspect, rows) {
    camera.aspect = aspect;
    camera.updateProjectionMatrix();
    controls.rotateSpeed = rows;
    controls.panSpeed = rows;
    changed();
  }

  return { camera, controls, look, size, target, aim, show, turn, zoom, choose, resize, dispose: () => controls.dispose() };
}

/**
 * towards: direction to the eye; closer: its distance, relative to the one that fits; aside: its displacement, in the
 * same unit; scale: distance of all structures, relative to the one that fits, if larger ones are shown at other times.
 */
export function firstLook() {
  return {
    towards: new Vector3(...VIEWS[0].towards).normalize(),
    closer: 1,
    aside: new Vector3(),
    following: true,
    oneScale: true,
    scale: 1,
  };
}

/** Centre of the box around all positions in time, and its half diagonal. */
function extent(clips) {
  const low = new Vector3(Infinity, Infinity, Infinity);
  const high = new Vector3(-Infinity, -Infinity, -Infinity);
  const point = new Vector3();
  for (const clip of clips) {
    const step = Math.max(1, Math.floor(clip.time.length / 60));
    for (let frame = 0; frame < clip.time.length; frame += step) {
      const points = clip.pointsAt(clip.time[frame]);
      for (let at = 0; at < points.length; at += 3) {
        point.fromArray(points, at);
        low.min(point);
        high.max(point);
      }
    }
  }
  const target = low.clone().add(high).multiplyScalar(0.5);
  return { target, size: high.distanceTo(target) || 1 };
}

/** Position of a point in a picture of an element's size, pixels from its upper left corner; the point is changed. */
export function pixelOf(point, camera, { clientWidth, clientHeight }) {
  const { x, y } = point.project(camera);
  return [((x + 1) / 2) * clientWidth, ((1 - y) / 2) * clientHeight];
}
