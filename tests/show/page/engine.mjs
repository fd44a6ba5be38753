/** The engine of the pages without a browser: node engine.mjs BUILT-FOLDER LIVE.json SETTINGS.json, outcomes as JSON. */

import { readFileSync } from "node:fs";
import { join } from "node:path";
import { runInThisContext } from "node:vm";

const [folder, live, settings] = process.argv.slice(2);
const waiting = new Map();
globalThis.self = globalThis;
globalThis.postMessage = (message) => waiting.get(message.to)?.(message);
runInThisContext(readFileSync(join(folder, "engine.js"), "utf8"));

function ask(message) {
  const number = waiting.size;
  return new Promise((done) => {
    waiting.set(number, done);
    self.onmessage({ data: { ...message, number } });
  });
}

const program = readFileSync(join(folder, "engine.wasm.gz")).toString("base64");
const loaded = await ask({ act: "load", program, text: readFileSync(live, "utf8") });
const answers = [];
// what a study asks of a point, or values of a run
for (const each of JSON.parse(readFileSync(settings, "utf8")))
  answers.push(await ask(each.values ? { act: "answer", ...each } : { act: "run", values: each }));
process.stdout.write(JSON.stringify({ loaded, answers }));
