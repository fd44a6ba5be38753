/**
 * Build the scripts and the style of forficula's pages, and their engine, into the package: npm ci && npm run build
 * The same sources give the same bytes; the first line contains their hash, which a test compares.
 */

import { createHash } from "node:crypto";
import { mkdirSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { basename, dirname, extname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { build } from "esbuild";
import { patched } from "./engine.js";

const here = dirname(fileURLToPath(import.meta.url));
const out = join(here, "..", "src", "forficula", "show", "page", "built");
const text = (...path) => readFileSync(join(here, ...path), "utf8").replaceAll("\r\n", "\n");

const sources = [
  "build.js",
  "engine.js",
  "licences/mujoco.txt",
  "package-lock.json",
  "package.json",
  ...readdirSync(join(here, "src"))
    .sort()
    .map((name) => `src/${name}`),
];
const digest = createHash("sha256");
for (const name of sources) digest.update(`${name}\n${text(name)}`);
const hash = digest.digest("hex");
// the engine is used as published: npm ci checks it against the hash in package-lock.json
const engine = readFileSync(join(here, "node_modules", "@mujoco", "mujoco", "mujoco.wasm"));
const program = createHash("sha256").update(engine).digest("hex");
const stamps = {
  ".js": `/* forficula, MIT; with three.js and uPlot, MIT: see LICENSES.txt; sources ${hash} */\n`,
  ".css": `/* forficula, MIT; with three.js and uPlot, MIT: see LICENSES.txt; sources ${hash} */\n`,
  "engine.js": `/* forficula, MIT; with MuJoCo, Apache 2.0: see LICENSES.txt; sources ${hash}; engine.wasm ${program} */\n`,
};

const result = await build({
  entryPoints: { page: join(here, "src", "main.js"), still: join(here, "src", "still.js"), engine: join(here, "src", "engine-worker.js") },
  plugins: [
    {
      name: "engine",
      setup: (made) =>
        made.onLoad({ filter: /@mujoco[\\/]mujoco[\\/]mujoco\.js$/ }, ({ path }) => ({ contents: patched(readFileSync(path, "utf8")) })),
    },
  ],
  bundle: true,
  minify: true,
  write: false,
  format: "iife",
  target: ["es2022"],
  charset: "utf8",
  legalComments: "none",
  outdir: out,
});

mkdirSync(out, { recursive: true });
for (const file of result.outputFiles) {
  // a closing tag within the script would close the element that contains the script
  const content = file.text.replaceAll("</script", "<\\/script").replaceAll("</style", "<\\/style");
  const stamp = stamps[basename(file.path)] ?? stamps[extname(file.path)];
  writeFileSync(file.path, stamp + content);
}
writeFileSync(join(out, "engine.wasm.gz"), gzipSync(engine, { level: 9 }));
const licences = ["three", "uplot"].map((name) => {
  const { version } = JSON.parse(text("node_modules", name, "package.json"));
  return `${name} ${version}\n\n${text("node_modules", name, "LICENSE").trim()}\n`;
});
const { version } = JSON.parse(text("node_modules", "@mujoco", "mujoco", "package.json"));
licences.push(`mujoco ${version}, in engine.js and engine.wasm.gz\n\n${text("licences", "mujoco.txt").trim()}\n`);
writeFileSync(
  join(out, "LICENSES.txt"),
  `page.js and page.css contain parts of the first two, engine.js and engine.wasm.gz of the last.\n\n${licences.join(`\n${"-".repeat(72)}\n\n`)}`,
);
