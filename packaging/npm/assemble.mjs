// SPDX-License-Identifier: BSD-2-Clause
// Puts the npm package together from a build for WebAssembly, and packs it (./dev npm, docs/npm.md).
//
// usage: node assemble.mjs ENGINE SITE PAGE EMSCRIPTEN SOURCES TARGET
//
// ENGINE      the folder of soarbox.js and soarbox.wasm
// SITE        the folder that ./dev site wrote
// PAGE        the folder of the built page (web/dist/page): `report` uses its scripts
// EMSCRIPTEN  the folder of emscripten, and
// SOURCES     the folder of the libraries that the engine contains: for their licences
// TARGET      gets the folder package/ and the tarball, whose path is printed
import { execFileSync } from "node:child_process";
import { cpSync, existsSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { noticesOfEngine, RULE } from "../../web/licences.mjs";

const HERE = dirname(fileURLToPath(import.meta.url)), ROOT = join(HERE, "..", "..");
const REPORT = ["report.html", "report.js", "report_scene.js"];

function fail(message) {
  console.error(`npm package: error: ${message}`);
  process.exit(1);
}

function needFiles(folder, names, remedy) {
  for (const name of names) if (!existsSync(join(folder, name))) fail(`${join(folder, name)} is missing: ${remedy}`);
}

const [engine, site, page, emscripten, sources, target] = process.argv.slice(2);
if (target === undefined) fail("usage: node assemble.mjs ENGINE SITE PAGE EMSCRIPTEN SOURCES TARGET");
needFiles(engine, ["soarbox.js", "soarbox.wasm"], "./dev wasm command compiles it");
needFiles(site, ["index.html", "engine/soarbox-engine.wasm", "assets/licences.txt"], "./dev site writes it");
needFiles(page, REPORT, "./dev site builds it");

const folder = resolve(target, "package");
rmSync(target, { recursive: true, force: true });
mkdirSync(join(folder, "share", "soarbox", "page"), { recursive: true });
mkdirSync(join(folder, "engine"));
const { version } = JSON.parse(readFileSync(join(HERE, "package.json"), "utf8"));
for (const name of readdirSync(HERE).filter((name) => name !== "assemble.mjs")) cpSync(join(HERE, name), join(folder, name));
for (const name of ["soarbox.js", "soarbox.wasm"]) cpSync(join(engine, name), join(folder, "engine", name));
for (const name of ["scenarios", "media", "lessons"])
  cpSync(join(ROOT, name), join(folder, "share", "soarbox", name), { recursive: true, filter: (path) => !path.includes("__pycache__") });
for (const name of REPORT) cpSync(join(page, name), join(folder, "share", "soarbox", "page", name));
cpSync(site, join(folder, "site"), { recursive: true });
cpSync(join(ROOT, "LICENSE"), join(folder, "LICENSE"));
// The site has the notices of the page's parts, too; those of the command are the engine's.
writeFileSync(join(folder, "licences.txt"), [`Soarbox (BSD-2-Clause)\n\n${readFileSync(join(ROOT, "LICENSE"), "utf8").trim()}\n`, noticesOfEngine(sources, emscripten)].join(RULE));

const npm = process.platform === "win32" ? "npm.cmd" : "npm";
execFileSync(npm, ["pack", "--loglevel=error", "--pack-destination", resolve(target)], { cwd: folder, stdio: ["ignore", "ignore", "inherit"] });
console.log(join(target, `soarbox-${version}.tgz`));
