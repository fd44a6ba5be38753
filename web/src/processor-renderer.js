/**
 * Replacement of the WebGL renderer where the browser has none: the processor draws a scene's triangles and lines with a
 * depth for each pixel, on a canvas in two dimensions. Translucent faces are opaque, and there are no shadows.
 */

import { Color, Matrix3, Matrix4, Vector3, Vector4 } from "three";

const SAMPLES = 2; // samples of a pixel in either direction
const UNDERSIDE = 0.84; // brightness of a face seen from behind
const ENCODED = 1024; // steps of the table from linear to sRGB

const encoded = Uint8Array.from({ length: ENCODED + 1 }, (_, step) => {
  const share = step / ENCODED;
  return Math.round(255 * (share <= 0.0031308 ? 12.92 * share : 1.055 * share ** (1 / 2.4) - 0.055));
});
const toScreen = (share) => encoded[Math.min(ENCODED, Math.max(0, Math.round(ENCODED * share)))];

/** A renderer with the methods that a stage uses. */
export function makeProcessorRenderer(canvas) {
  const context = canvas.getContext("2d");
  const scratch = document.createElement("canvas");
  const render = { frame: 0, calls: 0, triangles: 0 };
  let ratio = 1;
  let view = [0, 0, 1, 1];

  return {
    info: { render },
    setPixelRatio(value) {
      ratio = value;
    },
    setSize(width, height) {
      [canvas.width, canvas.height] = [Math.floor(width * ratio), Math.floor(height * ratio)];
    },
    setScissorTest() {},
    setScissor() {},
    /** x, y of the lower left corner and size, in pixels of the page. */
    setViewport(...place) {
      view = place.map((value) => value * ratio);
    },
    clear() {
      render.frame += 1;
      context.clearRect(0, 0, canvas.width, canvas.height);
    },
    render(scene, camera) {
      const [width, height] = [Math.round(view[2] * SAMPLES), Math.round(view[3] * SAMPLES)];
      if (width < 1 || height < 1) return;
      const picture = drawScene(scene, camera, width, height);
      [scratch.width, scratch.height] = [width, height];
      scratch.getContext("2d").putImageData(picture, 0, 0);
      context.drawImage(scratch, view[0], canvas.height - view[1] - view[3], view[2], view[3]);
    },
    dispose() {},
    forceContextLoss() {},
  };
}

function drawScene(scene, camera, width, height) {
  const picture = new ImageData(width, height);
  const target = { width, height, colours: new Uint32Array(picture.data.buffer), depths: new Float32Array(width * height).fill(Infinity) };
  scene.updateMatrixWorld();
  camera.updateMatrixWorld();
  const lights = lightsOf(scene);
  const projection = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
  const drawn = [];
  scene.traverseVisible((object) => {
    // this renderer draws no shadows, because a shadow darkens the faces behind it
    if (object.geometry && !materialsOf(object)[0].stencilWrite) drawn.push(object);
  });
  for (const object of drawn.filter((each) => each.isLineSegments)) drawLines(object, projection, target);
  const eye = { projection, view: camera.matrixWorldInverse, perspective: camera.projectionMatrix, position: camera.position };
  for (const object of drawn.filter((each) => each.isMesh)) drawMesh(object, eye, lights, target);
  return picture;
}

const materialsOf = ({ material }) => (Array.isArray(material) ? material : [material]);

/** The lights of a scene: a direction with its colour, and a sky above with a ground below. */
function lightsOf(scene) {
  const lights = { towards: new Vector3(0, 0, 1), sun: new Color(0), sky: new Color(0), ground: new Color(0) };
  scene.traverse((object) => {
    if (object.isDirectionalLight) {
      lights.towards.copy(object.position).normalize();
      lights.sun.copy(object.color).multiplyScalar(object.intensity / Math.PI);
    }
    if (object.isHemisphereLight) {
      lights.sky.copy(object.color).multiplyScalar(object.intensity / Math.PI);
      lights.ground.copy(object.groundColor).multiplyScalar(object.intensity / Math.PI);
    }
  });
  return lights;
}

