// SPDX-License-Identifier: BSD-2-Clause
// A report opened by double click: no server, no network.
//   SOARBOX_REPORT  the file
import assert from "node:assert/strict";
import { after, test } from "node:test";
import { closeBrowser, openBrowser, picture, until } from "./browser.mjs";

after(closeBrowser);

test("a report shows its run in 3D at every moment", { skip: process.env.SOARBOX_REPORT === undefined && "SOARBOX_REPORT names no report" }, async () => {
  const page = await (await openBrowser()).newPage({ viewport: { width: 1280, height: 900 } });
  const troubles = [], asked = [];
  page.on("console", (message) => message.type() === "error" && troubles.push(message.text()));
  page.on("pageerror", (error) => troubles.push(String(error)));
  page.on("request", (request) => asked.push(request.url()));
  await page.goto(`file://${process.env.SOARBOX_REPORT}`);
  const scene = page.frameLocator("iframe.scene");
  await scene.getByText("blue-leader").first().waitFor();
  const pixels = () => scene.locator("canvas").first().screenshot();
  const before = await pixels();
  await scene.locator("input.past").fill("200");
  await until(async () => !before.equals(await pixels()), "the picture is another one at another moment");
  await scene.getByRole("tab", { name: "Messages" }).click();
  await scene.getByText("advance").first().waitFor();
  await scene.getByRole("button", { name: "Run" }).first().click();
  await until(async () => Number(await scene.locator("input.past").inputValue()) > 220, "time goes on");
  await picture(page, "report");
  assert.deepEqual(troubles, []);
  assert.deepEqual(asked.filter((url) => /^(https?|wss?):/.test(url)), [], "nothing is asked for");
});
