/** Compressed arrays of a page, one after the other: whole numbers as differences, column by column. */

import { unpack } from "./clip.js";

/** Inflate all arrays of a page; `take` returns one by its position in them. */
export async function readArrays(text) {
  const packed = new Blob([unpack(text, Uint8Array)]).stream();
  const buffer = await new Response(packed.pipeThrough(new DecompressionStream("deflate"))).arrayBuffer();

  function take({ kind, start, shape, low, step }) {
    const length = shape.reduce((product, each) => product * each, 1);
    if (kind === "f4") return new Float32Array(buffer, start, length);
    if (kind === "f8") return new Float64Array(buffer, start, length);
    const steps = new (kind === "u2" ? Uint16Array : Uint32Array)(buffer, start, length);
    const rows = summed(steps, ...shape);
    return low ? Float32Array.from(rows, (value, at) => low[at % shape[1]] + step[at % shape[1]] * value) : rows;
  }

  return take;
}

/** Add up differences. Negative ones wrapped around as unsigned numbers, and the sum wraps back. */
function summed(steps, rows, columns) {
  const Kind = steps.constructor;
  const total = new Kind(1);
  const table = new Kind(steps.length);
  for (let column = 0; column < columns; column++) {
    total[0] = 0;
    for (let row = 0; row < rows; row++) {
      total[0] += steps[column * rows + row];
      table[row * columns + column] = total[0];
    }
  }
  return table;
}
