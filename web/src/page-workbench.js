/** The page of a workbench: a design whose every key can be changed, built again by the server, and seen from all sides. */

import { ask } from "./bench-ask.js";
import { asAddress, makeFile } from "./bench-file.js";
import { makeKeys } from "./bench-keys.js";
import { makeOpening } from "./bench-open.js";
import { makeResults } from "./bench-results.js";
import { makeSheet } from "./bench-sheet.js";
import { makeTabs } from "./bench-tabs.js";
import { makeWing } from "./bench-wing.js";
import { make } from "./elements.js";
import { capital } from "./format.js";

const KEPT = `forficula ${location.pathname}`; // under which a reload finds what was changed
const SLID = 250; // ms after which a slider has come to rest
const PATIENCE = 1500; // ms from which on a building can be stopped

const RESULTS = {
  landscape: { button: "Survey it", text: "Statics finds where it rests, what lies between, and what its drives do.", title: "landscape" },
  run: { button: "Run it", text: "The package takes it through its protocol, looks at the energy balance, and tells what came of it.", title: "run" },
};

export async function showWorkbench(data) {
  const bench = { asked: null, base: null, told: null, rejected: new Map(), busy: false };
  const says = makeSays();
  let queue = Promise.resolve();
  const next = (job) => (queue = queue.then(job).catch((error) => says.refuse(error.message)));
  const asked = () => bench.asked;
  const slid = makeSlid((settings) => next(() => slide(settings)));
  const keys = makeKeys((key, text) => next(() => change(key, text)));
  const opening = makeOpening(data.designs, data.opened, (where) => next(() => open(where, {})));
  const file = makeFile((text) => next(() => open({ design: "", files: [{ name: fileName(), text }], unit: "" }, {})));
  const results = Object.fromEntries(Object.entries(RESULTS).map(([what, words]) => [what, makeResults(what, words, asked)]));
  const wing = makeWing(slid.put, () => {
    tabs.choose("run");
    results.run.find();
  });
  const sheet = makeSheet(asked);
  const tabs = makeTabs(
    [
      { name: "wing", title: "Structure", element: wing.element },
      { name: "sheet", title: "Pattern", ...sheet },
      { name: "landscape", title: "Landscape", ...results.landscape },
      { name: "run", title: "Run", ...results.run },
      { name: "file", title: "File", element: file.element },
    ],
    "views of the design",
  );
  const taking = makeTaking();
  const main = document.getElementById("workbench");
  main.append(make("div", { className: "masthead" }, opening.element, taking.element, says.element), keys.element, tabs.element);
  tabs.choose("wing");

  const fileName = () => `${bench.told?.name ?? "design"}.toml`;

  /** Open a design in the place of another; where it cannot be, that one stays. */
  async function open(where, settings) {
    says.wait(`Opening ${where.files[0]?.name ?? where.design}`);
    const base = await ask("design", { ...where, settings: {} });
    const why = base.refused ?? (await build({ ...where, settings }, base));
    if (!why) bench.rejected.clear();
    else says.refuse(`${where.files[0]?.name || where.design || data.opened} is not opened: ${why}`);
    if (bench.asked) opening.show(bench.asked);
    return why;
  }

  /** Build what is asked and show it; returns why that cannot be, "" where it is done. */
  async function build(wanted, base) {
    const began = performance.now();
    const stopping = new AbortController();
    says.wait("Building", () => stopping.abort());
    try {
      const told = await ask("design", wanted, stopping.signal);
      if (told.refused) return told.refused;
      const model = await ask("model", wanted, stopping.signal);
      if (model.refused) return model.refused;
      slid.taken();
      Object.assign(bench, { asked: wanted, base });
      tell(told);
      await wing.show(model);
      tabs.name("wing", capital(model.bench.whole));
      says.done(`Built in ${((performance.now() - began) / 1000).toFixed(1)} s.`);
    } catch (error) {
      if (error.name !== "AbortError") throw error;
      return "building it was stopped";
    }
    tabs.seen();
    return "";
  }

  /** Change a key, with those that wait for another to be changed, or alone; what is refused is told beside it. */
  async function change(key, text) {
    const now = { ...bench.asked.settings, ...slid.settings };
    const { rejected } = bench;
    const others = [...rejected].filter(([other]) => other !== key).map(([other, { text: its }]) => [other, its]);
    const tries = [...(others.length ? [put(now, [...others, [key, text]])] : []), put(now, [[key, text]])];
    let why = "";
    for (const settings of tries) {
      why = same(settings, bench.asked.settings) ? "" : await build({ ...bench.asked, settings }, bench.base);
      if (why) continue;
      if (settings === tries[0]) rejected.clear();
      else rejected.delete(key);
      break;
    }
    if (why) {
      rejected.set(key, { text, why });
      says.refuse(`${why} \u2013 the last good model stays`);
    }
    tell(bench.told);
  }

  /** Take over what was changed while it moves: nothing is built again. */
  async function slide(changed) {
    const settings = put(bench.asked.settings, Object.entries(changed));
    const told = await ask("design", { ...bench.asked, settings });
    if (told.refused) {
      says.refuse(told.refused);
      return;
    }
    bench.asked = { ...bench.asked, settings };
    tell(told);
    tabs.seen();
  }

  /** Settings with some in their place; what is as the design has it, or empty, is none. */
  function put(settings, changes) {
    const changed = { ...settings };
    for (const [key, text] of changes) {
      if (text === "" || text === bench.base.keys.find((fact) => fact.key === key)?.value) delete changed[key];
      else changed[key] = text;
    }
    return changed;
  }

  function tell(told) {
    bench.told = told;
    document.title = `${told.title}: workbench`;
    document.querySelector("h1").textContent = told.title;
    keys.show(told, bench.asked.settings, bench.base);
    for (const [key, { text, why }] of bench.rejected) keys.reject(key, text, why);
    file.show(told);
    taking.show(told, fileName());
    keep(bench.asked);
  }

  const kept = JSON.parse(sessionStorage.getItem(KEPT) ?? "null");
  const first = { design: "", files: [], unit: "" };
  const begin = async () => {
    if (kept && !(await open({ design: kept.design, files: kept.files, unit: kept.unit }, kept.settings))) return;
    await open(first, data.settings);
  };
  await next(begin);
  return Object.assign(bench, { wing, keys, tabs, results, idle: () => queue });
}

