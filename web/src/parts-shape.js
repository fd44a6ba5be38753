/** Parts as shaded solids with edges between their faces; faces of stops have a colour of their own. */

import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DoubleSide,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshLambertMaterial,
  Raycaster,
} from "three";
import { styleColour } from "./scheme.js";

const EDGE = "#14171a";
const EDGE_OPACITY = 0.55;
const SMOOTH = Math.cos(Math.PI / 9); // faces at a smaller angle are drawn as one round face
const GLOW = 0.42; // brightness added to the selected part

/**
 * The parts of a model. state: {apart, side, hidden, chosen} for `pose`; anglesAt: returns the angles of all hinges at a
 * moment.
 */
export function makePartsShape(model, state, anglesAt, stopColour) {
  const made = model.parts.map((part) => makePart(part, model.looks[part.look].colour, stopColour));
  const group = new Group();
  for (const each of made) group.add(each.mesh, each.lines);
  // the floor is below every position, too far for shadows to show where parts are
  const shadow = new Group();
  let poses = model.turn(model.anglesTogether(0));

  function pose(moment) {
    poses = model.turn(anglesAt(moment));
    for (const [index, part] of model.parts.entries()) {
      const { mesh, lines } = made[index];
      const seen = !state.hidden.has(part.look);
      for (const object of [mesh, lines]) object.visible = seen;
      if (!seen) continue;
      if (part.places) model.matrixOf(part, poses, state.apart, mesh.matrix);
      else bend(made[index], model.bentMesh(part, poses, state));
    }
  }

  function paint() {
    const accent = new Color(styleColour("--accent"));
    for (const [index, { mesh }] of made.entries())
      for (const material of [mesh.material].flat()) {
        material.emissive.copy(accent);
        material.emissiveIntensity = state.chosen === index ? GLOW : 0;
      }
  }

  /** Index of the part at a position of the picture, -1 to 1 in both directions; null for none. */
  function at(place, camera) {
    const ray = new Raycaster();
    ray.setFromCamera(place, camera);
    group.updateMatrixWorld(true);
    for (const { mesh } of made) if (mesh.geometry.boundingSphere === null) mesh.geometry.computeBoundingSphere();
    const [hit] = ray.intersectObjects(
      made.map((each) => each.mesh).filter((mesh) => mesh.visible),
      false,
    );
    return hit ? made.findIndex((each) => each.mesh === hit.object) : null;
  }

  /** Present positions of a part's vertices, m, (vertex, 3). */
  function verticesOf(name) {
    const index = model.parts.findIndex((part) => part.name === name);
    const { mesh } = made[index];
    const place = mesh.geometry.getAttribute("position");
    const found = new BufferAttribute(place.array.slice(), 3);
    return Array.from(found.applyMatrix4(mesh.matrix).array);
  }

  function dispose() {
    for (const { mesh, lines } of made) {
      mesh.geometry.dispose();
      lines.geometry.dispose();
    }
  }

  return { group, shadow, pose, paint, sort: () => {}, at, verticesOf, dispose, current: () => poses };
}

function makePart(part, colour, stopColour) {
  const look = (tint, bends) =>
    new MeshLambertMaterial({
      color: tint,
      side: DoubleSide,
      flatShading: bends,
      // so that edges lie on the faces
      polygonOffset: true,
      polygonOffsetFactor: 1,
      polygonOffsetUnits: 1,
    });
  const geometry = part.places ? solidGeometry(part) : new BufferGeometry();
  const materials = part.places ? [look(stopColour, false), look(colour, false)] : look(colour, true);
  const mesh = new Mesh(geometry, materials);
  const outline = new BufferGeometry();
  if (part.places) outline.setAttribute("position", new BufferAttribute(gathered(part.places, part.edges), 3));
  const line = new LineBasicMaterial({ color: EDGE, transparent: true, opacity: EDGE_OPACITY });
  const lines = new LineSegments(outline, line);
  for (const object of [mesh, lines]) Object.assign(object, { frustumCulled: false, matrixAutoUpdate: false });
  lines.matrix = mesh.matrix;
  return { mesh, lines };
}

/** Triangles with a normal at each corner, averaged over the smooth faces around it. */
function solidGeometry({ places, corners, stops }) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(gathered(places, corners), 3));
  geometry.setAttribute("normal", new BufferAttribute(roundedNormals(places, corners), 3));
  geometry.addGroup(0, 3 * stops, 0);
  geometry.addGroup(3 * stops, corners.length - 3 * stops, 1);
  return geometry;
}

function gathered(places, numbers) {
  const found = new Float32Array(3 * numbers.length);
  for (const [index, number] of numbers.entries())
    for (let axis = 0; axis < 3; axis++) found[3 * index + axis] = places[3 * number + axis];
  return found;
}

function roundedNormals(places, corners) {
  const count = corners.length / 3;
  const areas = new Float64Array(corners.length); // normals as long as twice the areas
  const around = Array.from({ length: places.length / 3 }, () => []);
  for (let face = 0; face < count; face++) {
    const [a, b, c] = [0, 1, 2].map((corner) => 3 * corners[3 * face + corner]);
    const side = (from, to, axis) => places[to + (axis % 3)] - places[from + (axis % 3)];
    for (let axis = 0; axis < 3; axis++)
      areas[3 * face + axis] =
        side(a, b, axis + 1) * side(a, c, axis + 2) - side(a, b, axis + 2) * side(a, c, axis + 1);
    for (let corner = 0; corner < 3; corner++) around[corners[3 * face + corner]].push(face);
  }
  const lengths = Float64Array.from({ length: count }, (_, face) => Math.hypot(...areas.subarray(3 * face, 3 * face + 3)));
  const normals = new Float32Array(3 * corners.length);
  const dot = (one, other) =>
    areas[3 * one] * areas[3 * other] +
    areas[3 * one + 1] * areas[3 * other + 1] +
    areas[3 * one + 2] * areas[3 * other + 2];
  for (let corner = 0; corner < corners.length; corner++) {
    const own = Math.floor(corner / 3);
    const sum = [0, 0, 0];
    for (const face of around[corners[corner]])
      if (face === own || dot(own, face) >= SMOOTH * lengths[own] * lengths[face])
        for (let axis = 0; axis < 3; axis++) sum[axis] += areas[3 * face + axis];
    const length = Math.hypot(...sum) || 1;
    for (let axis = 0; axis < 3; axis++) normals[3 * corner + axis] = sum[axis] / length;
  }
  return normals;
}

/** Update the triangles and edges of a part that bends. */
function bend({ mesh, lines }, { triangles, edges }) {
  for (const [object, points] of [
    [mesh, triangles],
    [lines, edges],
  ]) {
    const { geometry } = object;
    let attribute = geometry.getAttribute("position");
    if (attribute?.count !== points.length) {
      attribute = new BufferAttribute(new Float32Array(3 * points.length), 3);
      geometry.setAttribute("position", attribute);
    }
    for (const [index, point] of points.entries()) point.toArray(attribute.array, 3 * index);
    attribute.needsUpdate = true;
    geometry.boundingSphere = null;
  }
}
