// SPDX-License-Identifier: BSD-2-Clause
// The sound of a world is switched off, and stays off.
import assert from "node:assert/strict";
import { after, test } from "node:test";
import { closeBrowser, openPage, openWorld, until } from "./browser.mjs";

after(closeBrowser);

test("the sound is switched off, and stays off", async () => {
  const { page, troubles, close } = await openPage("/", { draws: false });
  await openWorld(page, "rover");
  const sound = page.locator("button[aria-label=Sound]");
  await until(async () => (await sound.getAttribute("aria-pressed")) === "true", "sounds are on");
  await sound.click();
  assert.equal(await sound.getAttribute("aria-pressed"), "false");
  await page.reload();
  await until(async () => (await sound.getAttribute("aria-pressed")) === "false", "they are off after a reload");
  await page.locator("body").press("u");
  await until(async () => (await sound.getAttribute("aria-pressed")) === "true", "a key switches them on");
  assert.deepEqual(troubles, []);
  await close();
});