const same = (one, other) => JSON.stringify(Object.entries(one).sort()) === JSON.stringify(Object.entries(other).sort());

/** Keep what is asked for a reload, where the browser has room for it. */
function keep(asked) {
  try {
    sessionStorage.setItem(KEPT, JSON.stringify(asked));
  } catch {
    sessionStorage.removeItem(KEPT);
  }
}

/** What is being done, and what was refused. */
function makeSays() {
  const said = make("p", { role: "status" });
  const wrong = make("p", { className: "wrong", role: "alert" });
  const stop = make("button", { type: "button", hidden: true }, "Stop building");
  let waiting = 0;
  let end = null;
  stop.addEventListener("click", () => end?.());

  function show(text, refused = "") {
    clearTimeout(waiting);
    stop.hidden = true;
    said.textContent = text;
    wrong.textContent = refused;
  }

  return {
    element: make("div", { className: "says" }, said, stop, wrong),
    wait(text, ending) {
      show(`${text} \u2026`);
      end = ending;
      if (ending) waiting = setTimeout(() => (stop.hidden = false), PATIENCE);
    },
    done: (text) => show(text),
    refuse: (why) => show("", why.endsWith(".") ? why : `${why}.`),
  };
}

/** What sliders have changed, handed on once they are at rest. */
function makeSlid(done) {
  let settings = {};
  let timer = 0;
  return {
    get settings() {
      return settings;
    },
    put(key, text) {
      settings[key] = text;
      clearTimeout(timer);
      timer = setTimeout(() => {
        const changed = settings;
        settings = {};
        done(changed);
      }, SLID);
    },
    taken() {
      clearTimeout(timer);
      settings = {};
    },
  };
}

/** The design to be taken away: its file, and the command that runs it. */
function makeTaking() {
  const link = make("a", { className: "button" }, "Download the design");
  const command = make("code");
  const element = make("div", { className: "taking" }, link, make("pre", { tabIndex: 0, role: "group", "aria-label": "the command that runs it" }, command));
  return {
    element,
    show(told, name) {
      link.href = asAddress(told.text, "application/toml");
      link.download = name;
      command.textContent = told.command;
    },
  };
}
