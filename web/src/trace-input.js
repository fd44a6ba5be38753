/** Pointers and keys on a drawing: both draw, select, move and delete. */

import { STEPS } from "./arrow-pad.js";
import { distance } from "./trace-geometry.js";
import { LETTERS, assigned, edgeAt, moved, snapped, vertexAt, withEdge, withVertex, without, withoutEdge } from "./trace-pattern.js";

const REACH = { mouse: 9, touch: 22, pen: 12, keys: 9 }; // [chosen] pixels of the screen within which a click snaps
const DRAG = 5; // pixels of the screen, below which a movement is a click
const ROW = 12; // [chosen] pixels of the screen, height of a row in the order of reading
const JOINED = 1e-6; // pixels of the picture, between points that are one after snapping

/** Nothing selected. */
export const NOTHING = { vertex: -1, edge: -1, click: -1 };

/**
 * Listen to a drawing. state: {tool, letter, points, selected, cursor, pen, aim, preview, clicks, most}, which is changed here;
 * history: that of the pattern; show: draws the state; say: receives what was done; clicked: is called when clicks of the scale
 * have changed.
 */
export function listenToDrawing(view, state, history, { show, say, clicked }) {
  const { drawing } = view;
  let press = null; // pointer that is down: {id, start, reach, dragging, was}

  const reachOf = (kind) => (REACH[kind] ?? REACH.mouse) * view.unit;
  const aimAt = (point, reach) => snapped(history.pattern, state.points, point, reach);
  const inside = ([x, y]) => [Math.min(Math.max(x, 0), view.width - 1), Math.min(Math.max(y, 0), view.height - 1)];

  function select(point, reach) {
    const vertex = vertexAt(history.pattern, point, reach);
    state.selected = { ...NOTHING, vertex, edge: vertex < 0 ? edgeAt(history.pattern, point, reach) : -1 };
    say(described());
  }

  function described() {
    const { vertex, edge } = state.selected;
    if (vertex >= 0) return `Vertex ${vertex} is selected.`;
    return edge >= 0 ? `Edge ${edge} is selected: ${LETTERS[history.pattern.letters[edge]]}.` : "";
  }

  /** Add a vertex, and from another point an edge to it. */
  function put(from, to) {
    let pattern = history.pattern;
    let [start, end] = [-1, -1];
    if (from) [pattern, start] = withVertex(pattern, from, JOINED);
    [pattern, end] = withVertex(pattern, to, JOINED);
    if (from && start !== end) pattern = withEdge(pattern, start, end, state.letter, view.unit);
    history.put(pattern);
    state.selected = { ...NOTHING, vertex: end };
    say(from ? `A ${LETTERS[state.letter]} edge to vertex ${end} is drawn.` : `Vertex ${end} is drawn.`);
  }

  /** Add a click of the scale, or move the selected one once all are there. */
  function measure(point, reach) {
    const near = vertexAt({ vertices: state.clicks }, point, reach);
    if (near < 0 && state.clicks.length === state.most) state.clicks = [];
    if (near < 0) state.clicks = [...state.clicks, point];
    state.selected = { ...NOTHING, click: near < 0 ? state.clicks.length - 1 : near };
    say(`Point ${state.selected.click + 1} of ${state.most}.`);
  }

  drawing.addEventListener("pointerdown", (event) => {
    if (press || (event.pointerType === "mouse" && event.button !== 0)) return;
    drawing.setPointerCapture?.(event.pointerId);
    drawing.focus({ preventScroll: true });
    const reach = reachOf(event.pointerType);
    const at = view.pointOf(event);
    state.cursor = null;
    press = { id: event.pointerId, at, reach, dragging: false, was: history.pattern };
    if (state.tool === "draw") [state.pen, state.aim] = [null, aimAt(inside(at), reach)];
    if (state.tool === "move") select(at, reach);
    if (state.tool === "scale") measure(aimAt(inside(at), reach).point, reach);
    press.start = state.aim?.point ?? at;
    show();
  });

  drawing.addEventListener("pointermove", (event) => {
    const at = inside(view.pointOf(event));
    const reach = reachOf(event.pointerType);
    if (!press) {
      state.aim = state.tool === "move" || state.cursor ? null : aimAt(at, reach);
      return show();
    }
    if (event.pointerId !== press.id) return undefined;
    press.dragging ||= distance(at, press.at) > DRAG * view.unit;
    if (!press.dragging) return undefined;
    if (state.tool === "draw") [state.pen, state.aim] = [press.start, aimAt(at, reach)];
    if (state.tool === "move" && state.selected.vertex >= 0) {
      const { vertex } = state.selected;
      state.aim = snapped(without(history.pattern, [vertex]), state.points, at, reach);
      state.preview = { ...history.pattern, vertices: history.pattern.vertices.with(vertex, state.aim.point) };
    }
    if (state.tool === "scale") state.clicks = state.clicks.with(state.selected.click, aimAt(at, reach).point);
    return show();
  });

  drawing.addEventListener("pointerup", (event) => {
    if (event.pointerId !== press?.id) return;
    const { dragging, start } = press;
    press = null;
    if (state.tool === "draw" && state.aim) put(dragging ? start : null, state.aim.point);
    if (state.tool === "move" && dragging && state.selected.vertex >= 0) move(state.selected.vertex, state.aim.point);
    if (state.tool === "scale") clicked();
    Object.assign(state, { pen: null, aim: null, preview: null });
    show();
  });

  drawing.addEventListener("pointercancel", () => {
    press = null;
    Object.assign(state, { pen: null, aim: null, preview: null });
    show();
  });

  function move(vertex, point) {
    const count = history.pattern.vertices.length;
    history.put(moved(history.pattern, vertex, point, JOINED));
    if (history.pattern.vertices.length < count) state.selected = NOTHING;
    say(history.pattern.vertices.length < count ? "Two vertices are one now." : `Vertex ${vertex} is moved.`);
  }

  /** Remove what is selected. */
  function remove() {
    const { vertex, edge, click } = state.selected;
    if (vertex >= 0) history.put(without(history.pattern, [vertex]));
    else if (edge >= 0) history.put(withoutEdge(history.pattern, edge));
    else if (click >= 0) {
      state.clicks = state.clicks.filter((_, place) => place !== click);
      clicked();
    } else return;
    state.selected = NOTHING;
    say("Deleted.");
    show();
  }

  /** Use a kind for the selected edge, and for edges to come. */
  function assign(letter) {
    state.letter = letter;
    if (state.selected.edge >= 0) history.put(assigned(history.pattern, state.selected.edge, letter));
    say(state.selected.edge >= 0 ? described() : `The next edge is drawn as ${LETTERS[letter]}.`);
    show();
  }

  function step([right, up], fast) {
    const { vertex, click } = state.selected;
    const by = (length) => ([x, y]) => inside([x + right * length * view.unit, y - up * length * view.unit]);
    if (state.tool === "move" && vertex >= 0) move(vertex, by(fast ? 10 : 1)(history.pattern.vertices[vertex]));
    else if (state.tool === "scale" && click >= 0 && !state.cursor) {
      state.clicks = state.clicks.with(click, by(fast ? 10 : 1)(state.clicks[click]));
      clicked();
    } else lead(by(fast ? 50 : 5)(state.cursor ?? [view.width / 2, view.height / 2]));
  }

  /** Put the cursor of the keyboard at a point. */
  function lead(point) {
    state.cursor = point;
    state.aim = aimAt(point, reachOf("keys"));
    say(`Cursor at ${point.map((value) => value.toFixed(0)).join(", ")} pixels${state.aim.what ? `, at a ${state.aim.what}` : ""}.`);
  }

  /** Lead the cursor to the next vertex or junction, in the order of reading. */
  function next(forwards) {
    const { vertices } = history.pattern;
    const row = ([, y]) => Math.round(y / (ROW * view.unit));
    const apart = state.points.filter((point) => vertexAt(history.pattern, point, JOINED) < 0);
    const places = [...vertices, ...apart].sort((one, other) => row(one) - row(other) || one[0] - other[0]);
    if (!places.length) return;
    const at = state.cursor ? places.findIndex((place) => distance(place, state.cursor) < JOINED) : -1;
    lead(places[(at + (forwards ? 1 : at < 0 ? 0 : -1) + places.length) % places.length]);
  }

  function enter() {
    if (!state.cursor) lead([view.width / 2, view.height / 2]);
    const { point } = (state.aim = aimAt(state.cursor, reachOf("keys")));
    if (state.tool === "move") return select(state.cursor, reachOf("keys"));
    if (state.tool === "scale") {
      measure(point, reachOf("keys"));
      return clicked();
    }
    put(state.pen, point);
    state.pen = point;
    return undefined;
  }

  function leave() {
    [state.pen, state.aim, state.cursor, state.selected] = [null, null, null, NOTHING];
    say("");
  }

  /** Undo a step, or do it again. */
  function again(forwards) {
    (forwards ? history.redo : history.undo)();
    say(forwards ? "Done again." : "Undone.");
  }

  drawing.addEventListener("keydown", (event) => {
    const { key } = event;
    const letter = key.toUpperCase();
    const command = event.ctrlKey || event.metaKey;
    if (event.altKey) return;
    if (command && letter === "Z") again(event.shiftKey);
    else if (command && letter === "Y") again(true);
    else if (command) return;
    else if (key in STEPS) step(STEPS[key], event.shiftKey);
    else if (key === "Delete" || key === "Backspace") remove();
    else if (key === "Enter" || key === " ") enter();
    else if (key === "Escape") leave();
    else if (letter === "N" || letter === "P") next(letter === "N");
    else if (letter in LETTERS) assign(letter);
    else return;
    event.preventDefault();
    show();
  });

  return { remove, assign, again };
}
