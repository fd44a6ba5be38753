/** The picture: one canvas with a cell for every structure, drawn only when something has changed. */

import { DirectionalLight, HemisphereLight, Scene, Vector3 } from "three";
import { makeCamera } from "./camera.js";
import { make } from "./elements.js";
import { makeFloor } from "./floor.js";
import { makeGravity } from "./gravity.js";
import { leaveRenderer, takeRenderer } from "./renderer.js";
import { onSchemeChange, styleColour } from "./scheme.js";

const LONGEST = 4096; // pixels of the canvas in one direction, which all graphics chips support
const NAME_ROOM = 3.2; // lines of text at the top of a cell, if several structures have names
const TOWARDS_LIGHT = new Vector3(-0.45, 0.75, 1);
// together slightly less than what makes a lit surface white, so that colours match the legend
const LIGHT = 0.42 * Math.PI;
const SKY = 0.64 * Math.PI;
// opacity of the grid
const GRID = 0.5;
const GRID_FROM_BELOW = 0.14;

/**
 * Make a stage for clips; without WebGL the processor draws, and the stage has a sentence about that in its `note`.
 * shapeOf: makes the drawn shape of a clip; text: a sentence about the picture; look: initial view of the camera.
 * Its cells contain the structures' names and other text of the page.
 */
export function makeStage(clips, clock, shapeOf, text, look) {
  const taken = takeRenderer();
  const { renderer, canvas, webgl } = taken;
  canvas.setAttribute("aria-label", `${text} ${HELP}`);
  const ended = new AbortController();
  const cells = clips.map(() => make("div", { className: "cell" }));
  const several = clips.length > 1;
  const element = make("div", { className: several ? "stage several" : "stage" }, canvas, ...cells);
  element.style.setProperty(
    "--columns",
    String(clips.length === 4 ? 2 : Math.min(clips.length, clips.length > 6 ? 4 : 3)),
  );
  const names = () => (several ? Math.ceil(NAME_ROOM * parseFloat(getComputedStyle(cells[0]).fontSize)) : 0);
  renderer.setScissorTest(true);
  const eye = makeCamera(canvas, clips, clock, invalidate, look);
  const views = clips.map((clip) => makeView(clip, shapeOf(clip), eye));
  let waiting = 0;
  let posed = false;
  const drawn = new Set();

  function invalidate() {
    if (!waiting) waiting = requestAnimationFrame(draw);
  }

  function pose() {
    for (const [index, view] of views.entries()) view.shape.pose(clock.clipTime(index));
    posed = true;
  }

  function draw() {
    cancelAnimationFrame(waiting);
    waiting = 0;
    if (!posed) pose();
    const height = canvas.clientHeight;
    const named = names();
    renderer.setScissor(0, 0, canvas.clientWidth, height);
    renderer.setViewport(0, 0, canvas.clientWidth, height);
    renderer.clear();
    for (const [index, view] of views.entries()) {
      eye.aim(index);
      const cell = cells[index];
      const place = [
        cell.offsetLeft,
        height - cell.offsetTop - cell.offsetHeight,
        cell.offsetWidth,
        cell.offsetHeight - named,
      ];
      renderer.setViewport(...place);
      renderer.setScissor(...place);
      view.light.position.copy(TOWARDS_LIGHT).applyQuaternion(eye.camera.quaternion);
      const above = eye.camera.position.z > view.floor.position.z;
      view.floor.material.opacity = above ? GRID : GRID_FROM_BELOW;
      view.shape.shadow.visible = above;
      view.shape.sort(eye.camera.position);
      view.gravity?.follow(eye.camera, eye.controls.target);
      renderer.render(view.scene, eye.camera);
    }
    eye.aim();
    for (const listener of drawn) listener();
  }

  function paint() {
    for (const view of views) {
      view.floor.material.color.set(styleColour("--floor"));
      view.shape.paint();
      view.gravity?.paint();
    }
    invalidate();
  }

  function resize() {
    const [width, height] = [element.clientWidth, element.clientHeight];
    if (!width || !height) return;
    renderer.setPixelRatio(Math.min(devicePixelRatio, 2, LONGEST / Math.max(width, height)));
    renderer.setSize(width, height, false);
    const pictured = cells[0].offsetHeight - names();
    eye.resize(cells[0].offsetWidth / pictured, height / pictured);
    draw();
  }

  /** Draw with a number of pixels across, use the picture, and draw as before. */
  function drawSharp(across, use) {
    const ratio = Math.min(across / element.clientWidth, LONGEST / Math.max(element.clientWidth, element.clientHeight));
    renderer.setPixelRatio(ratio);
    renderer.setSize(element.clientWidth, element.clientHeight, false);
    draw();
    const used = use();
    resize();
    return used;
  }

  const watch = new ResizeObserver(resize);
  watch.observe(element);
  const stop = clock.onChange(() => {
    posed = false;
    draw();
  });
  const stopPainting = onSchemeChange(paint);
  listen("webglcontextrestored", invalidate);
  paint();

  /** Listen to events of the canvas as long as it shows this stage. */
  function listen(type, listener, capture = false) {
    canvas.addEventListener(type, listener, { capture, signal: ended.signal });
  }

  function dispose() {
    cancelAnimationFrame(waiting);
    ended.abort();
    stop();
    stopPainting();
    watch.disconnect();
    eye.dispose();
    for (const { shape, floor, gravity } of views) {
      shape.dispose();
      gravity?.dispose();
      floor.geometry.dispose();
    }
    leaveRenderer(taken);
    element.remove();
  }

  /** Colour sheets by "strain" or "stress", all up to one value, or with null by their regions; returns that value. */
  function colourSheets(quantity) {
    const largest = quantity ? views.reduce((most, { shape }) => Math.max(most, shape.strains?.largest(quantity) ?? 0), 0) : 0;
    for (const { shape } of views) shape.colourSheets?.(quantity, largest || Number.MIN_VALUE);
    invalidate();
    return largest;
  }

  /** What was drawn, and what the renderer keeps in the memory of the graphics chip. */
  const statistics = () => ({ ...renderer.info.render, ...renderer.info.memory, programs: renderer.info.programs?.length ?? 0 });

  const note = webgl ? null : make("p", { className: "note" }, WITHOUT_WEBGL);
  return { element, note, canvas, cells, eye, pose, draw, drawSharp, paint, views, colourSheets, listen, onDraw: (listener) => drawn.add(listener), statistics, dispose };
}

