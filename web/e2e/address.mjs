// SPDX-License-Identifier: BSD-2-Clause
// Lessons, worlds, files and moments have addresses. Tests Back, Forward, reload, bookmarks and links to share.
import assert from "node:assert/strict";
import { after, test } from "node:test";
import { ADDRESS, closeBrowser, openLesson, openPage, openWorld, typeRules, until } from "./browser.mjs";

after(closeBrowser);

const title = (page) => page.locator(".run-title").innerText();
const hash = (page) => new URL(page.url()).hash;

test("Back, Forward and reload lead to the lesson, the world, and the start page", async () => {
  const { page, troubles, close } = await openPage("/", { draws: false });
  await openLesson(page, 2);
  await until(() => hash(page) === "#lesson=02-operators", "a lesson has an address");
  await page.locator("button.home").click();
  await until(() => hash(page) === "", "where one begins has one, too");
  await page.reload();
  await page.waitForSelector(".start:visible h1");
  assert.match(await page.locator(".welcome button.primary").innerText(), /Go on with Operators/);
  await openWorld(page, "eaters");
  await until(async () => /world=eaters/.test(hash(page)) && (await title(page)) === "eaters", "a world has an address");
  await page.goBack();
  await page.waitForSelector(".start:visible h1");
  await page.goBack();
  await until(async () => (await title(page)).startsWith("Operators"), "Back leads to the lesson");
  await page.waitForSelector(".panel.mission [data-part=task]");
  await page.goForward();
  await page.goForward();
  await until(async () => (await title(page)) === "eaters", "Forward leads to the world");
  await page.reload();
  await until(async () => (await title(page)) === "eaters", "a reload stays there");
  // Opens a bookmark while the page shows something else.
  await page.goto(`${ADDRESS}/#lesson=03-choices`);
  await until(async () => (await title(page)).startsWith("Preferences") && (await page.locator(".panel.mission [data-part=task]").count()) === 1, "a bookmark leads to its lesson");
  await page.goto(`${ADDRESS}/#lesson=99-nothing`);
  await page.waitForSelector(".start:visible h1, .remark.error");
  assert.deepEqual(troubles, []);
  await close();
});

test("a moment and a file have addresses", async () => {
  const { page, troubles, close } = await openPage("/#world=soar_evade&t=2&file=bear.soar", { draws: false });
  await until(async () => (await page.locator(".scrubber .moment").innerText()).startsWith("0:02.00"), "the moment of the address is shown");
  // The protagonist is selected: the agent that the checks are about.
  await page.waitForSelector(".agents tr.chosen:has-text('hare')");
  await page.locator("#tab-edit").click();
  await until(async () => (await page.locator(".panel.edit select").inputValue()).endsWith("bear.soar"), "the file of the address is in the editor");
  await page.locator(".past").focus();
  await page.keyboard.press("ArrowLeft");
  await until(() => /t=1\.967/.test(hash(page)), "the address follows the moment");
  await page.locator("button", { hasText: "To the newest" }).click();
  await until(() => !/t=/.test(hash(page)), "the newest moment needs none");
  assert.deepEqual(troubles, []);
  await close();
});

test("a link shares the current view, or a copy of the rules, and never the place", async () => {
  const { page, troubles, close } = await openPage("/", { draws: false });
  await openLesson(page, 1);
  await typeRules(page, "# This I give away.\n");
  await page.locator("button[aria-label='Links to share']").click();
  await page.waitForSelector(".qr");
  const links = await page.locator(".dialog input.address").evaluateAll((all) => all.map((one) => one.value)), place = /\/p\/(\w+)\//.exec(page.url())[1];
  assert.equal(links.length, 3);
  assert.deepEqual(links.map((one) => one.includes(place)), [false, false, true]);
  assert.match(links[0], /\/#lesson=01-a-rule$/);
  const other = await openPage(links[1], { draws: false });
  await until(async () => /This I give away/.test(await other.page.locator(".cm-content").innerText()), "the other one has a copy of the text");
  assert.notEqual(/\/p\/(\w+)\//.exec(other.page.url())[1], place);
  await until(() => !/text=/.test(hash(other.page)), "the text is taken out of the address");
  // A draft: the file does not change until the draft is applied.
  await other.page.locator(".panel.edit button", { hasText: "Revert" }).click();
  await until(async () => /porter\*/.test(await other.page.locator(".cm-content").innerText()), "the own text comes back");
  await other.close();
  const broken = await openPage(`${links[1].slice(0, links[1].indexOf("text=") + 12)}`, { draws: false });
  await broken.page.locator(".remark.error", { hasText: "damaged" }).waitFor();
  await broken.close();
  assert.deepEqual(troubles, []);
  await close();
});
