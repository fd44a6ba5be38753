/** Round bars between two points, drawn by the hundred at once. */

import { MeshLambertMaterial } from "three";

/** A material that is drawn in front of anything less than a distance nearer, m. */
export function barMaterial(nearer) {
  const material = new MeshLambertMaterial();
  material.userData.nearer = nearer;
  if (nearer === 0) return material;
  const distance = { value: nearer };
  // one shader serves all distances
  material.onBeforeCompile = (shader) => {
    shader.uniforms.nearer = distance;
    shader.vertexShader = `uniform float nearer;\n${shader.vertexShader}`.replace(
      "#include <project_vertex>",
      `#include <project_vertex>
      vec4 pulled = vec4(mvPosition.xyz - normalize(mvPosition.xyz) * nearer, 1.0);
      vec4 nearPosition = projectionMatrix * pulled;
      gl_Position.z = nearPosition.z / nearPosition.w * gl_Position.w;`,
    );
  };
  return material;
}

/** Write the matrix that maps a bar of radius and length 1 along y to a bar between two vertices. */
export function placeTube(vertices, first, second, radius, matrix, at) {
  let x = vertices[second] - vertices[first];
  let y = vertices[second + 1] - vertices[first + 1];
  let z = vertices[second + 2] - vertices[first + 2];
  const length = Math.hypot(x, y, z) || 1e-12;
  x /= length;
  y /= length;
  z /= length;
  // any direction across the axis: the bar is round
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
