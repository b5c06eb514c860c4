// SPDX-License-Identifier: BSD-2-Clause
// The site without a server, in a browser: a world runs, its rules are changed and the change is applied, and it works
// without a network. run_site.py starts it: SOARBOX_PAGE is the address of the site.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, test } from "node:test";
import { apply, closeBrowser, openLesson, openPage, openWorld, picture, show, typeRules, until } from "../../web/e2e/browser.mjs";

after(closeBrowser);

const SITE = process.env.SOARBOX_PAGE ?? "http://127.0.0.1:8000/";
const textOf = (path) => readFileSync(new URL(`../../${path}`, import.meta.url), "utf8");
const inEditor = async (page) => (await page.locator(".cm-content").innerText()).replaceAll(/\s/g, "");

test("a world runs, its minds say why, its past is shown, and new rules take effect", async () => {
  const { page, troubles, close } = await openPage(SITE, { draws: false });
  await openWorld(page, "soar_flee");
  await until(async () => !/^0:00\b/.test(await page.locator(".scrubber .moment").innerText()), "the world runs");
  await page.locator(".agents button", { hasText: "rabbit" }).click();
  await page.waitForSelector(".agents tr.chosen:has-text('rabbit')");
  await show(page, "Why");
  await page.locator(".panel.why button", { hasText: "Why this?" }).click();
  await page.waitForSelector(".panel.why .reason");
  await picture(page, "site_world");
  await page.locator(".past").focus();
  await page.keyboard.press("Home");
  await page.waitForSelector("button:has-text('Resume here'):enabled");
  await page.locator("button", { hasText: "To the newest" }).click();

  // Another rule for the rabbit.
  await page.locator("#tab-edit").click();
  await page.locator(".panel.edit select").selectOption({ label: "rabbit.soar" });
  await until(async () => (await inEditor(page)).includes("rabbit*propose*rest"), "the rabbit's rules are in the editor");
  await typeRules(page, `${textOf("scenarios/soar_flee/rabbit.soar")}\nsp {rabbit*note*here\n   (state <s> ^superstate nil)\n-->\n   (<s> ^here yes)\n}\n`);
  await apply(page);
  await until(async () => /Reloaded/.test(await page.locator(".panel.edit .under").innerText()), "the rules are reloaded");
  await picture(page, "site_edit");
  assert.deepEqual(troubles, []);
  await close();
});

test("a lesson is solved and graded, and its progress is there the next time", async () => {
  const { page, troubles, close } = await openPage(SITE, { draws: false });
  await openLesson(page, 1);
  await page.locator(".panel.mission button", { hasText: /^Grade$/ }).click();
  await page.waitForSelector(".panel.mission .grade p");
  await page.waitForSelector(".panel.mission button:has-text('Grade'):enabled");
  assert.equal(await page.locator(".panel.mission .passed").count(), 0, "nothing is solved yet");
  await typeRules(page, textOf("lessons/01-a-rule/solution/porter.soar"));
  await apply(page);
  await until(async () => /Reloaded/.test(await page.locator(".panel.edit .under").innerText()), "the rules are reloaded");
  await page.locator(".panel.edit button", { hasText: /^Save$/ }).click().catch(() => undefined);
  await page.locator(".panel.mission button", { hasText: /^Grade$/ }).click();
  await page.waitForSelector(".panel.mission .passed");
  await picture(page, "site_lesson");
  await page.waitForTimeout(2500);  // Files are kept a second after each change.
  await page.reload();
  await until(async () => /porter\*greet/.test(await page.locator(".cm-content").innerText()), "the rules are there again");
  assert.deepEqual(troubles, []);
  await close();
});

test("after the first visit the site works without a network", { skip: SITE.startsWith("file:") && "one file needs none" }, async () => {
  const { page, troubles, close } = await openPage(SITE, { draws: false });
  await page.waitForSelector(".start h1");
  await page.evaluate(async () => void (await navigator.serviceWorker.ready));
  await page.context().setOffline(true);
  await page.reload();
  await openWorld(page, "soar_flee");
  await until(async () => !/^0:00\b/.test(await page.locator(".scrubber .moment").innerText()), "the world runs");
  assert.deepEqual(troubles, []);
  await close();
});
