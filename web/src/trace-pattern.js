/**
 * A drawn crease pattern: {vertices: [[x, y]], edges: [[from, to]], letters: ["M", ...]}, positions in pixels, letters as
 * in FOLD files. Functions return a new pattern and change none.
 */

import { between, crossing, distance, nearestOn, onSheet } from "./trace-geometry.js";

export const EMPTY = { vertices: [], edges: [], letters: [] };
export const LETTERS = { M: "mountain", V: "valley", F: "flat", B: "border", C: "cut", U: "unassigned" };

const copy = ({ vertices, edges, letters }) => ({ vertices: [...vertices], edges: [...edges], letters: [...letters] });
const joins = ([one, other], a, b) => (one === a && other === b) || (one === b && other === a);

/** The number of the vertex within a distance of a point, or -1. */
export function vertexAt({ vertices }, point, reach) {
  let best = -1;
  for (const [number, vertex] of vertices.entries()) {
    if (distance(vertex, point) <= (best < 0 ? reach : distance(vertices[best], point))) best = number;
  }
  return best;
}

/** The number of the edge within a distance of a point, or -1. */
export function edgeAt({ vertices, edges }, point, reach) {
  let best = { number: -1, distance: reach };
  for (const [number, [one, other]] of edges.entries()) {
    const near = nearestOn(vertices[one], vertices[other], point);
    if (near.distance <= best.distance) best = { number, distance: near.distance };
  }
  return best.number;
}

/** The point to which a click moves: a vertex, else a known point of the picture, else an edge; {point, what}. */
export function snapped(pattern, points, point, reach) {
  const vertex = vertexAt(pattern, point, reach);
  if (vertex >= 0) return { point: pattern.vertices[vertex], what: "vertex" };
  const known = vertexAt({ vertices: points }, point, reach);
  if (known >= 0) return { point: points[known], what: "junction" };
  const edge = edgeAt(pattern, point, reach / 2);
  if (edge < 0) return { point, what: "" };
  const [one, other] = pattern.edges[edge];
  return { point: nearestOn(pattern.vertices[one], pattern.vertices[other], point).near, what: "crease" };
}

/** Add a vertex at a point, which splits the edge that passes there; returns [pattern, number of the vertex]. */
export function withVertex(pattern, point, reach) {
  const known = vertexAt(pattern, point, reach);
  if (known >= 0) return [pattern, known];
  const edge = edgeAt(pattern, point, reach);
  const next = copy(pattern);
  next.vertices.push(point);
  const number = next.vertices.length - 1;
  if (edge >= 0) split(next, edge, number);
  return [next, number];
}

function split(pattern, edge, vertex) {
  const [one, other] = pattern.edges[edge];
  pattern.edges[edge] = [one, vertex];
  pattern.edges.push([vertex, other]);
  pattern.letters.push(pattern.letters[edge]);
}

/** Add an edge between two vertices; it is split at vertices on its way and at edges that it crosses, as are these. */
export function withEdge(pattern, from, to, letter, reach) {
  if (from === to) return pattern;
  const next = copy(pattern);
  const line = [next.vertices[from], next.vertices[to]];
  for (const [number, [one, other]] of [...next.edges.entries()]) {
    if ([one, other].some((vertex) => nearestOn(...line, next.vertices[vertex]).distance <= reach)) continue;
    const at = crossing(line, [next.vertices[one], next.vertices[other]]);
    if (!at || vertexAt(next, between(...line, at[0]), reach) >= 0) continue;
    next.vertices.push(between(...line, at[0]));
    split(next, number, next.vertices.length - 1);
  }
  const on = [...next.vertices.entries()]
    .filter(([number]) => number !== from && number !== to)
    .map(([number, vertex]) => ({ number, ...nearestOn(...line, vertex) }))
    .filter(({ number, share, distance: aside }) => aside <= reach && share > 0 && share < 1 && used(next, number))
    .sort((one, other) => one.share - other.share);
  const path = [from, ...on.map(({ number }) => number), to];
  for (const [place, end] of path.slice(1).entries()) {
    const start = path[place];
    const known = next.edges.findIndex((edge) => joins(edge, start, end));
    if (known >= 0) next.letters[known] = letter;
    else {
      next.edges.push([start, end]);
      next.letters.push(letter);
    }
  }
  return next;
}

const used = ({ edges }, vertex) => edges.some((edge) => edge.includes(vertex));

