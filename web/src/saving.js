/** Files that a page makes and a reader saves: buttons, and pictures from SVG. */

import { make } from "./elements.js";

const SHARP = 3; // pixels of a saved plot for one of the page
const KEPT = 10_000; // ms for which a file can be fetched from its address

/** Offer a file to the reader. */
export function save(blob, name) {
  const address = URL.createObjectURL(blob);
  make("a", { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), KEPT);
}

/** A name for a file: what the page is about, without values that differ, and words, with dashes. */
export function fileName(words) {
  const text = `${document.title.split(/: | with /)[0]} ${words}`.toLowerCase().normalize("NFKD").replace(/[^a-z0-9.]+/g, "-").replace(/^-+|-+$/g, "");
  return text || "plot";
}

/** A button that saves something as a kind of file. */
export function saveButton(kind, what, act) {
  const button = make("button", { type: "button", "aria-label": `download ${kind} of ${what}`, title: `download as ${kind}` }, kind);
  button.addEventListener("click", act);
  return button;
}

/**
 * Buttons that save a drawing as PNG and as SVG; `drawing` returns {svg, width, height} when one is pressed, and `name`
 * the name of the file without its ending.
 */
export function makeSaveButtons(what, name, drawing) {
  const svg = () => save(new Blob([drawing().svg], { type: "image/svg+xml" }), `${name()}.svg`);
  const png = async () => save(await pngOf(drawing()), `${name()}.png`);
  return make("span", { className: "saves" }, saveButton("PNG", what, png), saveButton("SVG", what, svg));
}

/** The PNG of an SVG, by the browser. */
async function pngOf({ svg, width, height }) {
  const address = URL.createObjectURL(new Blob([svg], { type: "image/svg+xml" }));
  try {
    const image = make("img", { width, height });
    await new Promise((done, failed) => {
      image.onload = done;
      image.onerror = failed;
      image.src = address;
    });
    const canvas = make("canvas", { width: SHARP * width, height: SHARP * height });
    canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
    return await new Promise((done) => canvas.toBlob(done, "image/png"));
  } finally {
    URL.revokeObjectURL(address);
  }
}
