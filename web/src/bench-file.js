/** A workbench's design as a file: to read, to download, and to edit. */

import { make } from "./elements.js";

/** build: receives the text of a file to open in place of the design. */
export function makeFile(build) {
  const text = make("textarea", { id: "file-text", className: "file", rows: 24, spellcheck: false, "aria-describedby": "file-note" });
  const button = make("button", { type: "button" }, "Build this text");
  const note = "Add or remove stages, tendons and whole sections here. The result counts as a new design file.";
  const element = make(
    "div",
    {},
    make("label", { htmlFor: "file-text" }, "The design file"),
    make("p", { className: "note", id: "file-note" }, note),
    text,
    make("p", { className: "choices" }, button),
  );
  button.addEventListener("click", () => build(text.value));
  let last = "";
  return {
    element,
    /** Display a design's file; edited text stays as long as the same file is displayed. */
    show(reply) {
      if (reply.text !== last) text.value = last = reply.text;
    },
  };
}

/** Return text as an address to download. */
export function asAddress(text, kind) {
  let letters = "";
  for (const byte of new TextEncoder().encode(text)) letters += String.fromCharCode(byte);
  return `data:${kind};base64,${btoa(letters)}`;
}