/** Move a vertex; if another one is there, both become one. */
export function moved(pattern, vertex, point, reach) {
  const others = { vertices: pattern.vertices.map((place, number) => (number === vertex ? [Infinity, Infinity] : place)) };
  const there = vertexAt(others, point, reach);
  const next = copy(pattern);
  next.vertices[vertex] = there < 0 ? point : pattern.vertices[there];
  if (there < 0) return next;
  next.edges = next.edges.map((edge) => edge.map((end) => (end === vertex ? there : end)));
  const kept = next.edges.map((edge, number) => edge[0] !== edge[1] && next.edges.findIndex((other) => joins(other, ...edge)) === number);
  return without(keeping(next, kept), [vertex]);
}

const keeping = ({ vertices, edges, letters }, kept) => ({
  vertices,
  edges: edges.filter((_, number) => kept[number]),
  letters: letters.filter((_, number) => kept[number]),
});

/** Remove vertices with their edges. */
export function without(pattern, vertices) {
  const gone = new Set(vertices);
  const next = keeping(pattern, pattern.edges.map((edge) => !edge.some((end) => gone.has(end))));
  const number = [];
  let count = 0;
  for (const vertex of next.vertices.keys()) number.push(gone.has(vertex) ? -1 : count++);
  return {
    vertices: next.vertices.filter((_, vertex) => !gone.has(vertex)),
    edges: next.edges.map((edge) => edge.map((end) => number[end])),
    letters: next.letters,
  };
}

/** Remove an edge, and those of its vertices that no other edge has. */
export function withoutEdge(pattern, edge) {
  const ends = pattern.edges[edge];
  const next = keeping(pattern, pattern.edges.map((_, number) => number !== edge));
  return without(next, ends.filter((vertex) => !used(next, vertex)));
}

/** Assign a letter to an edge. */
export function assigned(pattern, edge, letter) {
  const next = copy(pattern);
  next.letters[edge] = letter;
  return next;
}

/** Add the images of all edges under maps of points. */
export function withImages(pattern, images, reach) {
  let next = pattern;
  for (const image of images) {
    for (const [number, [one, other]] of pattern.edges.entries()) {
      let from;
      let to;
      [next, from] = withVertex(next, image(pattern.vertices[one]), reach);
      [next, to] = withVertex(next, image(pattern.vertices[other]), reach);
      next = withEdge(next, from, to, pattern.letters[number], reach);
    }
  }
  return next;
}

/**
 * Kawasaki's and Maekawa's conditions at every vertex without a border or cut.
 *
 * Sectors are those on the sheet. Returns [{vertex, creases, kawasaki, maekawa}]: the magnitude of the alternating sum of the
 * sectors, rad, null for an odd number of creases; and |mountains - valleys| - 2, null where an edge is unassigned.
 */
export function vertexConditions({ vertices, edges, letters }, matrix) {
  const places = vertices.map((vertex) => onSheet(matrix, vertex));
  const around = vertices.map(() => []);
  for (const [number, [one, other]] of edges.entries()) {
    around[one].push({ to: places[other], letter: letters[number] });
    around[other].push({ to: places[one], letter: letters[number] });
  }
  const conditions = [];
  for (const [vertex, all] of around.entries()) {
    if (!all.length || all.some(({ letter }) => letter === "B" || letter === "C")) continue;
    const creases = all.filter(({ letter }) => letter !== "F");
    const [x, y] = places[vertex];
    const angles = creases.map(({ to }) => Math.atan2(to[1] - y, to[0] - x)).sort((one, other) => one - other);
    const sectors = angles.map((angle, place) => (angles[place + 1] ?? angles[0] + 2 * Math.PI) - angle);
    const count = (letter) => creases.filter((crease) => crease.letter === letter).length;
    conditions.push({
      vertex,
      creases: creases.length,
      kawasaki: creases.length % 2 ? null : Math.abs(sectors.reduce((sum, sector, place) => sum + (place % 2 ? -sector : sector), 0)),
      maekawa: count("U") ? null : creases.length ? Math.abs(count("M") - count("V")) - 2 : 0,
    });
  }
  return conditions;
}

/** Steps of drawing that can be undone. */
export function makeHistory(changed) {
  const history = { pattern: EMPTY, before: [], after: [] };
  const show = (pattern) => changed((history.pattern = pattern));
  return Object.assign(history, {
    put(pattern) {
      if (pattern === history.pattern) return;
      history.before.push(history.pattern);
      history.after = [];
      show(pattern);
    },
    undo() {
      if (!history.before.length) return;
      history.after.push(history.pattern);
      show(history.before.pop());
    },
    redo() {
      if (!history.after.length) return;
      history.before.push(history.pattern);
      show(history.after.pop());
    },
    clear() {
      [history.before, history.after] = [[], []];
      show(EMPTY);
    },
  });
}
