/** Choice of the workbench's design: a named one, or files that are dropped on the page or selected. */

import { make } from "./elements.js";
import { isPicture } from "./trace-panel.js";

/** open: receives {design} or {files, unit}; trace: receives a picture. */
export function makeOpening(designs, opened, open, trace) {
  const given = make("option", { value: "" }, opened);
  const named = designs.filter(({ name }) => name !== opened).map(({ name, shows }) => make("option", { value: name, title: shows }, name));
  const choice = make("select", { id: "which-design" }, given, ...named);
  const files = make("input", { type: "file", id: "which-files", multiple: true, accept: ".toml,.fold,.svg,.dxf,.png,.jpg,.jpeg", className: "spoken" });
  const unit = make("input", { type: "text", id: "which-unit", placeholder: "1 cm", size: 6, spellcheck: false });
  const hint = "A design (.toml, with the files that it names), a FOLD file or a drawing (.svg, .dxf), or a picture to trace (.png, .jpg), can be dropped anywhere on the page.";
  const drop = make("label", { className: "button", htmlFor: "which-files" }, "Open files \u2026");
  const element = make(
    "div",
    { className: "opening choices" },
    make("label", { htmlFor: "which-design" }, "design ", choice),
    make("span", { className: "choosing" }, files, drop),
    make("label", { htmlFor: "which-unit", title: "for a FOLD file or a drawing without a unit" }, "unit of a drawing ", unit),
    make("p", { className: "note" }, hint),
  );
  choice.addEventListener("change", () => open({ design: choice.value, files: [], unit: "" }));
  files.addEventListener("change", async () => {
    if (files.files.length) await take([...files.files]);
    files.value = "";
  });
  unit.addEventListener("change", () => {
    if (last) open({ design: "", files: last, unit: unit.value.trim() });
  });
  let last = null;

  async function take(chosen) {
    const picture = chosen.find(isPicture);
    if (picture) {
      await trace(picture);
      return;
    }
    const read = await Promise.all(chosen.map(async (file) => ({ name: file.name, text: await file.text() })));
    last = inOrder(read);
    await open({ design: "", files: last, unit: unit.value.trim() });
  }

  listenToDrops(take);
  return {
    element,
    /** Display the design that is open now. */
    show({ design, files: sent }) {
      choice.querySelector(".sent")?.remove();
      if (sent.length) choice.append(make("option", { value: sent[0].name, className: "sent" }, sent[0].name));
      choice.value = sent.length ? sent[0].name : design;
      last = sent.length ? sent : null;
    },
  };
}

/** Put the design first: a design file that no other file names, or the only file. */
function inOrder(files) {
  const designs = files.filter(({ name }) => /\.toml$/i.test(name));
  const first = designs.find(({ name }) => !designs.some((other) => other.name !== name && other.text.includes(name))) ?? files[0];
  return [first, ...files.filter((file) => file !== first)];
}

function listenToDrops(take) {
  const { body } = document;
  const over = (event) => {
    if (!event.dataTransfer?.types.includes("Files")) return;
    event.preventDefault();
    body.classList.add("dropping");
  };
  body.addEventListener("dragenter", over);
  body.addEventListener("dragover", over);
  body.addEventListener("dragleave", (event) => {
    if (!event.relatedTarget) body.classList.remove("dropping");
  });
  body.addEventListener("drop", (event) => {
    body.classList.remove("dropping");
    if (!event.dataTransfer?.files.length) return;
    event.preventDefault();
    take([...event.dataTransfer.files]);
  });
}
