// SPDX-License-Identifier: BSD-2-Clause
import makeEngine from "soarbox-engine";
import { EngineWorker } from "./engine";
import type { EngineFiles, FromWorker, LoadedEngine, ToWorker } from "./messages";

// The worker of a page without a server.
declare const SOARBOX_MODULE_ID: string;
interface Scope {
  postMessage(message: FromWorker, transfer: Transferable[]): void;
  onmessage: ((event: { data: ToWorker }) => void) | null;
}
const scope = self as unknown as Scope;
const { port1, port2 } = new MessageChannel();
let atOnce: (() => void) | null = null;
port1.onmessage = () => {
  const call = atOnce;
  atOnce = null;
  call?.();
};

async function fetched(address: string): Promise<Response> {
  const response = await fetch(address);
  if (!response.ok) throw new Error(`${address} cannot be loaded: the server answered with ${response.status}`);
  return response;
}

async function compiled(folder: string): Promise<WebAssembly.Module> {
  const response = await fetched(`${folder}/soarbox-engine.wasm`);
  // If a server sends the wrong media type, the module cannot be compiled while it is loaded.
  if (response.headers.get("Content-Type") === "application/wasm") return WebAssembly.compileStreaming(response);
  return WebAssembly.compile(await response.arrayBuffer());
}

async function loadEngine(engine: EngineFiles | LoadedEngine): Promise<LoadedEngine> {
  if (typeof engine === "string") {
    const [module, data] = await Promise.all([compiled(engine), fetched(`${engine}/soarbox-engine.data`).then((response) => response.arrayBuffer())]);
    return { module, data };
  }
  return "module" in engine ? engine : { module: await WebAssembly.compile(engine.wasm), data: engine.data };
}

const worker = new EngineWorker({
  load: async (engine) => {
    const loaded = await loadEngine(engine);
    return {
      loaded,
      make: (settings) => makeEngine({
        ...settings,
        instantiateWasm: (imports, done) => {
          void WebAssembly.instantiate(loaded.module, imports).then((instance) => done(instance, loaded.module));
          return {};
        },
        // The file system owns the buffer, so the other module gets a copy.
        getPreloadedPackage: () => loaded.data.slice(0),
        locateFile: (name) => name,
        soarboxModuleId: () => SOARBOX_MODULE_ID,
      }),
    };
  },
  say: (message) => scope.postMessage(message, "bytes" in message ? [message.bytes.buffer] : []),
  // A timer of 0 ms waits 4 ms. A message does not, and also lets other messages pass first.
  later: (call, ms) => {
    if (ms > 0) {
      const timer = setTimeout(call, ms);
      return () => clearTimeout(timer);
    }
    atOnce = call;
    port2.postMessage(null);
    return () => {
      if (atOnce === call) atOnce = null;
    };
  },
});
scope.onmessage = ({ data }) => void worker.take(data);
