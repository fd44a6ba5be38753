/** Tracing in a workbench: a picture under a drawing, from which a crease pattern and a design are made. */

import { ask } from "./bench-ask.js";
import { make } from "./elements.js";
import { save } from "./saving.js";
import { makeConditions } from "./trace-conditions.js";
import { makeDrawing } from "./trace-drawing.js";
import { clockwise, imageOnSheet, mirror, onSheet, rotation } from "./trace-geometry.js";
import { NOTHING, listenToDrawing } from "./trace-input.js";
import { makeHistory, vertexConditions, withImages } from "./trace-pattern.js";
import { makeAct, makeEntry, makeKinds, makeLooks, makeTools } from "./trace-tools.js";

const REST = 800; // ms after a change, before the sheet is folded again
const PICTURE = /\.(png|jpe?g)$/i;
const NO_DOUBTS = { lines: [], places: [], words: [] };
const HELP =
  "Click for a vertex, drag for an edge. Keys: arrows lead a cursor or move what is selected (shift: further), N and P" +
  " lead to the next and the previous vertex or junction, Enter draws from the last point, Escape ends that, letters choose" +
  " the kind, Delete deletes, ctrl+Z and ctrl+Y undo and redo.";

/** Whether a file is a picture, by its name. */
export const isPicture = ({ name }) => PICTURE.test(name);

