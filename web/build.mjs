// SPDX-License-Identifier: BSD-2-Clause
// Bundles the page into dist/page, and prints the size that a browser loads.
import { build } from "esbuild";
import { cpSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { noticesFor } from "./licences.mjs";

const MOST_COMPRESSED_BYTES = 1_500_000;

rmSync("dist/page", { recursive: true, force: true });
mkdirSync("dist/page/assets", { recursive: true });
const { metafile } = await build({
  entryPoints: { page: "src/main.ts", style: "src/styles/page.css" },
  outdir: "dist/page/assets",
  bundle: true,
  splitting: true,
  format: "esm",
  target: "es2022",
  minify: true,
  chunkNames: "[name]-[hash]",
  legalComments: "none",
  logLevel: "warning",
  metafile: true,
});
// Preloads the modules that draw the world together with the page. Otherwise a browser finds the imports of a script
// only after it has loaded it.
const needed = new Set(["page", "scene_view", "pointer"].flatMap((name) => {
  const [file, made] = Object.entries(metafile.outputs).find(([path]) => new RegExp(`/${name}(-[A-Z0-9]+)?\\.js$`).test(path));
  return [file, ...made.imports.filter((one) => one.kind === "import-statement").map((one) => one.path)];
}));
const preloads = [...needed].map((file) => `<link rel="modulepreload" href="${file.replace("dist/page", "")}">`).join("\n");
// The parts that `soarbox report` puts into one file: the page with its style, and the scripts for the data and for a
// recorded run in 3D.
const noEditor = { name: "no editor", setup: (bundle) => bundle.onResolve({ filter: /\/edit_panel$/ }, () => ({ path: fileURLToPath(new URL("src/report/no_edit_panel.ts", import.meta.url)) })) };
const whole = await build({ plugins: [noEditor], entryPoints: { report: "src/report.ts", report_scene: "src/report_scene.ts", style: "src/styles/report_page.css" }, outdir: "dist", bundle: true, write: false, metafile: true, format: "esm", target: "es2022", minify: true, legalComments: "none", logLevel: "warning" });
const textOf = (ending) => whole.outputFiles.find((file) => file.path.endsWith(ending)).text;
writeFileSync("dist/page/report.html", readFileSync("src/report.html", "utf8").replace("{{style}}", () => textOf(".css"))
  .replace("{{licences}}", () => noticesFor(whole.metafile).replaceAll("&", "&amp;").replaceAll("<", "&lt;")));
for (const name of ["report.js", "report_scene.js"])
  writeFileSync(`dist/page/${name}`, textOf(`/${name}`).replaceAll("</script", "<\\/script").replaceAll("<!--", "<\\!--"));
writeFileSync("dist/page/index.html", readFileSync("src/index.html", "utf8").replace("<!-- preloads -->", preloads));
writeFileSync("dist/page/assets/licences.txt", noticesFor(metafile));
cpSync("src/icon.svg", "dist/page/assets/icon.svg");
// One small script without modules, for pages of other sites.
await build({ entryPoints: { embed: "src/embed.ts" }, outdir: "dist/page/assets", bundle: true, format: "iife", target: "es2022", minify: true, legalComments: "none", logLevel: "warning" });
const files = ["dist/page/index.html", ...readdirSync("dist/page/assets").map((name) => `dist/page/assets/${name}`)];
const bytes = files.filter((name) => !name.endsWith(".txt")).reduce((sum, name) => sum + gzipSync(readFileSync(name)).length, 0);
if (bytes > MOST_COMPRESSED_BYTES) {
  console.error(`the page has ${bytes} bytes compressed: more than the ${MOST_COMPRESSED_BYTES} that it may have`);
  process.exit(1);
}
console.log(`dist/page: ${Math.round(bytes / 1000)} kB compressed`);
