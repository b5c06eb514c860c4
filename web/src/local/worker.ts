// SPDX-License-Identifier: BSD-2-Clause
import { EngineWorker, type MakeEngine } from "./engine";
import type { FromWorker, ToWorker } from "./messages";

// The worker of a page without a server. Its address says where the engine is: worker.js?engine=ADDRESS.
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

let engineAddress = "";
const worker = new EngineWorker(
  async () => {
    const { default: make } = (await import(engineAddress)) as { default: MakeEngine };
    return (settings) => make({ ...settings, locateFile: (name) => new URL(name, engineAddress).href });
  },
  (message) => scope.postMessage(message, "bytes" in message ? [message.bytes.buffer] : []),
  {
    // A timer of 0 ms waits 4 ms; a message does not, and lets others come first as well.
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
  },
);
scope.onmessage = ({ data }) => {
  if (data.kind === "begin") engineAddress = data.engine;
  void worker.take(data);
};
