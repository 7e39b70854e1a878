/* Bundle the scripts of the page and write their digests: npm ci --ignore-scripts && node build.mjs */

import { build } from "esbuild";
import { createHash } from "node:crypto";
import { readdirSync, readFileSync, writeFileSync } from "node:fs";

const OUT = "../../workbook/site/static/answer_boxes";
const PACKAGES = ["@codemirror/state", "@codemirror/view", "@codemirror/commands", "@codemirror/language",
  "@codemirror/lang-python", "@lezer/common", "@lezer/highlight", "@lezer/lr", "@lezer/python", "@marijn/find-cluster-break",
  "crelt", "style-mod", "w3c-keyname"];

const { metafile } = await build({
  entryPoints: ["src/boxes.mjs", "src/progress.mjs", "src/where.mjs", "src/editor.mjs", "src/boxes.css"],
  outdir: OUT,
  bundle: true,
  minify: true,
  format: "iife",
  target: "es2022",
  legalComments: "none",
  metafile: true,
});

// every package whose code is in a bundle is licensed in the file beside it
const bundled = new Set(Object.values(metafile.outputs).flatMap((output) => Object.entries(output.inputs)
  .filter(([, { bytesInOutput }]) => bytesInOutput)
  .flatMap(([path]) => path.match(/node_modules\/((?:@[^/]+\/)?[^/]+)/)?.[1] ?? [])));
const missing = [...bundled].filter((name) => !PACKAGES.includes(name));
if (missing.length) throw new Error(`not in the list of licences: ${missing}`);
const licences = [...bundled].sort().map((name) => {
  const { version } = JSON.parse(readFileSync(`node_modules/${name}/package.json`));
  return `${name} ${version}\n\n${readFileSync(`node_modules/${name}/LICENSE`, "utf8").trim()}\n`;
});
writeFileSync(`${OUT}/LICENSE`, `editor.js contains these packages.\n\n${licences.join("\n\n")}`);

const files = ["package.json", "package-lock.json", "build.mjs", ...readdirSync("src").map((name) => `src/${name}`),
  ...readdirSync(OUT).map((name) => `${OUT}/${name}`)];
writeFileSync("SHA256SUMS", files.sort().map((name) =>
  `${createHash("sha256").update(readFileSync(name)).digest("hex")}  ${name}\n`).join(""));
