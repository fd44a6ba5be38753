/** The drawn structure: sheets and plates, and round bars for bars, creases and tendons. */

import {
  BufferAttribute,
  BufferGeometry,
  Color,
  CylinderGeometry,
  DoubleSide,
  DynamicDrawUsage,
  Group,
  InstancedMesh,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  NotEqualStencilFunc,
  ReplaceStencilOp,
  SphereGeometry,
} from "three";
import { barMaterial, placeTube } from "./bars.js";
import { TENDONS } from "./clip.js";
import { makeEfforts } from "./efforts.js";
import { ENERGY_COLOURS, MOUNTAIN, STRAIN_COLOURS, VALLEY, barTint, regionTint, styleColour } from "./scheme.js";
import { sag } from "./slack.js";
import { makeStrains } from "./strain.js";

const OPACITY = 0.9;
const SLACK = 0.4; // radius of a slack tendon, as a share of a taut one's
const TAUT = 0.02; // share of the largest energy from which a tendon has its full thickness
const LINES = ["crease", "rim", "edge"];
const PIECES = 12; // pieces of a tendon, which sags when slack

/** The structure of a clip; `pose` moves it, `sort` prepares it for a camera. */
export function makeShape(clip, largestEnergy) {
  const { mesh } = clip;
  const vertices = new Float32Array(3 * mesh.share.length);
  const energies = new Float32Array(clip.tendons);
  const thickest = Math.max(0, ...mesh.tubes.map((tube) => tube.radius));
  const [sheet, plates] = [false, true].map((solid) => makeFaces(mesh, solid));
  const bars = makeTubes(
    mesh.tubes.filter((tube) => tube.kind === "bar"),
    20,
    0,
  );
  // lines on sheets and tendons within bars would be hidden, so they are drawn slightly nearer
  const lines = makeTubes(
    mesh.tubes.filter((tube) => LINES.includes(tube.kind)),
    8,
    0.4 * thickest,
  );
  const tendons = makeTendons(clip, 2.4 * thickest);
  const base = makeBase(mesh.base);
  const efforts = clip.efforts ? makeEfforts(clip) : null;
  const strains = clip.strained ? makeStrains(clip) : null;
  let scale = null; // quantity of the sheet's colours, and its largest value; null: colours of the regions
  const joints = makeJoints(mesh);
  const group = new Group();
  group.add(base.object, plates.object, bars.object, joints.object, lines.object, tendons.object, sheet.object);
  // shaders are compiled for everything visible, even without triangles
  for (const part of [bars, joints, lines, tendons]) part.object.visible = part.object.count > 0;
  if (efforts) group.add(efforts.group);
  const shadow = makeShadow(sheet.object, plates.object, bars.object);
  const colour = [0, 0, 0];
  const shade = new Color();

  function pose(moment) {
    clip.verticesAt(moment, vertices);
    sheet.pose(vertices);
    plates.pose(vertices);
    for (const part of [bars, lines, joints]) part.pose(vertices);
    clip.valuesAt(TENDONS, moment, energies);
    const shares = energies.map((energy) => (largestEnergy > 0 ? energy / largestEnergy : 0));
    tendons.pose(vertices, moment, (tendon) => SLACK + (1 - SLACK) * Math.min(1, Math.max(0, shares[tendon]) / TAUT));
    for (let tendon = 0; tendon < clip.tendons; tendon++) {
      ENERGY_COLOURS.at(shares[tendon], colour);
      tendons.colour(tendon, shade.setRGB(...colour, "srgb"));
    }
    if (clip.tendons) tendons.object.instanceColor.needsUpdate = true;
    efforts?.pose(moment);
    if (scale) colourStrains();
  }

  function colourStrains() {
    const strained = strains.at(vertices, scale.quantity);
    const into = [0, 0, 0];
    for (const faces of [sheet, plates])
      faces.colour((triangle) => shade.setRGB(...STRAIN_COLOURS.at(strained[triangle] / scale.largest, into), "srgb"));
  }

  /** Colour faces by a quantity up to a largest value, or, with null, by their regions. */
  function colourSheets(quantity, largest) {
    scale = strains && quantity ? { quantity, largest } : null;
    for (const faces of [sheet, plates]) {
      faces.flat(scale !== null);
      if (!scale) faces.colour((triangle) => shade.set(regionTint(mesh.regions[triangle])));
    }
    if (scale) colourStrains();
  }

  /** Update the colours that depend on the light or dark scheme. */
  function paint() {
    for (const part of [bars, lines, joints, base]) part.paint();
    efforts?.paint();
    shadow.children[0].material.color.set(styleColour("--shadow"));
  }

  function dispose() {
    for (const part of [bars, lines, tendons, joints]) part.object.dispose();
    for (const faces of [sheet, plates]) faces.dispose();
    efforts?.dispose();
    base.dispose();
    for (const part of [bars, lines, tendons, joints]) part.object.geometry.dispose();
  }

  return { group, shadow, pose, paint, sort: sheet.sort, vertices, tendons: tendons.object, efforts, strains, colourSheets, dispose };
}

