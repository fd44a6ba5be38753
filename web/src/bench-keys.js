/** All keys of a design, by section, to search and change. */

import { makeField } from "./bench-field.js";
import { make } from "./elements.js";
import { capital } from "./format.js";

const FIRST = ["pattern", "tendon"]; // sections that are open at the start

/** Make the list of a design's keys; `changed` receives a key and its text. */
export function makeKeys(changed) {
  const search = make("input", { type: "search", id: "find-key", spellcheck: false, placeholder: "stiffness, length, torque \u2026" });
  const count = make("p", { className: "note", role: "status" });
  const sections = make("div", { className: "sections" });
  const element = make(
    "section",
    { className: "keys-of-design", "aria-label": "keys of the design" },
    make("h2", {}, "Keys"),
    make("label", { className: "find", htmlFor: "find-key" }, "Find a key", search),
    count,
    sections,
  );
  let fields = new Map();
  let groups = [];
  search.addEventListener("input", find);

  function find() {
    const words = search.value.toLowerCase().split(/\s+/).filter(Boolean);
    let matches = 0;
    for (const { fact, element: row } of fields.values()) {
      const text = `${fact.key.replaceAll("_", " ")} ${fact.key} ${fact.meaning}`.toLowerCase();
      row.hidden = !words.every((word) => text.includes(word));
      matches += row.hidden ? 0 : 1;
    }
    for (const group of groups) {
      group.element.hidden = group.fields.every((field) => field.element.hidden);
      for (const { heading, fields: own } of group.parts) heading.hidden = own.every((field) => field.element.hidden);
      if (words.length && !group.element.hidden) group.element.open = true;
    }
    count.textContent = words.length ? `${matches} of ${fields.size} keys` : `${fields.size} keys; enter values with units, as in a design file`;
  }

  /** Display a design's keys, those that were set, and their previous values. */
  function show(reply, settings, base) {
    const before = new Map(base.keys.map((fact) => [fact.key, fact]));
    if (!sameKeys(reply.keys, fields)) build(reply);
    for (const fact of reply.keys) fields.get(fact.key).show(fact, settings[fact.key], before.get(fact.key));
    for (const group of groups) group.count(settings);
    find();
  }

  function build(reply) {
    const open = new Set(groups.length ? groups.filter(({ element: each }) => each.open).map(({ name }) => name) : FIRST);
    const focused = document.activeElement?.dataset?.key;
    fields = new Map(reply.keys.map((fact) => [fact.key, makeField(fact, (text) => changed(fact.key, text))]));
    const names = new Set(reply.keys.map(({ key }) => (key.includes(".") ? key.split(".")[0] : "")));
    groups = [...names].sort((one, other) => (other === "" ? -1 : 0) - (one === "" ? -1 : 0)).map((name) => makeGroup(name, reply, fields));
    for (const group of groups) group.element.open = open.has(group.name);
    sections.replaceChildren(...groups.map((group) => group.element));
    if (focused) fields.get(focused)?.input.focus();
  }

  /** Display beside a key why its text was refused. */
  function reject(key, text, why) {
    const field = fields.get(key);
    if (!field) return;
    field.reject(why, text);
    for (const group of groups) if (group.fields.includes(field)) group.element.open = true;
  }

  return { element, show, reject, field: (key) => fields.get(key) };
}

function sameKeys(facts, fields) {
  const keys = [...fields.keys()];
  const sameField = (fact, key) => fact.key === key && fact.onlyWords === fields.get(key).fact.onlyWords;
  return facts.length === keys.length && facts.every((fact, place) => sameField(fact, keys[place]));
}

/** The keys of a section under its name; keys in entries of lists have headings of their own. */
function makeGroup(name, reply, all) {
  const inside = reply.keys.filter(({ key }) => (key.includes(".") ? key.split(".")[0] : "") === name);
  const fields = inside.map(({ key }) => all.get(key));
  const summary = make("summary");
  const said = reply.sections[name];
  const parts = [];
  const rows = [];
  for (const { key } of inside) {
    const within = key.split(".").slice(1, -1).join(".");
    if (within !== (parts.at(-1)?.within ?? "")) {
      const called = reply.keys.find((fact) => fact.key === `${name}.${within}.name`)?.value;
      const heading = make("h3", {}, `${name}.${within}${called ? ` \u00b7 ${called}` : ""}`);
      parts.push({ within, heading, fields: [] });
      rows.push(heading);
    }
    parts.at(-1)?.fields.push(all.get(key));
    rows.push(all.get(key).element);
  }
  const note = said ? [make("p", { className: "note" }, `${capital(said).replace(/\.$/, "")}.`)] : [];
  const element = make("details", {}, summary, ...note, ...rows);

  function count(settings) {
    const changed = inside.filter(({ key }) => key in settings).length;
    summary.replaceChildren(name ? capital(name) : "Name", ...(changed ? [make("small", {}, ` ${changed} changed`)] : []));
  }

  return { name, element, fields, parts: parts.filter(({ heading }) => heading), count };
}
