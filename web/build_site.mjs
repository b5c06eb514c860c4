// SPDX-License-Identifier: BSD-2-Clause
// Writes the page with the engine in it: a folder that any server of files can serve, below any path (./dev site, docs/site.md).
//
// usage: node build_site.mjs ENGINE FOLDER     after build.mjs. ENGINE: the folder of soarbox-engine.mjs, .wasm and .data
import { build } from "esbuild";
import { cpSync, existsSync, mkdirSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { gzipSync } from "node:zlib";
import { join } from "node:path";

const [engine, folder] = process.argv.slice(2);
const PARTS = ["soarbox-engine.mjs", "soarbox-engine.wasm", "soarbox-engine.data"];
if (folder === undefined || !PARTS.every((name) => existsSync(join(engine, name)))) {
  console.error("usage: node build_site.mjs ENGINE FOLDER, where ENGINE has " + PARTS.join(", "));
  process.exit(2);
}
if (existsSync(folder) && !existsSync(join(folder, "engine"))) {
  console.error(`${folder} is there and is no site that was built before: name another folder, or remove it`);
  process.exit(1);
}
rmSync(folder, { recursive: true, force: true });
mkdirSync(join(folder, "engine"), { recursive: true });
cpSync("dist/page/assets", join(folder, "assets"), { recursive: true });
await build({ entryPoints: { worker: "src/local/worker.ts" }, outdir: join(folder, "assets"), bundle: true, format: "esm", target: "es2022", minify: true, legalComments: "none", logLevel: "warning" });
for (const name of PARTS) cpSync(join(engine, name), join(folder, "engine", name));
// Nothing is at the root of its server.
const html = readFileSync("dist/page/index.html", "utf8").replaceAll('="/assets/', '="assets/')
  .replace("<meta name=\"color-scheme\"", '<meta name="soarbox-engine" content="engine/soarbox-engine.mjs">\n<meta name="color-scheme"');
writeFileSync(join(folder, "index.html"), html);
const kB = (name) => Math.round(gzipSync(readFileSync(join(folder, "engine", name)), { level: 9 }).length / 1000);
console.log(`${folder}: engine ${kB(PARTS[1])} kB compressed (${Math.round(statSync(join(folder, "engine", PARTS[1])).size / 1000)} kB), worlds and lessons ${kB(PARTS[2])} kB`);