/** open: opens {files} as the design; beside: the element of the structure, which is displayed beside the drawing. */
export function makeTracing(open, beside) {
  const view = makeDrawing();
  const state = {
    ...{ tool: "draw", letter: "B", points: [], selected: NOTHING, cursor: null, pen: null, aim: null, preview: null },
    ...{ clicks: [], most: 2, scale: null, matrix: null, doubts: NO_DOUBTS, picture: null, conditions: [] },
  };
  const history = makeHistory(changed);
  const tools = makeTools((tool) => choose(tool));
  const kinds = makeKinds((letter) => input.assign(letter));
  const said = make("p", { className: "note trace-said", role: "status" });
  const wrong = make("p", { className: "wrong", role: "alert" });
  const doubts = make("div", { className: "notes" });
  const conditions = makeConditions((vertex) => {
    choose("move");
    state.selected = { ...NOTHING, vertex };
    show();
    view.drawing.focus();
  });
  const input = listenToDrawing(view, state, history, { show, say: (text) => (said.textContent = text), clicked: measured });
  const scaling = makeScaling(measured, (most) => {
    [state.most, state.clicks, state.selected] = [most, [], NOTHING];
    measured();
    choose("scale");
  });
  let timer = 0;
  let opened = 0;

  // a picture

  async function take(file) {
    const address = URL.createObjectURL(file);
    try {
      await make("img", { src: address }).decode();
    } catch {
      URL.revokeObjectURL(address);
      refuse(`${file.name} cannot be displayed: need a PNG or JPEG picture`);
      return;
    }
    URL.revokeObjectURL(view.image.src);
    view.image.src = address;
    await view.image.decode();
    const picture = { name: file.name, text: await asText(file) };
    Object.assign(state, { picture, points: [], doubts: NO_DOUBTS, clicks: [], scale: null, matrix: null, cursor: null });
    history.clear();
    view.size(view.image.naturalWidth, view.image.naturalHeight);
    work.hidden = false;
    doubts.replaceChildren();
    scaling.say("");
    choose("draw");
    refuse("");
    said.textContent = "Searching for lines to which clicks snap \u2026";
    const reply = await ask("picture-junctions", content());
    if (state.picture !== picture) return;
    if (reply.refused) {
      work.hidden = true;
      state.picture = null;
      refuse(`${file.name} is not opened: ${reply.refused}`);
      return;
    }
    state.points = reply.points;
    said.textContent = reply.points.length ? `Clicks snap to ${reply.points.length} junctions of lines and corners.` : `Clicks snap to vertices only: ${reply.reason || "no junctions of lines were found"}.`;
    show();
  }

  const content = () => ({ picture: state.picture.text, name: state.picture.name });

  // its scale

  async function measured() {
    const { clicks, most } = state;
    const size = scaling.text;
    [state.scale, state.matrix] = [null, null];
    scaling.say(clicks.length < most ? `${clicks.length} of ${most} points are clicked.` : size ? "" : scaling.missing);
    if (clicks.length === most && size) {
      const points = most === 4 ? clockwise(clicks) : clicks;
      const scale = { points, size, width: view.width, height: view.height };
      const reply = await ask("picture-scale", scale);
      if (state.clicks !== clicks) return;
      if (reply.refused) scaling.say(reply.refused, true);
      else {
        [state.scale, state.matrix] = [scale, reply.matrix];
        const estimate = reply.estimated ? ` The shorter side is estimated from ${reply.estimated}; give width and height.` : "";
        scaling.say(`${most === 4 ? `The rectified sheet is ${reply.size}` : `The length is ${reply.size}`}; one pixel is ${reply.pixel}.${estimate}`);
      }
    }
    changed();
  }

  // the pattern

  function changed() {
    const { pattern } = history;
    if (state.selected.vertex >= pattern.vertices.length || state.selected.edge >= pattern.edges.length) state.selected = NOTHING;
    state.conditions = vertexConditions(pattern, state.matrix);
    clearTimeout(timer);
    if (follow.checked && state.scale && pattern.edges.length > 2) timer = setTimeout(() => fold(true), REST);
    show();
  }

  function show() {
    kinds.show(state.letter);
    tools.show(state.tool);
    // conditions follow a vertex while it is dragged
    const shown = state.preview ? vertexConditions(state.preview, state.matrix) : state.conditions;
    conditions.show(shown, state.matrix !== null);
    view.show({ ...state, pattern: state.preview ?? history.pattern, conditions: shown, clicks: state.tool === "scale" ? state.clicks : [] });
    const { vertex, edge, click } = state.selected;
    undo.disabled = !history.before.length;
    redo.disabled = !history.after.length;
    remove.disabled = vertex < 0 && edge < 0 && click < 0;
    const whole = state.scale && history.pattern.edges.length > 2;
    for (const button of [flat.button, download, folding]) button.disabled = !whole;
    along.disabled = reflect.disabled = edge < 0;
    around.disabled = vertex < 0;
  }

  function choose(tool) {
    Object.assign(state, { tool, pen: null, aim: null, selected: NOTHING });
    scaling.element.hidden = tool !== "scale";
    kinds.element.hidden = tool === "scale";
    show();
  }

  const drawn = () => {
    const { vertices, edges, letters } = history.pattern;
    return { scale: state.scale, name: state.picture.name, vertices, edges, letters };
  };

  function refuse(why) {
    said.textContent = "";
    wrong.textContent = why && !why.endsWith(".") ? `${why}.` : why;
    const number = /edges_vertices\[(\d+)\]/.exec(why)?.[1];
    if (number !== undefined) state.selected = { ...NOTHING, edge: Number(number) };
    show();
  }

  /** Move the vertices least to flat-foldability. */
  async function straighten(tolerance) {
    const before = history.pattern;
    refuse("");
    said.textContent = "Moving the vertices \u2026";
    const reply = await ask("picture-straighten", { ...drawn(), tolerance });
    if (history.pattern !== before) return;
    if (reply.refused) return void refuse(reply.refused);
    history.put({ vertices: reply.vertices, edges: reply.edges, letters: reply.letters });
    const symmetries = reply.symmetries.length ? `, with ${reply.symmetries.join(" and ")}` : "";
    said.textContent = [`Vertices moved by at most ${reply.largest}: Kawasaki's condition holds at ${reply.flat} vertices${symmetries}`, ...reply.remarks].join(". ");
  }

  /** Trace the picture automatically. */
  async function trace(size) {
    const { picture } = state;
    const corners = state.clicks.length === 4 ? clockwise(state.clicks) : null;
    refuse("");
    said.textContent = "Tracing \u2026";
    automatic.button.disabled = true;
    const where = corners ? corners.map(([x, y]) => `${x.toFixed(2)},${y.toFixed(2)}`).join(" ") : automatic.flat.checked ? "none" : "";
    const reply = await ask("picture-trace", { ...content(), size, corners: where });
    automatic.button.disabled = false;
    if (state.picture !== picture) return;
    if (reply.refused) return void refuse(reply.refused);
    const { points, size: length } = reply.scale;
    [state.clicks, state.most] = [points, points.length];
    scaling.put(points.length, length);
    const ends = ([one, other]) => [reply.vertices[one], reply.vertices[other]];
    const numbers = (entries) => Object.entries(entries).map(([number, why]) => [Number(number), why]);
    const doubtful = numbers(reply.doubts.edges);
    const uncertain = numbers(reply.doubts.vertices);
    state.doubts = {
      lines: doubtful.map(([number]) => ends(reply.edges[number])),
      places: [...uncertain.map(([number]) => reply.vertices[number]), ...reply.doubts.points.map(([x, y]) => [x, y])],
      words: [
        ...reply.doubts.whole,
        ...doubtful.map(([number, why]) => `Edge ${number}: ${why}.`),
        ...uncertain.map(([number, why]) => `Vertex ${number}: ${why}.`),
      ],
    };
    doubts.replaceChildren(...(state.doubts.words.length ? [listOfDoubts()] : []));
    history.put({ vertices: reply.vertices, edges: reply.edges, letters: reply.letters });
    await measured();
    const count = state.doubts.words.length;
    said.textContent = `Traced ${reply.vertices.length} vertices and ${reply.edges.length} edges of a pattern of ${reply.said}; ${count ? `${count} doubts are listed below` : "nothing is doubtful"}.`;
  }

  function listOfDoubts() {
    const hide = makeAct("Remove the marks of doubts", "the list and the orange marks", () => {
      state.doubts = NO_DOUBTS;
      doubts.replaceChildren();
      show();
    });
    return make("details", { open: true }, make("summary", {}, "Doubts"), make("ul", {}, ...state.doubts.words.map((text) => make("li", {}, text))), hide);
  }

  /** Add images of all edges; `maps` returns maps of the sheet. */
  function repeat(maps) {
    const { vertex, edge } = state.selected;
    const place = (number) => onSheet(state.matrix, history.pattern.vertices[number]);
    const chosen = edge >= 0 ? history.pattern.edges[edge].map(place) : [place(vertex)];
    history.put(withImages(history.pattern, maps(...chosen).map((map) => imageOnSheet(state.matrix, map)), 2 * view.unit));
  }

  // the result

  /** Request the FOLD file; returns the reply, or null after a refusal. A quiet request reports only what was changed. */
  async function result(quiet = false) {
    const reply = await ask("picture-pattern", drawn());
    if (reply.refused) refuse(`No pattern yet: ${reply.refused}`);
    else {
      wrong.textContent = "";
      if (!quiet || reply.remarks.length) said.textContent = [`The pattern is ${reply.size}`, ...reply.remarks].join(". ");
    }
    return reply.refused ? null : reply;
  }

  async function saveResult() {
    const reply = await result();
    if (reply) save(new Blob([reply.fold], { type: "application/json" }), foldName());
  }

  // names of files that every system allows
  const foldName = () => `${state.picture.name.replace(PICTURE, "").replace(/[^\p{L}\p{N}._ -]/gu, "_").slice(0, 60) || "picture"}.fold`;

  async function fold(quiet = false) {
    const mine = (opened += 1);
    const reply = await result(quiet);
    if (!reply || mine !== opened) return;
    if (await open({ design: "", files: [{ name: foldName(), text: reply.fold }], unit: "" })) return;
    panes.append(side);
    lay();
  }

  const undo = makeAct("Undo", "ctrl+Z", () => input.again(false));
  const redo = makeAct("Redo", "ctrl+Y", () => input.again(true));
  const remove = makeAct("Delete", "what is selected", () => input.remove());
  const closer = makeAct("Enlarge", "the picture and the drawing", () => magnify(1.5));
  const wider = makeAct("Reduce", "the picture and the drawing", () => magnify(1 / 1.5));
  const flat = makeEntry("Move vertices by at most ", { id: "trace-tolerance", placeholder: "0.5 mm", button: "Make flat-foldable", note: "The vertices move as little as possible to Kawasaki's condition, and to the symmetries and straight lines that hold within this length." }, straighten);
  const automatic = makeEntry("Width and height of the sheet ", { id: "trace-size", placeholder: "29.7 x 21 cm", button: "Trace automatically" }, trace);
  automatic.flat = make("input", { type: "checkbox" });
  automatic.element.append(make("label", {}, automatic.flat, " scan without perspective: the size is that of the pattern"));
  automatic.element.append(make("p", { className: "note" }, "Four corners under \u201cSet the scale\u201d are used if they are clicked; otherwise they are searched. The result replaces the drawing; undo restores it."));
  const count = make("input", { type: "number", id: "trace-copies", min: 2, max: 60, value: 4 });
  const copies = () => Math.min(Math.max(Math.round(count.valueAsNumber) || 2, 2), 60);
  const reflect = makeAct("Mirror at the selected edge", "all edges", () => repeat((one, other) => [mirror(one, other)]));
  const around = makeAct("Repeat around the selected vertex", "all edges, by equal angles of a whole turn", () => {
    const number = copies();
    repeat((centre) => Array.from({ length: number - 1 }, (_, turn) => rotation(centre, (2 * Math.PI * (turn + 1)) / number)));
  });
  const along = makeAct("Repeat along the selected edge", "all edges, by its length", () => {
    const number = copies();
    repeat(([x, y], [u, v]) => Array.from({ length: number - 1 }, (_, turn) => ([a, b]) => [a + (turn + 1) * (u - x), b + (turn + 1) * (v - y)]));
  });
  const download = makeAct("Download as FOLD", "with the unit and the scale of the picture", saveResult);
  const folding = makeAct("Fold it", "open the pattern as the design of the workbench", () => fold());
  const follow = make("input", { type: "checkbox", id: "trace-follow" });
  follow.addEventListener("change", changed);

  /** Display the folded sheet beside its drawing, once there is one. */
  function lay() {
    if (side.isConnected && beside.parentElement !== side) side.append(beside);
  }

  function magnify(factor) {
    view.magnify(factor);
    show();
  }

  const choice = make("input", { type: "file", id: "trace-file", accept: ".png,.jpg,.jpeg", className: "spoken" });
  choice.addEventListener("change", () => {
    if (choice.files.length) take(choice.files[0]);
    choice.value = "";
  });
  const side = make("div", { className: "trace-side", role: "group", "aria-label": "the folded sheet" });
  const group = (title, ...parts) => make("fieldset", { className: "trace-group" }, make("legend", {}, title), ...parts);
  view.drawing.setAttribute("aria-label", `the drawing over the picture. ${HELP}`);
  const groups = make(
    "div",
    { className: "trace-groups" },
    group("Result", make("div", { className: "choices" }, folding, download), make("label", {}, follow, " fold it again after every change")),
    group("Trace automatically", automatic.element),
    group("Flat-foldability", flat.element),
    group("Symmetric copies", make("div", { className: "choices" }, reflect, around, along, make("label", { htmlFor: "trace-copies" }, "number in all ", count))),
  );
  const help = make("p", { className: "note" }, HELP);
  const panes = make("div", { className: "trace-panes" }, make("div", {}, view.element, said, help, groups, doubts, conditions.element));
  const work = make(
    "div",
    { hidden: true },
    make("div", { className: "trace-tools" }, tools.element, kinds.element, scaling.element),
    make("div", { className: "choices" }, undo, redo, remove, closer, wider, makeLooks(view.image)),
    panes,
  );
  const start = make(
    "div",
    { className: "choices opening" },
    make("span", { className: "choosing" }, choice, make("label", { className: "button", htmlFor: "trace-file" }, "Choose a picture \u2026")),
    make("p", { className: "note" }, "A photograph, scan or drawing of a crease pattern (PNG or JPEG, up to 14 MB), or drop it anywhere on the page."),
  );
  const element = make("div", { className: "tracing" }, start, wrong, work);
  new ResizeObserver(show).observe(view.drawing);
  choose("draw");
  return {
    element,
    take,
    state,
    history,
    seen: lay,
  };
}

