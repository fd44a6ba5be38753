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
import { TENDONS } from "./clip.js";
import { ENERGY_COLOURS, MOUNTAIN, VALLEY, regionTint, styleColour } from "./scheme.js";

const OPACITY = 0.9;
const SLACK = 0.4; // radius of a tendon that holds nothing, by that of one that does
const TAUT = 0.02; // share of the largest energy from which on a tendon is as thick as any
const LINES = ["crease", "rim", "edge"];

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
  // lines on sheets and tendons within bars would be hidden: they are drawn as if a little nearer
  const lines = makeTubes(
    mesh.tubes.filter((tube) => LINES.includes(tube.kind)),
    8,
    0.4 * thickest,
  );
  const tendons = makeTubes(
    mesh.tubes.filter((tube) => tube.kind === "tendon"),
    12,
    2.4 * thickest,
  );
  const joints = makeJoints(mesh);
  const group = new Group();
  group.add(plates.object, bars.object, joints.object, lines.object, tendons.object, sheet.object);
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
    tendons.pose(vertices, (tendon) => SLACK + (1 - SLACK) * Math.min(1, Math.max(0, shares[tendon]) / TAUT));
    for (let tendon = 0; tendon < clip.tendons; tendon++) {
      ENERGY_COLOURS.at(shares[tendon], colour);
      tendons.object.setColorAt(tendon, shade.setRGB(...colour, "srgb"));
    }
    if (clip.tendons) tendons.object.instanceColor.needsUpdate = true;
  }

  /** Take the colours that depend on whether the page is light or dark. */
  function paint() {
    for (const part of [bars, lines, joints]) part.paint();
    shadow.children[0].material.color.set(styleColour("--shadow"));
  }

  function dispose() {
    for (const part of [bars, lines, tendons, joints]) part.object.dispose();
    for (const part of [sheet, plates, bars, lines, tendons, joints]) {
      part.object.geometry.dispose();
      part.object.material.dispose();
    }
    shadow.children[0].material.dispose();
  }

  return { group, shadow, pose, paint, sort: sheet.sort, vertices, dispose };
}

/** What faces and bars throw straight down: all of it in one plane, each place of it darkened once. */
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
    shadow.add(thrown);
  }
  shadow.scale.z = 1e-5;
  return shadow;
}

/** Sheets, a little translucent, or plates: flat triangles, a tint for each region, their undersides darker. */
function makeFaces(mesh, solid) {
  const chosen = mesh.regions.flatMap((region, triangle) => (mesh.solid[region] === solid ? [triangle] : []));
  const corners = chosen.flatMap((triangle) => mesh.triangles.slice(3 * triangle, 3 * triangle + 3));
  const count = chosen.length;
  const positions = new BufferAttribute(new Float32Array(3 * corners.length), 3).setUsage(DynamicDrawUsage);
  const colours = new Float32Array(3 * corners.length);
  for (let corner = 0; corner < corners.length; corner++)
    new Color(regionTint(mesh.regions[chosen[Math.floor(corner / 3)]])).toArray(colours, 3 * corner);
  const order = new BufferAttribute(new Uint32Array(corners.length), 1).setUsage(DynamicDrawUsage);
  for (let corner = 0; corner < corners.length; corner++) order.array[corner] = corner;
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", positions);
  geometry.setAttribute("color", new BufferAttribute(colours, 3));
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
  const object = new Mesh(geometry, material);
  object.frustumCulled = false;
  object.renderOrder = solid ? 0 : 1;

  function pose(vertices) {
    for (let corner = 0; corner < corners.length; corner++) {
      for (let axis = 0; axis < 3; axis++) positions.array[3 * corner + axis] = vertices[3 * corners[corner] + axis];
    }
    positions.needsUpdate = true;
  }

  const depths = new Float32Array(count);
  const ranks = Array.from({ length: count }, (_, triangle) => triangle);

  /** Put the triangles in order, the furthest first: each shows through those before it. */
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

  return { object, pose, sort };
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
    for (const [index, tube] of tubes.entries()) object.setColorAt(index, colours[tube.crease]);
    if (tubes.length) object.instanceColor.needsUpdate = true;
  }

  return { object, pose, paint };
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

/** A material of things that are drawn where they are, but in front of what is less than so much nearer, m. */
function barMaterial(nearer) {
  const material = new MeshLambertMaterial();
  if (nearer === 0) return material;
  material.onBeforeCompile = (shader) => {
    shader.vertexShader = shader.vertexShader.replace(
      "#include <project_vertex>",
      `#include <project_vertex>
      vec4 pulled = vec4(mvPosition.xyz - normalize(mvPosition.xyz) * ${nearer.toExponential()}, 1.0);
      vec4 there = projectionMatrix * pulled;
      gl_Position.z = there.z / there.w * gl_Position.w;`,
    );
  };
  material.customProgramCacheKey = () => `nearer ${nearer}`;
  return material;
}

/** Write the matrix that takes a bar of radius and length 1 along y to one between two vertices. */
function placeTube(vertices, first, second, radius, matrix, at) {
  let x = vertices[second] - vertices[first];
  let y = vertices[second + 1] - vertices[first + 1];
  let z = vertices[second + 2] - vertices[first + 2];
  const length = Math.hypot(x, y, z) || 1e-12;
  x /= length;
  y /= length;
  z /= length;
  // any direction across will do: the bar is round
  const flat = Math.abs(z) < 0.9;
  let [acrossX, acrossY, acrossZ] = flat ? [y, -x, 0] : [0, z, -y];
  const size = Math.hypot(acrossX, acrossY, acrossZ);
  acrossX /= size;
  acrossY /= size;
  acrossZ /= size;
  matrix[at] = radius * acrossX;
  matrix[at + 1] = radius * acrossY;
  matrix[at + 2] = radius * acrossZ;
  matrix[at + 4] = length * x;
  matrix[at + 5] = length * y;
  matrix[at + 6] = length * z;
  matrix[at + 8] = radius * (acrossY * z - acrossZ * y);
  matrix[at + 9] = radius * (acrossZ * x - acrossX * z);
  matrix[at + 10] = radius * (acrossX * y - acrossY * x);
  for (let axis = 0; axis < 3; axis++) matrix[at + 12 + axis] = (vertices[first + axis] + vertices[second + axis]) / 2;
  matrix[at + 15] = 1;
}
