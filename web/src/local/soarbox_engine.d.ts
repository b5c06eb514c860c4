// SPDX-License-Identifier: BSD-2-Clause
// The module that emscripten writes with the engine (src/app/worker); build_site.mjs has its location.
import type { EngineModule, EngineSettings } from "./engine";

export default function makeEngine(settings: EngineSettings & {
  instantiateWasm(imports: WebAssembly.Imports, done: (instance: WebAssembly.Instance, module: WebAssembly.Module) => void): object;
  getPreloadedPackage(name: string, bytes: number): ArrayBuffer;
  locateFile(name: string): string;
  /** Identifies the module in recordings. */
  soarboxModuleId(): string;
}): Promise<EngineModule>;
