/** A workbench's design as a file: to be read, taken away, and written by hand. */

import { make } from "./elements.js";

/** build: told the text of a file that is to be opened in the place of the design. */
export function makeFile(build) {
  const text = make("textarea", { id: "file-text", className: "file", rows: 24, spellcheck: false, "aria-describedby": "file-note" });
  const button = make("button", { type: "button" }, "Build what stands here");
  const note = "Stages, tendons and whole sections are added and taken away here; what is built counts as a file of its own.";
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
    /** Show a design's file; what was written by hand stays where that is the one that was shown. */
    show(told) {
      if (told.text !== last) text.value = last = told.text;
    },
  };
}

/** Text as an address that is downloaded. */
export function asAddress(text, kind) {
  let letters = "";
  for (const byte of new TextEncoder().encode(text)) letters += String.fromCharCode(byte);
  return `data:${kind};base64,${btoa(letters)}`;
}