/** Screen colours of a surface with a normal, linear colour and, for a chosen part, a glow. */
function shade(normal, colour, material, lights, into) {
  if (material.isMeshBasicMaterial) {
    for (let part = 0; part < 3; part++) into[part] = toScreen(colour[part]);
    return;
  }
  const sun = Math.max(0, normal.dot(lights.towards));
  const above = 0.5 * normal.y + 0.5; // the sky of three.js is towards y
  const glow = material.emissive && material.emissiveIntensity ? material.emissive.toArray().map((part) => part * material.emissiveIntensity) : null;
  const [sunColour, sky, ground] = [lights.sun, lights.sky, lights.ground].map((light) => [light.r, light.g, light.b]);
  for (let part = 0; part < 3; part++) into[part] = toScreen(colour[part] * (sun * sunColour[part] + above * sky[part] + (1 - above) * ground[part]) + (glow?.[part] ?? 0));
}

function drawMesh(object, eye, lights, target) {
  const { geometry } = object;
  const materials = materialsOf(object);
  const whole = { start: 0, count: geometry.index?.count ?? geometry.attributes.position.count, materialIndex: 0 };
  const groups = Array.isArray(object.material) ? geometry.groups : [whole];
  const copies = object.isInstancedMesh ? object.count : 1;
  const [model, placement, tint] = [new Matrix4(), new Matrix4(), new Color()];
  for (let copy = 0; copy < copies; copy++) {
    model.copy(object.matrixWorld);
    tint.set(1, 1, 1);
    if (object.isInstancedMesh) {
      object.getMatrixAt(copy, placement);
      model.multiply(placement);
      if (object.instanceColor) object.getColorAt(copy, tint);
    }
    for (const group of groups) drawGroup(geometry, group, model, materials[group.materialIndex], tint, eye, lights, target);
  }
}

function drawGroup(geometry, { start, count }, model, material, tint, eye, lights, target) {
  const { position, normal, color } = geometry.attributes;
  const smooth = normal && !material.flatShading;
  const base = [material.color.r * tint.r, material.color.g * tint.g, material.color.b * tint.b];
  const turned = new Matrix3().getNormalMatrix(model);
  const nearer = material.userData.nearer ?? 0;
  const corners = new Map();
  const screen = new Vector4();
  const world = new Vector3();

  /** A corner on the screen with its depth, its position and its normal. */
  function cornerAt(index) {
    if (corners.has(index)) return corners.get(index);
    world.fromBufferAttribute(position, index).applyMatrix4(model);
    const place = world.clone();
    screen.set(world.x, world.y, world.z, 1).applyMatrix4(eye.projection);
    const corner = { place, x: ((screen.x / screen.w + 1) / 2) * target.width, y: ((1 - screen.y / screen.w) / 2) * target.height, depth: screen.z / screen.w, behind: screen.w <= 0, normal: smooth ? new Vector3().fromBufferAttribute(normal, index).applyMatrix3(turned).normalize() : null };
    if (nearer) {
      world.applyMatrix4(eye.view);
      world.addScaledVector(world.clone().normalize(), -nearer);
      screen.set(world.x, world.y, world.z, 1).applyMatrix4(eye.perspective);
      corner.depth = screen.z / screen.w;
    }
    corners.set(index, corner);
    return corner;
  }

  const [side, other, across, towards] = [new Vector3(), new Vector3(), new Vector3(), new Vector3()];
  const colour = [0, 0, 0];
  const shades = [[0, 0, 0], [0, 0, 0], [0, 0, 0]];
  for (let at = start; at + 2 < start + count; at += 3) {
    const indices = [0, 1, 2].map((corner) => (geometry.index ? geometry.index.getX(at + corner) : at + corner));
    const three = indices.map(cornerAt);
    if (three.some((corner) => corner.behind)) continue;
    side.subVectors(three[1].place, three[0].place);
    other.subVectors(three[2].place, three[0].place);
    across.crossVectors(side, other).normalize();
    towards.subVectors(eye.position, three[0].place);
    const back = across.dot(towards) < 0;
    if (back) across.negate();
    for (let corner = 0; corner < 3; corner++) {
      const index = indices[corner];
      for (let part = 0; part < 3; part++) colour[part] = base[part] * (color ? color.getComponent(index, part) : 1) * (back && color && !material.isMeshBasicMaterial ? UNDERSIDE : 1);
      shade(smooth ? three[corner].normal : across, colour, material, lights, shades[corner]);
    }
    fill(three, shades, target);
  }
}

