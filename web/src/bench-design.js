/** The design of a workbench: what was opened and which keys were set, and what the server says to a change of it. */

import { ask } from "./bench-ask.js";

const KEPT = `forficula ${location.pathname}`; // under which a reload finds what was changed

/**
 * A design that is opened, changed and built, one after another.
 *
 * shows: {says, told, model}: says what is being done and what was refused, shows the design and its keys, and its
 * structure, which is waited for. It has `asked`, what the server is asked of it; `base`, what was told of it as it was
 * opened; `told`, as it is; and `rejected`, texts of keys that were refused, each with why.
 */
export function makeDesign(shows) {
  const design = { asked: null, base: null, told: null, rejected: new Map() };

  /** Open a design in the place of another; returns why that one stays, "" where it does not. */
  design.open = async (where, settings) => {
    const name = where.files[0]?.name || where.design || "the design";
    shows.says.wait(`Opening ${name}`);
    const base = await ask("design", { ...where, settings: {} });
    const why = base.refused ?? (await build({ ...where, settings }, base));
    if (why) shows.says.refuse(`${name} is not opened: ${why}`);
    else design.rejected.clear();
    if (design.told) tell(design.told);
    return why;
  };

  /** Build what is asked and show it; returns why that cannot be, "" where it is done. */
  async function build(wanted, base) {
    const began = performance.now();
    const stopping = new AbortController();
    shows.says.wait("Building", () => stopping.abort());
    try {
      const told = await ask("design", wanted, stopping.signal);
      if (told.refused) return told.refused;
      const model = await ask("model", wanted, stopping.signal);
      if (model.refused) return model.refused;
      Object.assign(design, { asked: wanted, base });
      tell(told);
      await shows.model(model);
      shows.says.done(`Built in ${((performance.now() - began) / 1000).toFixed(1)} s.`);
    } catch (error) {
      if (error.name !== "AbortError") throw error;
      return "building it was stopped";
    }
    return "";
  }

  /** Change a key, with those that wait for another to be changed, or alone; what is refused is told beside it. */
  design.change = async (key, text) => {
    const { asked, rejected } = design;
    const others = [...rejected].filter(([other]) => other !== key).map(([other, its]) => [other, its.text]);
    const alone = put(asked.settings, [[key, text]]);
    const tries = others.length ? [put(asked.settings, [...others, [key, text]]), alone] : [alone];
    let why = "";
    for (const settings of tries) {
      why = same(settings, asked.settings) ? "" : await build({ ...asked, settings }, design.base);
      if (why) continue;
      if (settings === tries[0]) rejected.clear();
      else rejected.delete(key);
      break;
    }
    if (why) {
      rejected.set(key, { text, why });
      shows.says.refuse(`${why} \u2013 the last good model stays`);
    } else if (same(alone, asked.settings)) shows.says.done("");
    tell(design.told);
  };

  /** Take over values that were changed while it moves: nothing is built again. */
  design.slide = async (changed) => {
    const settings = put(design.asked.settings, Object.entries(changed));
    const told = await ask("design", { ...design.asked, settings });
    if (told.refused) return shows.says.refuse(told.refused);
    design.asked = { ...design.asked, settings };
    return tell(told);
  };

  /** Settings with some in their place; what is as the design has it, or empty, is none. */
  function put(settings, changes) {
    const changed = { ...settings };
    for (const [key, text] of changes) {
      if (text === "" || text === design.base.keys.find((fact) => fact.key === key)?.value) delete changed[key];
      else changed[key] = text;
    }
    return changed;
  }

  function tell(told) {
    design.told = told;
    keep(design.asked);
    shows.told(design);
  }

  return design;
}

const same = (one, other) => JSON.stringify(Object.entries(one).sort()) === JSON.stringify(Object.entries(other).sort());

/** What was asked before the page was loaded again, or null. */
export function keptDesign() {
  return JSON.parse(sessionStorage.getItem(KEPT) ?? "null");
}

/** Keep it, where the browser has room. */
function keep(asked) {
  try {
    sessionStorage.setItem(KEPT, JSON.stringify(asked));
  } catch {
    sessionStorage.removeItem(KEPT);
  }
}
