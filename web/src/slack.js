/** Shape of a slack tendon: a parabola whose length is the rest length. */

const STEPS = 40; // steps of the bisection

/** Depth of a parabola over a span for a given length; 0 if the length does not exceed the span. */
export function sag(span, length) {
  if (!(length > span * (1 + 1e-6))) return 0;
  // the length is above twice the depth, and below the sum of that and the span
  let [low, high] = [0, length / 2];
  for (let step = 0; step < STEPS; step++) {
    const middle = (low + high) / 2;
    if (arcLength(span, middle) < length) low = middle;
    else high = middle;
  }
  return (low + high) / 2;
}

/** Length of a parabola over a span with a given depth. */
function arcLength(span, depth) {
  if (depth === 0) return span;
  const root = Math.hypot(span, 4 * depth);
  return root / 2 + (span * span * Math.asinh((4 * depth) / (span || 1e-12))) / (8 * depth);
}
