/** Page of a workbench: a design whose keys can be changed, which the server builds, and which is displayed live. */

import { keptDesign, makeDesign } from "./bench-design.js";
import { makeFile } from "./bench-file.js";
import { makeKeys } from "./bench-keys.js";
import { makeOpening } from "./bench-open.js";
import { makeResults } from "./bench-results.js";
import { makeSays, makeTaking } from "./bench-says.js";
import { makeSheet } from "./bench-sheet.js";
import { makeSlid } from "./bench-slid.js";
import { makeTabs } from "./bench-tabs.js";
import { makeWing } from "./bench-wing.js";
import { make } from "./elements.js";
import { capital } from "./format.js";
import { makeTracing } from "./trace-panel.js";

const RESULTS = {
  landscape: { button: "Compute it", text: "Statics computes the equilibria, the barriers between them, and the motion under the drives.", title: "landscape" },
  run: { button: "Run it", text: "The package simulates the protocol, checks the energy balance and reports the outcome.", title: "run" },
};

export async function showWorkbench(data) {
  const says = makeSays();
  let queue = Promise.resolve();
  const next = (job) => (queue = queue.then(job).catch((error) => says.refuse(error.message)));
  const design = makeDesign({
    says,
    reply: show,
    picture: (wanted, fresh) => views.wing.begin(wanted, fresh),
    model: build,
    resume: () => views.wing.resume(),
  });
  const slid = makeSlid((settings) => next(() => design.slide(settings)));
  let last = null;
  /** Open a design after what is being done; a design that is still waiting then is not opened. */
  const open = (where) => {
    last = where;
    return next(() => last === where && design.open(where, {}));
  };
  /** Open a pattern that is traced; keys and slider stay as long as its file has the same name. Returns the refusal. */
  const openTraced = (where) => {
    last = where;
    return next(async () => {
      if (last !== where) return "a later design is opened";
      const { asked } = design;
      const again = asked?.files[0]?.name === where.files[0].name;
      const kept = again ? asked.settings : {};
      const why = await design.open(where, kept, !again);
      return why && Object.keys(kept).length ? design.open(where, {}) : why;
    });
  };
  const opening = makeOpening(data.designs, data.opened, open, (picture) => {
    views.tabs.choose("trace");
    return views.tracing.take(picture);
  });
  const keys = makeKeys((key, text) => {
    slid.hand();
    next(() => design.change(key, text));
  });
  const views = makeViews(design, slid, open, openTraced);
  const taking = makeTaking();

  /** Display a design, and the keys that were set or refused. */
  function show({ asked, base, reply, rejected }) {
    document.title = `${reply.title}: workbench`;
    document.querySelector("h1").textContent = reply.title;
    opening.show(asked);
    keys.show(reply, asked.settings, base);
    for (const [key, { text, why }] of rejected) keys.reject(key, text, why);
    views.file.show(reply);
    taking.show(reply);
    views.tabs.seen();
  }

  async function build(model) {
    await views.wing.show(model);
    views.tabs.name("wing", capital(views.wing.whole));
  }

  const head = make("div", { className: "masthead" }, opening.element, taking.element, says.element);
  document.getElementById("workbench").append(head, keys.element, views.tabs.element);
  views.tabs.choose("wing");
  await next(() => begin(design, data));
  return Object.assign(design, { wing: views.wing, tracing: views.tracing, idle: () => queue });
}

/** Open the design from before a reload, or else the one with which the workbench was started. */
async function begin(design, data) {
  const kept = keptDesign();
  if (kept && !(await design.open({ design: kept.design, files: kept.files, unit: kept.unit }, kept.settings))) return;
  await design.open({ design: "", files: [], unit: "" }, data.settings);
}

/** Views of its structure, its pattern, results on demand, and its file. */
function makeViews(design, slid, open, openTraced) {
  const asked = () => design.asked;
  const results = Object.fromEntries(Object.entries(RESULTS).map(([what, words]) => [what, makeResults(what, words, asked)]));
  const wing = makeWing(asked, slid.put, () => {
    tabs.choose("run");
    results.run.find();
  });
  const sheet = makeSheet(asked);
  const file = makeFile((text) => open({ design: "", files: [{ name: `${design.reply?.name ?? "design"}.toml`, text }], unit: "" }));
  // the structure is displayed alone, or beside the picture that is traced
  const alone = make("div", {}, wing.element);
  const tracing = makeTracing(openTraced, wing.element);
  const tabs = makeTabs(
    [
      { name: "wing", title: "Structure", element: alone, seen: () => wing.element.parentElement !== alone && alone.append(wing.element) },
      { name: "sheet", title: "Pattern", ...sheet },
      { name: "trace", title: "Trace", element: tracing.element, seen: tracing.seen },
      { name: "landscape", title: "Landscape", ...results.landscape },
      { name: "run", title: "Run", ...results.run },
      { name: "file", title: "File", element: file.element },
    ],
    "views of the design",
  );
  return { tabs, wing, file, tracing };
}
