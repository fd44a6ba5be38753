/** An arrow along gravity in the upper right corner of a picture. */

import { ConeGeometry, CylinderGeometry, Group, Mesh, MeshBasicMaterial, Vector3 } from "three";
import { styleColour } from "./scheme.js";

const UP = new Vector3(0, 1, 0); // axis of the geometries
// its middle, as shares of half the picture, and its length, thickness and head, as shares of the picture's height
const CORNER = [0.86, 0.78];
const LENGTH = 0.1;
const THICKNESS = 0.004;
const HEAD = 0.035;

/** direction: a vector of length 1. */
export function makeGravity(direction) {
  const material = new MeshBasicMaterial();
  const shaft = new Mesh(new CylinderGeometry(THICKNESS, THICKNESS, LENGTH, 10), material);
  const head = new Mesh(new ConeGeometry(3 * THICKNESS, HEAD, 16), material);
  shaft.position.y = -HEAD / 2;
  head.position.y = LENGTH / 2;
  const group = new Group();
  group.add(shaft, head);
  group.quaternion.setFromUnitVectors(UP, new Vector3(...direction));
  const paint = () => material.color.set(styleColour("--bar"));
  const [middle, edge] = [new Vector3(), new Vector3()];

  /** Put the arrow into the corner of what a camera sees, at the distance of its target. */
  function follow(camera, target) {
    const depth = middle.copy(target).project(camera).z;
    edge.set(CORNER[0], 1, depth).unproject(camera);
    group.position.set(CORNER[0], -1, depth).unproject(camera);
    group.scale.setScalar(edge.distanceTo(group.position));
    group.position.set(...CORNER, depth).unproject(camera);
  }

  const dispose = () => [shaft, head].forEach((part) => part.geometry.dispose());

  return { group, paint, follow, dispose };
}
