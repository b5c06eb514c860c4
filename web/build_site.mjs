// SPDX-License-Identifier: BSD-2-Clause
// Writes the page with the engine in it (./dev site, docs/site.md), after build.mjs.
//
// usage: node build_site.mjs ENGINE EMSCRIPTEN SOURCES TARGET
//
// ENGINE      the folder of soarbox-engine.mjs, .wasm and .data
// EMSCRIPTEN  the folder of emscripten, and
// SOURCES     the folder of the libraries that the engine contains: for their licences
// TARGET      a folder, which any file server can serve below any path; or NAME.html, a file that a browser opens from
// the disk
import { build } from "esbuild";
import { createHash } from "node:crypto";
import { cpSync, existsSync, mkdirSync, readdirSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { gzipSync } from "node:zlib";
import { dirname, join, relative, resolve } from "node:path";
import { noticesFor, noticesOfEngine, RULE } from "./licences.mjs";

const PARTS = { script: "soarbox-engine.mjs", wasm: "soarbox-engine.wasm", data: "soarbox-engine.data" };
const [engine, emscripten, sources, target] = process.argv.slice(2);
if (target === undefined || !Object.values(PARTS).every((name) => existsSync(join(engine, name)))) {
  console.error("usage: node build_site.mjs ENGINE EMSCRIPTEN SOURCES TARGET, where ENGINE has " + Object.values(PARTS).join(", "));
  process.exit(2);
}

/** @type {import("esbuild").BuildOptions} */
const COMMON = { bundle: true, target: "es2022", minify: true, legalComments: "none", logLevel: "warning", write: false };
/** The script of the worker, including emscripten's script. */
async function worker() {
  // Modules that emscripten's script needs only in Node.js.
  const node = /^(node:)?(module|path|fs|url|crypto)$/;
  const noNode = { name: "no Node.js", setup(bundle) {
    bundle.onResolve({ filter: node }, ({ path }) => ({ path, namespace: "node" }));
    bundle.onLoad({ filter: node, namespace: "node" }, () => ({ contents: "export const createRequire = () => undefined;" }));
  } };
  const { outputFiles } = await build({ ...COMMON, entryPoints: ["src/local/worker.ts"], format: "iife", plugins: [noNode], alias: { "soarbox-engine": resolve(engine, PARTS.script) }, define: { "import.meta.url": '"soarbox-engine"', SOARBOX_MODULE_ID: JSON.stringify(moduleId()) } });
  return outputFiles[0].text;
}

/** The id of the engine's module, computed as in programs for Node.js (cmake/wasm/node.js). */
function moduleId() {
  return createHash("sha256").update(partBytes("wasm")).digest("hex").slice(0, 40);
}

const partBytes = (part) => readFileSync(join(engine, PARTS[part]));
const kB = (bytes) => `${Math.round(bytes / 1000)} kB`;

/** The service worker lists all files of the site, so it is written last. */
async function writeServiceWorker(folder) {
  const files = readdirSync(folder, { recursive: true, withFileTypes: true }).filter((one) => one.isFile()).map((one) => relative(folder, join(one.parentPath ?? one.path, one.name))).sort();
  const version = createHash("sha256");
  for (const file of files) version.update(file).update(readFileSync(join(folder, file)));
  const { outputFiles } = await build({ ...COMMON, entryPoints: ["src/local/offline.ts"], format: "iife", define: { SOARBOX_FILES: JSON.stringify(["./", ...files]), SOARBOX_VERSION: JSON.stringify(version.digest("hex").slice(0, 16)) } });
  writeFileSync(join(folder, "offline.js"), outputFiles[0].text);
}

async function writeFolder(folder) {
  if (existsSync(folder) && !existsSync(join(folder, "engine", PARTS.wasm))) {
    console.error(`${folder} is there and is not a site that was built before: name another folder, or remove it`);
    process.exit(1);
  }
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(join(folder, "engine"), { recursive: true });
  cpSync("dist/page/assets", join(folder, "assets"), { recursive: true });
  rmSync(join(folder, "assets", "embed.js"), { force: true });
  writeFileSync(join(folder, "assets", "worker.js"), await worker());
  writeFileSync(join(folder, "assets", "licences.txt"), readFileSync("dist/page/assets/licences.txt", "utf8") + RULE + noticesOfEngine(sources, emscripten));
  for (const part of ["wasm", "data"]) cpSync(join(engine, PARTS[part]), join(folder, "engine", PARTS[part]));
  // All addresses are relative, because the site may not be at the root of its server.
  writeFileSync(join(folder, "index.html"), readFileSync("dist/page/index.html", "utf8").replaceAll('="/assets/', '="assets/')
    .replace('<meta name="color-scheme"', '<meta name="soarbox-engine" content="engine">\n<link rel="manifest" href="manifest.webmanifest">\n<meta name="color-scheme"'));
  writeFileSync(join(folder, "manifest.webmanifest"), JSON.stringify({ name: "Soarbox", short_name: "Soarbox", start_url: ".", display: "standalone", icons: [{ src: "assets/icon.svg", type: "image/svg+xml", sizes: "any" }] }));
  await writeServiceWorker(folder);
  const packed = (part) => gzipSync(partBytes(part), { level: 9 }).length;
  console.log(`${folder}: engine ${kB(packed("wasm"))} compressed (${kB(statSync(join(engine, PARTS.wasm)).size)}), worlds and lessons ${kB(packed("data"))}`);
}

async function writeFile(file) {
  const page = await build({ ...COMMON, entryPoints: { page: "src/main.ts", style: "src/styles/page.css" }, outdir: "dist", format: "iife", metafile: true, define: { "import.meta.url": "document.baseURI" } });
  const textOf = (ending) => page.outputFiles.find(({ path }) => path.endsWith(ending)).text;
  const script = (text) => text.replaceAll("</script", "<\\/script").replaceAll("<!--", "<\\!--");
  const held = (id, text) => `<script type="text/plain" id="soarbox-${id}">${text}</script>\n`;
  const packed = (part) => gzipSync(partBytes(part), { level: 9 }).toString("base64");
  const notices = noticesFor(page.metafile) + RULE + noticesOfEngine(sources, emscripten);
  const icon = `data:image/svg+xml;base64,${readFileSync("src/icon.svg").toString("base64")}`;
  const html = readFileSync("src/index.html", "utf8")
    .replace('<meta name="color-scheme"', '<meta name="soarbox-engine" content="">\n<meta name="color-scheme"')
    .replace('href="/assets/icon.svg"', () => `href="${icon}"`)
    .replace(/<link rel="license"[^>]*>\n/, "").replace("<!-- preloads -->\n", "")
    .replace(/<link rel="stylesheet"[^>]*>/, () => `<style>${textOf("style.css").replaceAll("</style", "<\\/style")}</style>`)
    .replace(/<script type="module"[^>]*><\/script>\n/, "")
    .replace("</body>", () => held("licences", script(notices)) + held("worker", script(textOfWorker)) + held("wasm", packed("wasm")) + held("data", packed("data")) + `<script>${script(textOf("page.js"))}</script>\n</body>`);
  mkdirSync(dirname(file), { recursive: true });
  writeFileSync(file, html);
  console.log(`${file}: ${kB(html.length)}`);
}

const textOfWorker = target.endsWith(".html") ? await worker() : "";
await (target.endsWith(".html") ? writeFile(target) : writeFolder(target));
