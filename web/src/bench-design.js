/** The design of a workbench: the design that was opened, the keys that were set, and the server's replies. */

import { ask } from "./bench-ask.js";

const KEPT = `forficula ${location.pathname}`; // key of the session storage, which survives a reload

/**
 * A design that is opened, changed and built, one request after another.
 *
 * shows: {says, reply, picture, model, resume}: displays what is being done and what was refused, the design with its
 * keys, the first picture of its structure (awaited: {shown}, or {refused} with the reason), and its structure (awaited);
 * `resume` is called after a refusal. The design has `asked`, the request; `base`, the reply for the design as opened; `reply`, the
 * present reply; and `rejected`, texts of keys that were refused, with reasons.
 */
export function makeDesign(shows) {
  const design = { asked: null, base: null, reply: null, rejected: new Map() };

  /** Open a design in place of another; returns the reason if it is refused, otherwise "". A fresh one begins unfolded. */
  design.open = async (where, settings, fresh = true) => {
    const name = where.files[0]?.name || where.design || "the design";
    const wanted = { ...where, settings };
    shows.says.wait(`Opening ${name}`);
    const picture = shows.picture(wanted, fresh);
    const base = await ask("design", { ...where, settings: {} });
    const why = base.refused ?? (await build(wanted, base, picture));
    if (why) {
      shows.says.refuse(`${name} is not opened: ${why}`);
      shows.resume();
    } else design.rejected.clear();
    if (design.reply) display(design.reply);
    return why;
  };

  /**
   * Build a request and display it; returns the reason if that is impossible, otherwise "".
   *
   * base: the reply for the design as opened; picture: its first picture, if that was requested before.
   */
  async function build(wanted, base, picture = null) {
    const began = performance.now();
    const stopping = new AbortController();
    const accept = () => {
      Object.assign(design, { asked: wanted, base });
      display(reply);
    };
    shows.says.wait("Building", () => stopping.abort());
    let reply = base;
    try {
      if (Object.keys(wanted.settings).length) reply = await ask("design", wanted, stopping.signal);
      if (reply.refused) return reply.refused;
      const first = await stoppable(picture ?? shows.picture(wanted, false), stopping.signal);
      if (first.refused) return first.refused;
      if (first.shown) {
        accept();
        shows.says.wait("Building");
      }
      const model = await ask("model", wanted, first.shown ? undefined : stopping.signal);
      if (model.refused && !first.shown) return model.refused;
      if (!first.shown) accept();
      await shows.model(model.refused ? { live: model, warnings: [] } : model);
      shows.says.done(`Built in ${((performance.now() - began) / 1000).toFixed(1)} s.`);
    } catch (error) {
      if (error.name !== "AbortError") throw error;
      return "building was stopped";
    }
    return "";
  }

  /** Change a key, together with refused changes or alone; a refusal is displayed beside the key. */
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
      shows.says.refuse(`${why} \u2013 the last working model is kept`);
      shows.resume();
    } else if (same(alone, asked.settings)) shows.says.done("");
    display(design.reply);
  };

  /** Record values that were changed during the simulation; nothing is built again. */
  design.slide = async (changed) => {
    const settings = put(design.asked.settings, Object.entries(changed));
    const reply = await ask("design", { ...design.asked, settings });
    if (reply.refused) return shows.says.refuse(reply.refused);
    design.asked = { ...design.asked, settings };
    return display(reply);
  };

  /** Merge changes into settings; empty texts and the values of the opened design are removed. */
  function put(settings, changes) {
    const changed = { ...settings };
    for (const [key, text] of changes) {
      if (text === "" || text === design.base.keys.find((fact) => fact.key === key)?.value) delete changed[key];
      else changed[key] = text;
    }
    return changed;
  }

  function display(reply) {
    design.reply = reply;
    keep(design.asked);
    shows.reply(design);
  }

  return design;
}

/** A promise that is rejected once a signal aborts. */
function stoppable(promise, signal) {
  const stopped = new Promise((_, reject) => signal.addEventListener("abort", () => reject(signal.reason)));
  return Promise.race([promise, stopped]);
}

const same = (one, other) => JSON.stringify(Object.entries(one).sort()) === JSON.stringify(Object.entries(other).sort());

/** The request before the page was reloaded, or null. */
export function keptDesign() {
  return JSON.parse(sessionStorage.getItem(KEPT) ?? "null");
}

/** Store the request, if the browser has space. */
function keep(asked) {
  try {
    sessionStorage.setItem(KEPT, JSON.stringify(asked));
  } catch {
    sessionStorage.removeItem(KEPT);
  }
}