/** The part of the tool that sets the scale. */
function makeScaling(changed, choose) {
  const kinds = { 2: ["two points and their distance", "Distance ", "5 cm"], 4: ["four corners of a rectangle", "Width and height ", "29.7 x 21 cm"] };
  const choice = make("select", { "aria-label": "what is clicked" }, ...Object.entries(kinds).map(([value, [text]]) => make("option", { value }, text)));
  const entry = makeEntry(kinds[2][1], { id: "trace-length", placeholder: kinds[2][2], button: "Apply" }, changed);
  const said = make("p", { className: "note", role: "status" });
  const element = make("fieldset", { className: "trace-choice" }, make("legend", {}, "Scale: click in the picture"), choice, entry.element, said);

  function name(most) {
    choice.value = String(most);
    entry.label.textContent = kinds[most][1];
    entry.input.placeholder = kinds[most][2];
  }

  choice.addEventListener("change", () => {
    name(Number(choice.value));
    choose(Number(choice.value));
  });
  return {
    element,
    get text() {
      return entry.input.value.trim();
    },
    get missing() {
      return `Enter ${choice.value === "4" ? "the width and height" : "the distance"}, such as ${kinds[choice.value][2]}.`;
    },
    put(most, text) {
      name(most);
      entry.input.value = text;
    },
    say(text, fails = false) {
      said.textContent = text;
      said.classList.toggle("fails", fails);
    },
  };
}

/** The content of a file in base 64. */
async function asText(file) {
  const reader = new FileReader();
  const done = new Promise((settle, fail) => Object.assign(reader, { onload: settle, onerror: fail }));
  reader.readAsDataURL(file);
  await done;
  return reader.result.slice(reader.result.indexOf(",") + 1);
}
