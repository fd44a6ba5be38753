/** Controls of tracing: tools, kinds of edges, sliders of the picture, and lines of text with a button. */

import { make } from "./elements.js";
import { capital } from "./format.js";
import { LETTERS } from "./trace-pattern.js";

const TOOLS = { draw: "Draw", move: "Select and move", scale: "Set the scale" };

/** A choice of one word by radio buttons; `chosen` receives its key. */
function makeChoice(title, name, words, chosen, mark = () => []) {
  const inputs = Object.entries(words).map(([value, text]) => {
    const input = make("input", { type: "radio", name, value });
    input.addEventListener("change", () => chosen(value));
    return [input, make("label", {}, input, ...mark(value), ` ${text}`)];
  });
  return {
    element: make("fieldset", { className: "trace-choice" }, make("legend", {}, title), ...inputs.map(([, label]) => label)),
    show: (value) => inputs.forEach(([input]) => (input.checked = input.value === value)),
  };
}

/** The choice of the tool. */
export const makeTools = (chosen) => makeChoice("Tool", "trace-tool", TOOLS, chosen);

/** The choice of the kind of edges, with a sample of each. */
export function makeKinds(chosen) {
  const words = Object.fromEntries(Object.entries(LETTERS).map(([letter, word]) => [letter, `${capital(word)} (${letter})`]));
  return makeChoice("Edges", "trace-kind", words, chosen, (letter) => {
    const sample = document.createElementNS("http://www.w3.org/2000/svg", "svg");
    const line = document.createElementNS("http://www.w3.org/2000/svg", "line");
    for (const [key, value] of Object.entries({ x1: 1, y1: 5, x2: 29, y2: 5, class: `crease crease-${letter}` })) line.setAttribute(key, value);
    sample.setAttribute("viewBox", "0 0 30 10");
    sample.setAttribute("aria-hidden", "true");
    sample.append(line);
    return [sample];
  });
}

/** Sliders of the opacity and the brightness of a picture. */
export function makeLooks(image) {
  const slider = (text, most, value, apply) => {
    const input = make("input", { type: "range", min: 0, max: most, value });
    input.addEventListener("input", () => apply(input.value));
    apply(value);
    return make("label", {}, `${text} `, input);
  };
  return make(
    "div",
    { className: "choices" },
    slider("Opacity of the picture", 100, 60, (value) => (image.style.opacity = value / 100)),
    slider("Brightness", 200, 100, (value) => (image.style.filter = `brightness(${value}%)`)),
  );
}

/** A field of text with a button beside it; `act` receives the text. */
export function makeEntry(label, { id, placeholder, button, note = "" }, act) {
  const input = make("input", { type: "text", id, placeholder, size: 13, spellcheck: false });
  const press = make("button", { type: "button" }, button);
  const text = make("span", {}, label);
  const run = () => act(input.value.trim());
  press.addEventListener("click", run);
  input.addEventListener("keydown", ({ key }) => key === "Enter" && run());
  const element = make("div", { className: "trace-entry" }, make("label", { htmlFor: id }, text, input), press, ...(note ? [make("p", { className: "note" }, note)] : []));
  return { element, input, button: press, label: text };
}

/** A button that is disabled until there is something to do. */
export function makeAct(text, title, act) {
  const button = make("button", { type: "button", title }, text);
  button.addEventListener("click", act);
  return button;
}