const WITHOUT_WEBGL = "This browser has no WebGL: the processor draws the picture, without shadows and more slowly.";
const HELP = "Drag to turn, pinch to zoom; keys are listed below.";

/** A scene for every structure; all are seen by one camera. */
function makeView(clip, shape, eye) {
  const floor = makeFloor(eye.size, eye.target);
  // the grid is a level table, if there is one
  floor.position.z = clip.mesh.table_m ?? lowest(clip) - 0.06 * eye.size;
  shape.shadow.position.z = floor.position.z + 1e-3 * eye.size;
  const light = new DirectionalLight("#ffffff", LIGHT);
  const scene = new Scene();
  scene.add(shape.group, shape.shadow, floor, light, new HemisphereLight("#ffffff", "#dde2e8", SKY));
  const gravity = clip.mesh.gravity && makeGravity(clip.mesh.gravity);
  if (gravity) scene.add(gravity.group);
  return { shape, floor, light, scene, gravity };
}

function lowest(clip) {
  let least = Infinity;
  const step = Math.max(1, Math.floor(clip.time.length / 200));
  for (let frame = 0; frame < clip.time.length; frame += step) {
    const points = clip.pointsAt(clip.time[frame]);
    for (let at = 2; at < points.length; at += 3) least = Math.min(least, points[at]);
  }
  return least;
}
