// SPDX-License-Identifier: BSD-2-Clause
// The cost of a picture if the processor draws. It is measured in draw calls, triangles and pixels, because times
// depend on the machine.
import assert from "node:assert/strict";
import { cpSync, mkdtempSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import { fileURLToPath } from "node:url";
import { closeBrowser, openBrowser, PATIENCE_MS, picture, until } from "./browser.mjs";
import { COMMAND, startServer } from "./own_server.mjs";

after(closeBrowser);
const SKIRMISH = fileURLToPath(new URL("../../scenarios/soar_skirmish", import.meta.url)), BODIES = fileURLToPath(new URL("ten_thousand", import.meta.url));
const skip = COMMAND === "" ? "SOARBOX_COMMAND names no program" : false;

/** A page of the server that counts draw calls and triangles of each picture, in `window.drawn.of`. */
async function openCounting(server) {
  const page = await (await (await openBrowser()).newContext({ viewport: { width: 1280, height: 720 } })).newPage();
  page.setDefaultTimeout(PATIENCE_MS);
  await page.addInitScript(() => {
    const told = (window.drawn = { calls: 0, triangles: 0, of: [] }), prototype = WebGL2RenderingContext.prototype;
    const count = (name, triangles) => {
      const draw = prototype[name];
      prototype[name] = function (...all) {
        told.calls += 1;
        told.triangles += triangles(all);
        return draw.apply(this, all);
      };
    };
    count("drawElements", ([, corners]) => corners / 3);
    count("drawArrays", () => 0);
    count("drawElementsInstanced", ([, corners, , , instances]) => (corners * instances) / 3);
    const next = window.requestAnimationFrame;
    window.requestAnimationFrame = (call) => next.call(window, (now) => {
      const before = told.calls, triangles = told.triangles;
      call(now);
      if (told.calls > before) told.of.push({ calls: told.calls - before, triangles: told.triangles - triangles });
    });
  });
  await page.goto(server.address);
  await page.waitForSelector(".labels .name");
  return page;
}

/** Turns the camera of a paused world for some pictures. Returns their numbers: some have shadows, others do not. */
async function turnCamera(page) {
  const before = await page.evaluate(() => window.drawn.of.length);
  await until(async () => {
    await page.keyboard.press("ArrowLeft");
    return (await page.evaluate(() => window.drawn.of.length)) > before + 6;
  }, "the camera turns");
  return page.evaluate((from) => window.drawn.of.slice(from), before);
}

async function pause(page) {
  await page.locator(".stage canvas").focus();
  await page.keyboard.press("Space");
  await page.waitForSelector(".flow-bar button[aria-label=Run]");
}

test("two hundred soldiers are drawn with few calls, triangles and pixels", { skip }, async () => {
  const MOST_CALLS = 16, MOST_TRIANGLES = 70_000, folder = mkdtempSync(join(tmpdir(), "soarbox-"));
  cpSync(SKIRMISH, folder, { recursive: true });
  cpSync(join(SKIRMISH, "skirmish_200.toml"), join(folder, "scenario.toml"));
  const server = await startServer([folder, "--memory", "2000"]), page = await openCounting(server);
  // Waits until soldiers, ground, hills and boxes are in the picture.
  await until(() => page.evaluate(() => window.drawn.of.at(-1)?.triangles > 30_000), "the soldiers are drawn");
  await pause(page);
  const of = await turnCamera(page), { canvas, stage } = await page.evaluate(() => {
    const shown = document.querySelector(".stage canvas");
    return { canvas: shown.width * shown.height, stage: shown.clientWidth * shown.clientHeight };
  });
  await picture(page, "two_hundred");
  for (const one of of) {
    assert.ok(one.calls <= MOST_CALLS, `${one.calls} draw calls`);
    assert.ok(one.triangles <= MOST_TRIANGLES, `${Math.round(one.triangles)} triangles`);
  }
  assert.ok(canvas <= stage, `${canvas} pixels for ${stage} of the page`);
  console.log(`draw calls ${Math.max(...of.map((one) => one.calls))}, triangles ${Math.round(Math.max(...of.map((one) => one.triangles)))}, pixels ${canvas} for ${stage}`);
  await page.context().close();
  await server.kill();
});

test("ten thousand bodies of four shapes and eight materials are drawn with few calls", { skip }, async () => {
  // Includes the shadows.
  const MOST_CALLS = 25, LEAST_TRIANGLES = 10_000 * 12;
  const server = await startServer([BODIES, "--memory", "4000"]), page = await openCounting(server);
  await until(() => page.evaluate((least) => window.drawn.of.at(-1)?.triangles > least, LEAST_TRIANGLES), "the bodies are drawn");
  const moving = await page.evaluate(() => window.drawn.of.at(-1));
  await pause(page);
  const most = Math.max(moving.calls, ...(await turnCamera(page)).map((one) => one.calls));
  await picture(page, "ten_thousand");
  console.log(`draw calls ${most}`);
  assert.ok(most <= MOST_CALLS, `${most} draw calls`);
  await page.context().close();
  await server.kill();
});