/** Fill a triangle, whose colours vary linearly on the screen. */
function fill([first, second, third], shades, { width, height, colours, depths }) {
  const area = (second.x - first.x) * (third.y - first.y) - (second.y - first.y) * (third.x - first.x);
  if (Math.abs(area) < 1e-9) return;
  const [left, right] = [Math.max(0, Math.floor(Math.min(first.x, second.x, third.x))), Math.min(width - 1, Math.ceil(Math.max(first.x, second.x, third.x)))];
  const [top, bottom] = [Math.max(0, Math.floor(Math.min(first.y, second.y, third.y))), Math.min(height - 1, Math.ceil(Math.max(first.y, second.y, third.y)))];
  const [one, two, three] = shades;
  const even = one.every((part, at) => part === two[at] && part === three[at]);
  const single = 0xff000000 | (one[2] << 16) | (one[1] << 8) | one[0];
  const [stepB, stepC] = [(third.y - first.y) / area, (first.y - second.y) / area];
  for (let y = top; y <= bottom; y++) {
    const [dx, dy] = [left + 0.5 - first.x, y + 0.5 - first.y];
    let b = (dx * (third.y - first.y) - dy * (third.x - first.x)) / area;
    let c = (dy * (second.x - first.x) - dx * (second.y - first.y)) / area;
    let at = y * width + left;
    for (let x = left; x <= right; x++, at++, b += stepB, c += stepC) {
      const a = 1 - b - c;
      if (a < 0 || b < 0 || c < 0) continue;
      const depth = a * first.depth + b * second.depth + c * third.depth;
      if (depth >= depths[at]) continue;
      depths[at] = depth;
      colours[at] = even
        ? single
        : 0xff000000 | ((a * one[2] + b * two[2] + c * three[2]) << 16) | ((a * one[1] + b * two[1] + c * three[1]) << 8) | (a * one[0] + b * two[0] + c * three[0]);
    }
  }
}

/** Draw lines under everything that is filled later: they have no depth. */
function drawLines(object, projection, { width, height, colours }) {
  const { position } = object.geometry.attributes;
  const [material] = materialsOf(object);
  const [red, green, blue] = [material.color.r, material.color.g, material.color.b].map(toScreen);
  const word = (Math.round(255 * material.opacity) << 24) | (blue << 16) | (green << 8) | red;
  const ends = [0, 1].map(() => new Vector4());
  for (let at = 0; at + 1 < position.count; at += 2) {
    for (const [index, end] of ends.entries()) {
      end.set(position.getX(at + index), position.getY(at + index), position.getZ(at + index), 1).applyMatrix4(object.matrixWorld).applyMatrix4(projection);
    }
    if (ends.some((end) => end.w <= 0)) continue;
    const [from, to] = ends.map((end) => [((end.x / end.w + 1) / 2) * width, ((1 - end.y / end.w) / 2) * height]);
    const steps = Math.min(20_000, Math.ceil(Math.max(Math.abs(to[0] - from[0]), Math.abs(to[1] - from[1]))));
    for (let step = 0; step <= steps; step++) {
      const [x, y] = [0, 1].map((axis) => Math.floor(from[axis] + (step / (steps || 1)) * (to[axis] - from[axis])));
      if (x >= 0 && x < width && y >= 0 && y < height) colours[y * width + x] = word;
    }
  }
}
