// SPDX-License-Identifier: BSD-2-Clause
// Begins each program for Node.js: its environment, and what identifies the module in recordings.
Module["preRun"] = [].concat(Module["preRun"] || [], () => Object.assign(ENV, process.env));
Module["soarboxModuleId"] = () =>
  require("crypto").createHash("sha256").update(require("fs").readFileSync(locateFile(wasmBinaryFileName()))).digest("hex").slice(0, 40);
function wasmBinaryFileName() {
  return require("path").basename(__filename, ".js") + ".wasm";
}
