// SPDX-License-Identifier: BSD-2-Clause
// Writes docs/images/side_by_side.png: the same moments with the same camera, in the window and in a browser.
//   SOARBOX_COMMAND=build/release/bin/soarbox xvfb-run -a node web/side_by_side.mjs
import { execFileSync } from "node:child_process";
import { cpSync, mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { closeBrowser, openBrowser, PATIENCE_MS, until } from "./e2e/browser.mjs";
import { COMMAND, startServer } from "./e2e/own_server.mjs";

const ROOT = fileURLToPath(new URL("..", import.meta.url));
const WIDTH = 720, HEIGHT = 405, TICKS_PER_S = 30;
/** The height of the window's parts above and below its picture of the world, in pixels. */
const MENU = 59, FOOT = 31;
const SHOWN = 480;
/** `from`: position of the camera; `down`: its downward angle in degrees, along -z. */
const MOMENTS = [
  { world: "soar_skirmish", at: 8, from: [0, 4, 24], down: 12 },
  { world: "soar_hide", at: 4, from: [0, 7, 17], down: 20 },
];

/** A copy of a world with a fixed camera at this position. */
function copyOf({ world, from, down }) {
  const folder = mkdtempSync(join(tmpdir(), "soarbox-"));
  cpSync(join(ROOT, "scenarios", world), folder, { recursive: true });
  // Moves the camera slightly in each tick: the page may adapt a script's first view, but uses later ones unchanged.
  writeFileSync(join(folder, "Camera.lua"), `
require "Plain"
local tick = 0
function Sandbox_Initialize(sandbox)
    Plain_Create(sandbox)
end
function Sandbox_Update(sandbox)
    tick = tick + 1
    Sandbox.SetCameraPosition(sandbox, Vector.new(${from.map((one, axis) => (axis === 0 ? `${one} + tick % 2 / 1000` : one)).join(", ")}))
    Sandbox.SetCameraOrientation(sandbox, Vector.new(${-down}, 0, 0))
end
`);
  const scenario = join(folder, "scenario.toml");
  writeFileSync(scenario, `script = "Camera.lua"\n${readFileSync(scenario, "utf8")}`);
  return folder;
}

function ofWindow(folder, at) {
  const file = join(folder, "window.png");
  execFileSync(COMMAND, ["run", folder, "--screenshot", file, "--at", String(at), "--panels", "none", "--detail", "full", "--width", String(WIDTH), "--height", String(MENU + HEIGHT + FOOT)], { stdio: ["ignore", "ignore", "inherit"] });
  return readFileSync(file);
}

async function ofPage(folder, at) {
  const server = await startServer([folder]), context = await (await openBrowser()).newContext({ viewport: { width: WIDTH, height: HEIGHT } }), page = await context.newPage();
  page.setDefaultTimeout(PATIENCE_MS);
  await page.addInitScript(() => localStorage.setItem("soarbox.detail", "full"));
  await page.goto(server.address);
  await page.waitForSelector(".labels .name");
  const shown = async () => Number((await page.locator(".scrubber .moment").innerText()).split("/")[0].split(":")[1]);
  await page.locator(".stage canvas").focus();
  await page.keyboard.press("Space");
  await page.waitForSelector(".flow-bar button[aria-label=Run]");
  await page.addStyleTag({ content: ".stage { position: fixed !important; inset: 0; height: auto !important; z-index: 99; } .stage-tools { display: none; } .stage canvas { outline: none !important; }" });
  // Steps tick by tick to this moment.
  for (let time = await shown(); time < at - 0.5 / TICKS_PER_S; time = await shown()) {
    const before = time;
    await page.keyboard.press(".");
    await until(async () => (await shown()) > before, "a tick");
  }
  let last = "";
  await until(async () => {
    const now = (await page.screenshot({ timeout: PATIENCE_MS })).toString("base64"), isStill = now === last;
    last = now;
    return isStill;
  }, "the picture stands still");
  await context.close();
  await server.kill();
  return Buffer.from(last, "base64");
}

const rows = [];
for (const moment of MOMENTS) {
  const folder = copyOf(moment);
  rows.push([ofWindow(folder, moment.at), await ofPage(folder, moment.at)]);
}
const scale = SHOWN / WIDTH, high = Math.round(HEIGHT * scale);
const sheet = await (await (await openBrowser()).newContext({ viewport: { width: 2 * SHOWN + 6, height: rows.length * (high + 6) + 20 } })).newPage();
const shown = (png, above) => `<div><img style="top: ${-above * scale}px" src="data:image/png;base64,${png.toString("base64")}"></div>`;
await sheet.setContent(`<style>body { margin: 0; font: 15px sans-serif; display: grid; grid-template-columns: ${SHOWN}px ${SHOWN}px; gap: 6px; } div { height: ${high}px; overflow: hidden; position: relative; }
  img { width: ${SHOWN}px; position: absolute; } b { text-align: center; height: 18px; }</style><b>the window</b><b>a browser</b>${rows.map(([one, other]) => shown(one, MENU) + shown(other, 0)).join("")}`);
await sheet.waitForTimeout(300);
await sheet.screenshot({ path: join(ROOT, "docs/images/side_by_side.png") });
await closeBrowser();
