/** How a slack tendon is drawn: hanging down in a parabola that is as long as its resting length. */

const STEPS = 40; // of the bisection

/** How deep a parabola over a span hangs in its middle, so that it is so long; 0 where it is not longer than the span. */
export function sag(span, length) {
  if (!(length > span * (1 + 1e-6))) return 0;
  // longer than twice its depth, shorter than that and its span
  let [low, high] = [0, length / 2];
  for (let step = 0; step < STEPS; step++) {
    const middle = (low + high) / 2;
    if (arcLength(span, middle) < length) low = middle;
    else high = middle;
  }
  return (low + high) / 2;
}

/** Length of a parabola over a span that hangs so deep. */
export function arcLength(span, depth) {
  if (depth === 0) return span;
  const root = Math.hypot(span, 4 * depth);
  return root / 2 + (span * span * Math.asinh((4 * depth) / (span || 1e-12))) / (8 * depth);
}