/** Vertical shadow of faces and bars in one plane, in which every position is darkened once. */
function makeShadow(...objects) {
  const material = new MeshBasicMaterial({
    side: DoubleSide,
    transparent: true,
    opacity: 0.12,
    depthWrite: false,
    stencilWrite: true,
    stencilRef: 1,
    stencilFunc: NotEqualStencilFunc,
    stencilZPass: ReplaceStencilOp,
  });
  const shadow = new Group();
  for (const object of objects) {
    const thrown = object.isInstancedMesh
      ? new InstancedMesh(object.geometry, material, object.count)
      : new Mesh(object.geometry, material);
    if (object.isInstancedMesh) thrown.instanceMatrix = object.instanceMatrix;
    thrown.frustumCulled = false;
    thrown.visible = object.visible;
    shadow.add(thrown);
  }
  shadow.scale.z = 1e-5;
  return shadow;
}

/** Sheets, slightly translucent, or plates: flat triangles, a tint for each region, their undersides darker. */
function makeFaces(mesh, solid) {
  const chosen = mesh.regions.flatMap((region, triangle) => (mesh.solid[region] === solid ? [triangle] : []));
  const corners = chosen.flatMap((triangle) => mesh.triangles.slice(3 * triangle, 3 * triangle + 3));
  const count = chosen.length;
  const positions = new BufferAttribute(new Float32Array(3 * corners.length), 3).setUsage(DynamicDrawUsage);
  const colours = new BufferAttribute(new Float32Array(3 * corners.length), 3).setUsage(DynamicDrawUsage);
  const order = new BufferAttribute(new Uint32Array(corners.length), 1).setUsage(DynamicDrawUsage);
  for (let corner = 0; corner < corners.length; corner++) order.array[corner] = corner;
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", positions);
  geometry.setAttribute("color", colours);
  geometry.setIndex(order);
  const material = new MeshLambertMaterial({
    vertexColors: true,
    side: DoubleSide,
    flatShading: true,
    transparent: !solid,
    opacity: solid ? 1 : OPACITY,
    depthWrite: solid,
    forceSinglePass: true,
  });
  material.onBeforeCompile = (shader) => {
    shader.fragmentShader = shader.fragmentShader.replace(
      "#include <color_fragment>",
      "#include <color_fragment>\nif (!gl_FrontFacing) diffuseColor.rgb *= 0.84;",
    );
  };
  // colours that are read from a scale are independent of the light
  const unlit = new MeshBasicMaterial({ vertexColors: true, side: DoubleSide });
  const object = new Mesh(geometry, material);
  object.visible = count > 0;
  object.frustumCulled = false;
  object.renderOrder = solid ? 0 : 1;
  const shade = new Color();
  colour((triangle) => shade.set(regionTint(mesh.regions[triangle])));

  /** Colour the faces by a function of the triangle's index in the mesh. */
  function colour(shadeOf) {
    for (const [at, triangle] of chosen.entries()) {
      const tone = shadeOf(triangle);
      for (let corner = 0; corner < 3; corner++) tone.toArray(colours.array, 9 * at + 3 * corner);
    }
    colours.needsUpdate = true;
  }

  const flat = (wanted) => {
    object.material = wanted ? unlit : material;
  };

  const dispose = () => geometry.dispose();

  function pose(vertices) {
    for (let corner = 0; corner < corners.length; corner++) {
      for (let axis = 0; axis < 3; axis++) positions.array[3 * corner + axis] = vertices[3 * corners[corner] + axis];
    }
    positions.needsUpdate = true;
  }

  const depths = new Float32Array(count);
  const ranks = Array.from({ length: count }, (_, triangle) => triangle);

  /** Sort the triangles, the furthest first: each is visible through those in front of it. */
  function sort(eye) {
    const place = positions.array;
    for (let triangle = 0; triangle < count; triangle++) {
      let depth = 0;
      for (let axis = 0; axis < 3; axis++) {
        const at = 9 * triangle + axis;
        depth += ((place[at] + place[at + 3] + place[at + 6]) / 3 - eye.getComponent(axis)) ** 2;
      }
      depths[triangle] = depth;
    }
    ranks.sort((first, second) => depths[second] - depths[first]);
    for (let rank = 0; rank < count; rank++) {
      for (let corner = 0; corner < 3; corner++) order.array[3 * rank + corner] = 3 * ranks[rank] + corner;
    }
    order.needsUpdate = true;
  }

  return { object, pose, sort, colour, flat, dispose };
}

