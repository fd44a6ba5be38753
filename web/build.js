/**
 * Build the script and the style of forficula's pages into the package: npm ci && npm run build
 * The same sources give the same bytes; their hash stands in the first line, and a test compares it.
 */

import { createHash } from "node:crypto";
import { mkdirSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
const out = join(here, "..", "src", "forficula", "show", "page", "built");
const text = (...path) => readFileSync(join(here, ...path), "utf8").replaceAll("\r\n", "\n");

const sources = [
  "build.js",
  "package-lock.json",
  "package.json",
  ...readdirSync(join(here, "src"))
    .sort()
    .map((name) => `src/${name}`),
];
const digest = createHash("sha256");
for (const name of sources) digest.update(`${name}\n${text(name)}`);
const stamp = `/* forficula, MIT; with three.js and uPlot, MIT: see LICENSES.txt; sources ${digest.digest("hex")} */\n`;

const result = await build({
  entryPoints: { page: join(here, "src", "main.js") },
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
  // a closing tag within the script would end the element that it stands in
  const content = file.text.replaceAll("</script", "<\\/script").replaceAll("</style", "<\\/style");
  writeFileSync(file.path, stamp + content);
}
const licences = ["three", "uplot"].map((name) => {
  const { version } = JSON.parse(text("node_modules", name, "package.json"));
  return `${name} ${version}\n\n${text("node_modules", name, "LICENSE").trim()}\n`;
});
writeFileSync(
  join(out, "LICENSES.txt"),
  `page.js and page.css contain parts of these.\n\n${licences.join(`\n${"-".repeat(72)}\n\n`)}`,
);
