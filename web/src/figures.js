/** Figures that were drawn for paper: buttons that save them, as PNG at the width of a page and as SVG at that of a column. */

import { make } from "./elements.js";
import { fileName, save, saveButton } from "./saving.js";

export function mountFigures() {
  for (const figure of document.querySelectorAll("figure.drawn")) {
    const [image, source] = [figure.querySelector("img"), figure.querySelector("source")];
    const name = figure.closest("section")?.id ?? "figure";
    const buttons = [["PNG", image.src], ["SVG", source.srcset]].map(([kind, address]) =>
      saveButton(kind, `the figure ${name}`, () => save(blobOf(address), `${fileName(name)}.${kind.toLowerCase()}`)),
    );
    figure.append(make("div", { className: "saves save-foot" }, ...buttons));
  }
}

/** The contents of an address that contains them; the page may fetch nothing. */
function blobOf(address) {
  const [head, content] = address.split(",");
  const letters = atob(content);
  return new Blob([Uint8Array.from(letters, (letter) => letter.charCodeAt(0))], { type: /:(.*?);/.exec(head)[1] });
}
