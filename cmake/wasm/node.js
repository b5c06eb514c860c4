// SPDX-License-Identifier: BSD-2-Clause
// Begins each program for Node.js: its environment, where the program's own files are, and what identifies the module in recordings.
Module["preRun"] = [].concat(Module["preRun"] || [], () => Object.assign(ENV, { SOARBOX_DATA: dataFolder() }, process.env));
/** Beside the program's folder as in a package, or in the source tree that it was built from, in build/wasm/bin. */
function dataFolder() {
  const { join } = require("path"), isThere = (folder) => require("fs").existsSync(join(folder, "scenarios"));
  return [join(__dirname, "..", "share", "soarbox"), join(__dirname, "..", "..", "..")].find(isThere) ?? "";
}
Module["soarboxModuleId"] = () =>
  require("crypto").createHash("sha256").update(require("fs").readFileSync(locateFile(wasmBinaryFileName()))).digest("hex").slice(0, 40);
function wasmBinaryFileName() {
  return require("path").basename(__filename, ".js") + ".wasm";
}