function makeTubes(tubes, sides, nearer) {
  const object = new InstancedMesh(new CylinderGeometry(1, 1, 1, sides), barMaterial(nearer), tubes.length);
  object.frustumCulled = false;
  paint();
  const ends = tubes.map((tube) => [3 * tube.ends[0], 3 * tube.ends[1], tube.radius]);

  function pose(vertices, thickness = () => 1) {
    const matrix = object.instanceMatrix.array;
    for (const [index, [first, second, radius]] of ends.entries())
      placeTube(vertices, first, second, thickness(index) * radius, matrix, 16 * index);
    object.instanceMatrix.needsUpdate = true;
  }

  function paint() {
    const colours = { M: new Color(MOUNTAIN), V: new Color(VALLEY), B: new Color(styleColour("--bar")) };
    for (const [index, { crease, region }] of tubes.entries())
      object.setColorAt(index, region === undefined ? colours[crease] : new Color(barTint(region)));
    if (tubes.length) object.instanceColor.needsUpdate = true;
  }

  return { object, pose, paint };
}

/** Tendons in pieces: straight if taut, sagging with their rest length if slack. */
function makeTendons(clip, nearer) {
  const tubes = clip.mesh.tubes.filter((tube) => tube.kind === "tendon");
  const object = new InstancedMesh(new CylinderGeometry(1, 1, 1, 12), barMaterial(nearer), tubes.length * PIECES);
  object.frustumCulled = false;
  const rests = new Float32Array(tubes.length);
  const places = new Float32Array(3 * (PIECES + 1));

  function pose(vertices, moment, thickness) {
    clip.restLengthsAt(moment, rests);
    const matrix = object.instanceMatrix.array;
    for (const [tendon, { ends, radius }] of tubes.entries()) {
      bend(vertices, 3 * ends[0], 3 * ends[1], rests[tendon], places);
      for (let piece = 0; piece < PIECES; piece++)
        placeTube(places, 3 * piece, 3 * piece + 3, thickness(tendon) * radius, matrix, 16 * (tendon * PIECES + piece));
    }
    object.instanceMatrix.needsUpdate = true;
  }

  function colour(tendon, shade) {
    for (let piece = 0; piece < PIECES; piece++) object.setColorAt(tendon * PIECES + piece, shade);
  }

  return { object, pose, colour };
}

/** Write points along a tendon; a slack one sags downwards, perpendicular to the line between its ends. */
function bend(vertices, first, second, rest, places) {
  const way = [0, 1, 2].map((axis) => vertices[second + axis] - vertices[first + axis]);
  const span = Math.hypot(...way);
  const depth = sag(span, rest);
  // a vertical one may sag to any side
  const side = Math.abs(way[2]) > 0.999 * span ? [1, 0, 0] : [0, 0, -1];
  const along = side.reduce((sum, part, axis) => sum + part * way[axis], 0) / (span * span || 1);
  const down = side.map((part, axis) => part - along * way[axis]);
  const size = Math.hypot(...down) || 1;
  for (let place = 0; place <= PIECES; place++) {
    const share = place / PIECES;
    const low = (4 * depth * share * (1 - share)) / size;
    for (let axis = 0; axis < 3; axis++) places[3 * place + axis] = vertices[first + axis] + share * way[axis] + low * down[axis];
  }
}

/** Rods along fixed parts, with round ends. */
function makeBase({ rods, radius }) {
  const ends = new Float32Array(rods.flat(2));
  const material = barMaterial(0);
  const bars = new InstancedMesh(new CylinderGeometry(1, 1, 1, 16), material, rods.length);
  const knobs = new InstancedMesh(new SphereGeometry(1, 16, 12), material, 2 * rods.length);
  const object = new Group();
  object.visible = rods.length > 0;
  for (const part of [bars, knobs]) {
    part.frustumCulled = false;
    object.add(part);
  }
  for (let rod = 0; rod < rods.length; rod++)
    placeTube(ends, 6 * rod, 6 * rod + 3, radius, bars.instanceMatrix.array, 16 * rod);
  for (let end = 0; end < 2 * rods.length; end++) {
    const matrix = knobs.instanceMatrix.array;
    for (let axis = 0; axis < 3; axis++) [matrix[16 * end + 5 * axis], matrix[16 * end + 12 + axis]] = [radius, ends[3 * end + axis]];
    matrix[16 * end + 15] = 1;
  }

  function dispose() {
    for (const part of [bars, knobs]) {
      part.dispose();
      part.geometry.dispose();
    }
  }

  return { object, paint: () => material.color.set(styleColour("--base")), dispose };
}

function makeJoints(mesh) {
  const object = new InstancedMesh(new SphereGeometry(1, 16, 12), barMaterial(0), mesh.joints.length);
  object.frustumCulled = false;
  const paint = () => object.material.color.set(styleColour("--joint"));
  paint();

  function pose(vertices) {
    const matrix = object.instanceMatrix.array;
    for (const [index, vertex] of mesh.joints.entries()) {
      for (let axis = 0; axis < 3; axis++) {
        matrix[16 * index + 5 * axis] = mesh.jointRadius;
        matrix[16 * index + 12 + axis] = vertices[3 * vertex + axis];
      }
      matrix[16 * index + 15] = 1;
    }
    object.instanceMatrix.needsUpdate = true;
  }

  return { object, pose, paint };
}
