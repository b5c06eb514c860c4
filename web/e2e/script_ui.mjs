// SPDX-License-Identifier: BSD-2-Clause
// Output and input of scripts: buttons, bars, images, models from files, gamepads, sounds.
import assert from "node:assert/strict";
import { after, test } from "node:test";
import { closeBrowser, openPage, openWorld, picture, until } from "./browser.mjs";

after(closeBrowser);

test("a world with models, an image, a bar and buttons is played with mouse and gamepad, and its sounds are played", async () => {
  const { page, troubles, close } = await openPage("/");
  await page.evaluate(() => {
    globalThis.soundsBegun = 0;
    const start = AudioBufferSourceNode.prototype.start;
    AudioBufferSourceNode.prototype.start = function (...args) {
      globalThis.soundsBegun += 1;
      return start.apply(this, args);
    };
  });
  await openWorld(page, "rover");
  const button = (name) => page.locator(`.script-ui button[data-button=${name}]`);
  await button("start").waitFor();
  await until(async () => (await button("start").innerText()) === "Start", "the rover waits");
  await until(async () => page.evaluate(() => [...document.querySelectorAll(".script-ui .box")].some((box) => /url\("blob:/.test(box.style.background))), "the badge is an image");
  const filled = async () => parseFloat(await page.locator(".script-ui .bar").evaluate((bar) => bar.style.width));
  assert.equal(await filled(), 100);
  await button("start").click();
  await until(async () => (await button("start").innerText()) === "Stop", "a click reaches the script");
  await until(async () => (await filled()) < 99, "the battery's bar goes down");
  await until(async () => page.evaluate(() => globalThis.soundsBegun > 0), "a sound is heard");
  await picture(page, "rover_1280");

  // Simulates a gamepad. Browsers report one only after a button was pressed.
  await page.evaluate(() => {
    const pad = { index: 0, connected: true, buttons: Array.from({ length: 17 }, () => ({ pressed: false, value: 0 })), axes: [0, 0, 0, 0] };
    globalThis.testPad = pad;
    navigator.getGamepads = () => [pad];
    dispatchEvent(new Event("gamepadconnected"));
    pad.buttons[9] = { pressed: true, value: 1 };
  });
  await until(async () => (await button("start").innerText()) !== "Stop", "the start button of a gamepad reaches the script");
  assert.deepEqual(troubles, []);
  await close();
});

test("a world with a model with a skin shows its animations, and a button starts another one", async () => {
  const { page, troubles, close } = await openPage("/");
  await openWorld(page, "ponies");
  await page.locator(".labels .name", { hasText: "Pony-1" }).first().waitFor();
  await page.locator(".script-ui button[data-button=whistle]").click();
  await until(async () => /trot/.test(await page.locator(".labels").innerText()), "the ponies trot");
  await until(async () => /rear/.test(await page.locator(".labels").innerText()), "a pony rears");
  await picture(page, "ponies_1280");
  assert.deepEqual(troubles, []);
  await close();
});
