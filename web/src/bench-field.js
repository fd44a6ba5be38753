/** Input field of one key: its value, meaning and allowed values, and the reason for a refusal. */

import { make } from "./elements.js";
import { capital } from "./format.js";

const LONG = 40; // letters above which a value gets several lines
let counted = 0;

/** Make the field of a key; `changed` receives the new text, "" to restore the value of the design. */
export function makeField(fact, changed) {
  const name = `key-${++counted}`;
  const last = fact.key.split(".").at(-1).replaceAll("_", " ");
  const input = makeInput(fact, name);
  const home = make("button", { type: "button", className: "home", hidden: true }, "undo");
  const wrong = make("p", { className: "wrong", id: `${name}-wrong` });
  let was = ""; // last text displayed or sent: text typed since is left alone
  const notes = make("p", { className: "note", id: `${name}-notes` });
  const element = make(
    "div",
    { className: "field" },
    make("label", { htmlFor: name, title: fact.key }, last),
    make("span", { className: "entry" }, input, ...lists(fact, name), home),
    wrong,
    notes,
  );
  input.setAttribute("aria-describedby", `${name}-wrong ${name}-notes`);
  input.addEventListener("change", () => {
    was = input.value.trim();
    changed(was);
  });
  home.addEventListener("click", () => {
    changed("");
    input.focus();
  });
  home.setAttribute("aria-label", `undo the change of ${last}`);
  /** Display the present value, whether it was changed, and the previous value. */
  function show(now, setting, base) {
    if (document.activeElement !== input || input.value.trim() === was) input.value = setting ?? now.value;
    was = input.value.trim();
    reject("");
    const changedFrom = setting === undefined ? null : base?.value || "left out";
    element.classList.toggle("changed", changedFrom !== null);
    home.hidden = changedFrom === null;
    const left = now.default && now.default !== "needed" ? `if left out ${now.default}` : "";
    const parts = [now.allowed, changedFrom === null ? left : `was ${changedFrom}`, now.chosen && `chosen: ${now.chosen}`];
    const may = parts.filter(Boolean).join(" \u00b7 ").replaceAll(">=", "\u2265").replaceAll("<=", "\u2264");
    notes.replaceChildren(capital(now.meaning), make("span", { className: "may" }, may));
  }

  /** Display the reason for refusing a text, which stays in the field; "" to clear the reason. */
  function reject(why, text) {
    if (text !== undefined) input.value = was = text;
    wrong.textContent = why;
    element.classList.toggle("rejected", why !== "");
    if (why) {
      input.setAttribute("aria-invalid", "true");
      home.hidden = false;
    } else input.removeAttribute("aria-invalid");
  }

  return { element, input, fact, show, reject };
}

function makeInput({ key, value, words, onlyWords, default: left }, id) {
  if (onlyWords) {
    const none = value ? [] : [make("option", { value: "" }, left && left !== "needed" ? `left out: ${left}` : "left out")];
    return make("select", { id, "data-key": key }, ...none, ...words.map((word) => make("option", { value: word }, word)));
  }
  const plain = { id, spellcheck: false, autocomplete: "off", "autocapitalize": "off", "data-key": key };
  if (value.length > LONG) return make("textarea", { ...plain, rows: Math.min(6, Math.ceil(value.length / LONG)) });
  const input = make("input", { ...plain, type: "text" });
  if (words.length) input.setAttribute("list", `${id}-words`);
  return input;
}

/** The list of suggestions for a field that also takes other texts. */
function lists({ words, onlyWords, value }, name) {
  if (onlyWords || !words.length || value.length > LONG) return [];
  return [make("datalist", { id: `${name}-words` }, ...words.map((value) => make("option", { value })))];
}
