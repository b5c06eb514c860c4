// SPDX-License-Identifier: BSD-2-Clause
// The site without a server, in a browser: worlds run, a lesson is solved, what was typed is there after a reload.
// run_site.py starts it: SOARBOX_PAGE is the address of the site.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, test } from "node:test";
import { apply, closeBrowser, openLesson, openPage, openWorld, picture, show, typeRules, until } from "../../web/e2e/browser.mjs";

after(closeBrowser);

const LESSON = new URL("../../lessons/01-a-rule/", import.meta.url);
const solution = readFileSync(new URL("solution/porter.soar", LESSON), "utf8"), starter = readFileSync(new URL("porter.soar", LESSON), "utf8");

test("a world runs, its minds say why, and its past is shown", async () => {
  const { page, troubles, close } = await openPage("/", { draws: false });
  await openWorld(page, "soar_hallway");
  await until(async () => !/^0:00\b/.test(await page.locator(".scrubber .moment").innerText()), "the world runs");
  await page.locator(".agents tr", { hasText: /\w/ }).last().locator("button").first().click();
  await show(page, "Why");
  await page.locator(".panel.why button", { hasText: "Why this?" }).click();
  await page.waitForSelector(".panel.why .reason");
  await picture(page, "site_world");
  assert.deepEqual(troubles, []);
  await close();
});

test("a lesson is solved and graded, and a reload finds it as it was", async () => {
  const { page, troubles, close } = await openPage("/", { draws: false });
  await openLesson(page, 1);
  await typeRules(page, solution);
  await apply(page);
  await page.locator(".panel.mission button", { hasText: /^Grade$/ }).click();
  await page.waitForSelector(".panel.mission .passed");
  await picture(page, "site_lesson");
  // The browser keeps files a second after they changed.
  await page.waitForTimeout(3000);
  await page.reload();
  await page.waitForSelector(".panel.mission .passed");
  await until(async () => (await page.locator(".cm-content").innerText()).replaceAll(/\s/g, "") === solution.replaceAll(/\s/g, ""), "the solution is in the editor");
  assert.notEqual(solution, starter);
  assert.deepEqual(troubles, []);
  await close();
});
