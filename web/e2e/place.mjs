// SPDX-License-Identifier: BSD-2-Clause
// Downloading and uploading the folder of a learner's place, and touch gestures.
import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import { apply, closeBrowser, openLesson, openPage, openWorld, typeRules, until } from "./browser.mjs";

after(closeBrowser);

test("a folder is downloaded, lost, and comes back by an upload", async () => {
  const { page, troubles, close } = await openPage("/", { draws: false });
  await openLesson(page, 1);
  await typeRules(page, "# Kept in a zip.\n");
  await apply(page);
  await page.locator("button.home").click();
  const [download] = await Promise.all([page.waitForEvent("download"), page.locator("button", { hasText: "Download my folder" }).click()]);
  assert.equal(download.suggestedFilename(), "soarbox.zip");
  const zip = readFileSync(await download.path());
  assert.equal(zip.subarray(0, 2).toString(), "PK");
  assert.ok(zip.includes("porter.soar"));

  // Another user uploads it into another place.
  const other = await openPage("/", { draws: false, passed: /400/ });
  await other.page.waitForSelector(".start h1");
  const folder = mkdtempSync(join(tmpdir(), "soarbox-"));
  writeFileSync(join(folder, "folder.zip"), zip);
  await other.page.locator("input[type=file]").setInputFiles(join(folder, "folder.zip"));
  await other.page.locator(".remark", { hasText: "folder.zip is in your place now" }).waitFor();
  await other.page.locator("ol.cards button.card").first().click();
  await until(async () => /Kept in a zip/.test(await other.page.locator(".cm-content").innerText()), "the uploaded rules are in the editor");

  // A file that is not an archive is refused with a message.
  await other.page.locator("button.home").click();
  writeFileSync(join(folder, "odd.zip"), "no archive at all");
  await other.page.locator("input[type=file]").setInputFiles(join(folder, "odd.zip"));
  await other.page.locator(".remark.error", { hasText: "zip" }).waitFor();
  assert.deepEqual(troubles, []);
  assert.deepEqual(other.troubles, []);
  await close();
  await other.close();
});

/**
 * Simulates fingers by events that are created in the page. Touches through the browser's protocol are not reliable:
 * the browser drops them if it is late with drawing, or if its last picture has no listener at their position.
 * `way`: start and end of each finger.
 */
const fingers = (page, selector, way) => page.locator(selector).evaluate((element, ends) => {
  const STEPS = 4;
  const at = (step) => ends.map(([[x, y], [toX, toY]], id) => ({ identifier: id, clientX: x + ((toX - x) * step) / STEPS, clientY: y + ((toY - y) * step) / STEPS }));
  const tell = (kind, touchKind, points) => {
    for (const { identifier, clientX, clientY } of points)
      element.dispatchEvent(new PointerEvent(`pointer${kind}`, { pointerId: 100 + identifier, pointerType: "touch", isPrimary: identifier === 0, clientX, clientY, bubbles: true, cancelable: true, buttons: kind === "up" ? 0 : 1 }));
    const touches = points.map((point) => new Touch({ ...point, target: element }));
    element.dispatchEvent(new TouchEvent(`touch${touchKind}`, { touches: touchKind === "end" ? [] : touches, changedTouches: touches, bubbles: true, cancelable: true }));
  };
  tell("down", "start", at(0));
  for (let step = 1; step <= STEPS; ++step) tell("move", "move", at(step));
  tell("up", "end", at(STEPS));
}, way);

test("with touch: a body is selected, the camera turns, zooms and moves, panels are swiped", async () => {
  const { page, troubles, close } = await openPage("/", { size: [390, 780], touch: true });
  await openWorld(page, "soar_wander");
  await page.waitForSelector(".labels .name");
  await page.locator("button[aria-label=Pause], .flow-bar button").first().click();
  await page.waitForSelector(".flow-bar button[aria-label=Run]");
  const drawn = () => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  // The positions of the names show whether the camera has moved.
  const names = () => page.locator(".labels").evaluate((labels) => [...labels.querySelectorAll(".name")].map((one) => one.style.transform).join());
  const still = async () => {
    let last = "";
    await until(async () => {
      await drawn();
      const now = await names(), isStill = now === last;
      last = now;
      return isStill;
    }, "the picture stands still");
    return last;
  };
  // The browser must not handle touches of the picture itself.
  assert.equal(await page.locator(".stage canvas").evaluate((canvas) => getComputedStyle(canvas).touchAction), "none");
  const box = await page.locator(".stage canvas").boundingBox(), x = box.x + box.width / 2, y = box.y + box.height / 2;
  for (const [what, ...way] of [
    ["one finger turns the camera", [[x, y], [x + 90, y]]],
    ["two fingers go nearer", [[x - 30, y], [x - 90, y]], [[x + 30, y], [x + 90, y]]],
    ["two fingers move what is looked at", [[x - 30, y], [x - 30, y + 60]], [[x + 30, y], [x + 30, y + 60]]],
  ]) {
    // After the previous gesture, the picture may contain no names.
    await page.locator("button[aria-label='Show everybody']").click();
    await page.waitForSelector(".labels .name");
    const before = await still();
    await fingers(page, ".stage canvas", way);
    await until(async () => {
      assert.deepEqual(troubles, []);
      return (await names()) !== before;
    }, what);
  }
  await page.locator("button[aria-label='Show everybody']").click();
  await page.waitForSelector(".labels .name");
  // Moves one agent into the middle of the picture, selects another one, and then selects the first one with a finger.
  const chosen = async () => (await page.locator(".labels .name.selected b").allInnerTexts()).join();
  await page.locator(".labels .name").first().evaluate((label) => label.click());
  await page.waitForSelector(".labels .name.selected");
  const one = await chosen();
  await page.locator(".stage canvas").dispatchEvent("dblclick");
  await page.locator(".stage canvas").focus();
  await page.keyboard.press("n");
  await until(async () => (await chosen()) !== one, "somebody else is selected");
  await still();
  await fingers(page, ".stage canvas", [[[x, y], [x, y]]]);
  await until(async () => (await chosen()) === one, "a finger on a body selects it");
  const front = () => page.locator("[role=tab][aria-selected=true]").innerText();
  const before = await front(), panel = await page.locator("[role=tabpanel]:visible").boundingBox(), low = panel.y + panel.height - 30;
  await fingers(page, "[role=tabpanel]:visible", [[[panel.x + 300, low], [panel.x + 60, low]]]);
  await until(async () => (await front()) !== before, "a swipe shows the panel beside it");
  assert.deepEqual(troubles, []);
  await close();
});
