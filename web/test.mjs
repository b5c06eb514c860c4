// SPDX-License-Identifier: BSD-2-Clause
// Runs the tests of the page's parts: each *.test.ts below src, bundled for Node.
import { build } from "esbuild";
import { spawnSync } from "node:child_process";
import { mkdirSync, readdirSync } from "node:fs";

const tests = (readdirSync("src", { recursive: true })).filter((name) => name.endsWith(".test.ts")).map((name) => `src/${name}`);
mkdirSync("dist/tests", { recursive: true });
await build({ entryPoints: tests, outdir: "dist/tests", bundle: true, platform: "node", format: "esm", outExtension: { ".js": ".mjs" }, logLevel: "warning" });
const files = readdirSync("dist/tests", { recursive: true }).filter((name) => name.endsWith(".mjs")).map((name) => `dist/tests/${name}`);
process.exit(spawnSync(process.execPath, ["--test", ...files], { stdio: "inherit" }).status ?? 1);
