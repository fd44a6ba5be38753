/**
 * The largest principal Green strain of a sheet's faces: (l - 1) / 2 with l the larger eigenvalue of the metric of a
 * triangle's sides relative to the built metric; and the largest principal stress, second Piola-Kirchhoff, of a Saint
 * Venant-Kirchhoff sheet in plane stress, as forficula.structure.membrane_stress computes it. As in figures and films, a
 * face has the value of its more stretched triangle.
 */

const FLAT = 1e-9; // squared area below which a triangle has no strain, as a share of its squared size

/** Strains and stresses of a clip's triangles for given vertices. */
export function makeStrains(clip) {
  const { triangles, faces, membraneLaw: law } = clip.mesh;
  const built = clip.builtVertices();
  const metrics = Array.from({ length: faces.length }, (_, triangle) => metric(built, triangles, triangle));
  const ofFace = new Float32Array(faces.reduce((most, face) => Math.max(most, face), 0) + 1);
  const ofTriangle = new Float32Array(faces.length);

  /** Largest principal stress for the principal strains, Pa. */
  function stressOf(larger, smaller) {
    const { youngs_modulus_Pa: modulus, poisson_ratio: nu } = law;
    return (modulus / (1 - nu * nu)) * ((1 - nu) * larger + nu * (larger + smaller));
  }

  /** Write the strain, or the stress in Pa, of every triangle's face. */
  function at(vertices, quantity = "strain") {
    ofFace.fill(-Infinity);
    for (let triangle = 0; triangle < faces.length; triangle++) {
      const [e, f, g] = metrics[triangle];
      const area = e * g - f * f;
      if (area <= FLAT * (e + g) ** 2) continue;
      const [now1, now2, now3] = metric(vertices, triangles, triangle);
      const half = (g * now1 - 2 * f * now2 + e * now3) / (2 * area);
      const product = (now1 * now3 - now2 * now2) / area;
      const root = Math.sqrt(Math.max(half * half - product, 0));
      const [larger, smaller] = [(half + root - 1) / 2, (half - root - 1) / 2];
      const value = quantity === "stress" ? stressOf(larger, smaller) : larger;
      ofFace[faces[triangle]] = Math.max(ofFace[faces[triangle]], value);
    }
    for (let triangle = 0; triangle < faces.length; triangle++) ofTriangle[triangle] = Math.max(0, ofFace[faces[triangle]]);
    return ofTriangle;
  }

  /** The largest strain, or stress in Pa, of all frames. */
  function largest(quantity) {
    const vertices = new Float32Array(built.length);
    let most = 0;
    for (const moment of clip.time) most = at(clip.verticesAt(moment, vertices), quantity).reduce((one, other) => Math.max(one, other), most);
    return most;
  }

  return { at, largest };
}

/** Products of the two sides of a triangle from its first corner. */
function metric(vertices, triangles, triangle) {
  const [first, second, third] = [0, 1, 2].map((corner) => 3 * triangles[3 * triangle + corner]);
  let [e, f, g] = [0, 0, 0];
  for (let axis = 0; axis < 3; axis++) {
    const one = vertices[second + axis] - vertices[first + axis];
    const other = vertices[third + axis] - vertices[first + axis];
    e += one * one;
    f += one * other;
    g += other * other;
  }
  return [e, f, g];
}
