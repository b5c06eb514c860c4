// SPDX-License-Identifier: BSD-2-Clause
// Starts a separate server for a test. SOARBOX_COMMAND names the program; without it, such tests are skipped.
import { spawn } from "node:child_process";
import { mkdtempSync } from "node:fs";
import { createServer } from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

export const COMMAND = process.env.SOARBOX_COMMAND ?? "";
const PAGE = fileURLToPath(new URL("../dist/page", import.meta.url));

export function freePort() {
  return new Promise((resolve, reject) => {
    const server = createServer().on("error", reject);
    server.listen(0, "127.0.0.1", () => {
      const { port } = server.address();
      server.close(() => resolve(port));
    });
  });
}

/** `told` is its output until it is ready. `kill()` ends it immediately. */
export async function startServer(args, { port, state = mkdtempSync(join(tmpdir(), "soarbox-")) } = {}) {
  const at = port ?? (await freePort());
  const process_ = spawn(COMMAND, ["serve", "--listen", `127.0.0.1:${at}`, "--state", state, "--page", PAGE, ...args], { stdio: ["ignore", "pipe", "pipe"] });
  let told = "";
  const ready = new Promise((resolve, reject) => {
    const take = (bytes) => {
      told += bytes;
      if (told.includes("Ctrl-C")) resolve();
    };
    process_.stdout.on("data", take);
    process_.stderr.on("data", take);
    process_.on("exit", () => reject(new Error(`the server ended: ${told}`)));
  });
  await ready;
  const ended = new Promise((resolve) => process_.on("exit", resolve));
  return {
    told, port: at, state, address: `http://127.0.0.1:${at}`,
    kill: async () => {
      process_.kill("SIGKILL");
      await ended;
    },
  };
}
