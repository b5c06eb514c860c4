// SPDX-License-Identifier: BSD-2-Clause
// A lesson from beginning to end: a wrong answer and its grade, hints, an error with its fix, the solution, the grade, the next lesson.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, test } from "node:test";
import { apply, closeBrowser, openLesson, openPage, picture, typeRules, until } from "./browser.mjs";

const file = (name) => readFileSync(new URL(`../../lessons/01-a-rule/${name}`, import.meta.url), "utf8");
after(closeBrowser);

async function assertIsSeen(page, selector, what) {
  await until(async () => {
    const box = await page.locator(selector).first().boundingBox();
    return box !== null && box.y >= 0 && box.y + box.height <= page.viewportSize().height && box.x >= 0 && box.x + box.width <= page.viewportSize().width;
  }, what);
}

test("checks are neutral before there is anything to judge, restart with Apply, follow time travel, and forget a discarded future", async () => {
  const { page, troubles, close } = await openPage("/", { draws: false });
  await openLesson(page, 3);
  const rules = readFileSync(new URL("../../lessons/03-choices/solution/runner.soar", import.meta.url), "utf8");
  const seconds = async () => {
    const [minutes, rest] = (await page.locator(".scrubber .moment").innerText()).split("/")[0].trim().split(":");
    return 60 * Number(minutes) + Number(rest);
  };
  await until(async () => (await seconds()) > 3, "the world runs");
  assert.equal(await page.locator(".check.failed").count(), 0, "nobody has done anything that could be wrong");
  await typeRules(page, rules);
  await page.keyboard.press("Control+Enter");
  await until(async () => (await seconds()) < 3, "the run begins again with the rules");
  await page.waitForSelector(".check.passed");
  await until(async () => (await page.locator(".check.passed").count()) === (await page.locator(".check").count()), "all checks come true");
  assert.match(await page.locator("#tab-mission .badge").innerText(), /^(\d+)\/\1$/);

  // At the beginning no check had passed yet. After the run resumes there, the later ticks are removed.
  await page.locator(".past").focus();
  await page.keyboard.press("Home");
  await until(async () => (await page.locator(".check.passed").count()) === 0, "the past shows what was known then");
  await page.waitForSelector("button:has-text('Resume here'):enabled");
  await page.locator("button", { hasText: "Resume here" }).click();
  await page.waitForSelector(".is-live");
  await page.waitForSelector(".panel.mission [data-part=note]:has-text('earlier moment')");
  assert.equal(await page.locator(".check.passed").count(), 0);
  await page.locator(".panel.mission [data-part=note] button", { hasText: "Begin again" }).click();
  await page.waitForSelector(".check.passed");
  assert.equal(await page.locator(".panel.mission [data-part=note]").count(), 0);
  assert.deepEqual(troubles, []);
  await close();
});

test("lesson 1, from the first click to the next lesson", async () => {
  const { page, troubles, close } = await openPage("/", { draws: false });
  await openLesson(page, 1);
  assert.match(await page.locator(".panel.mission [data-part=task]").innerText(), /Greet each visitor by name/);
  assert.doesNotMatch(await page.locator(".panel.mission [data-part=task]").innerText(), /Alt\+/);
  assert.match(await page.locator(".cm-content").innerText(), /porter\*greet/);

  // An error is shown at its place, with a fix, and the world continues with the previous rules.
  await typeRules(page, file("porter.soar").replace("^io.input-link.agent <a>)", "^io.input-link.agent <a>"));
  await page.waitForSelector(".panel.edit .problem.error");
  await page.waitForSelector(".cm-lintRange-error");
  await picture(page, "lesson_error");
  await apply(page);
  await until(async () => /previous version keeps running/.test(await page.locator(".panel.edit .under").innerText()), "an error keeps the previous version");

  // A slip is corrected by one click.
  await typeRules(page, file("porter.soar").replace("^io.input-link.agent", "^io.input-link.agnet"));
  // Waits until the list and the marks are about this text: until the answer arrives, those of the previous text are
  // shown.
  await page.locator(".panel.edit .problem", { hasText: "agnet" }).first().waitFor();
  await page.locator(".cm-lintRange", { hasText: "agnet" }).first().waitFor();
  await page.keyboard.press("Escape");
  const remedy = page.locator(".cm-diagnosticAction", { hasText: "Change to agent" }).first();
  await until(async () => {
    await page.keyboard.press("F8");
    return (await remedy.isVisible()) && remedy.click({ timeout: 1000 }).then(() => true, () => false);
  }, "F8 shows the slip, and a click mends it");
  await until(async () => /input-link\.agent/.test((await page.locator(".cm-content").innerText()).replace(/\s/g, "")), "the remedy is in the text");

  // A wrong answer gets hints, and a grade with the reason.
  await typeRules(page, file("wrong/03-constant/porter.soar"));
  await apply(page);
  await until(async () => /Reloaded/.test(await page.locator(".panel.edit .under").innerText()), "it was reloaded");
  await page.locator(".panel.mission button", { hasText: "Hint 1 of 3" }).click();
  await page.waitForSelector(".panel.mission [data-part=hints] p");
  await page.locator(".panel.mission button", { hasText: "Grade" }).click();
  await page.waitForSelector(".panel.mission [data-part=grade]");
  await until(async () => /never bert/.test(await page.locator(".panel.mission [data-part=grade]").innerText()), "the grade says what is wrong");
  await picture(page, "lesson_wrong");
  await assertIsSeen(page, ".panel.mission [data-part=grade] p b", "the cause is where the eye is");
  assert.equal(await page.evaluate(() => document.activeElement?.dataset.part), "grade", "and so is the focus");

  await typeRules(page, file("solution/porter.soar"));
  await apply(page);
  await page.locator(".panel.mission button", { hasText: /^Grade$/ }).click();
  await page.waitForSelector(".panel.mission > p > .good");
  await assertIsSeen(page, ".panel.mission [data-part=grade] .title", "a pass is celebrated where the eye is");
  await assertIsSeen(page, ".panel.mission [data-part=grade] button", "and leads to the next lesson");
  await picture(page, "lesson_passed");
  await page.locator(".panel.mission button", { hasText: "Next lesson" }).click();
  await until(async () => /Operators/.test(await page.locator(".panel.mission > .title").innerText()), "the next lesson is open");
  await page.locator("button.home").click();
  await page.waitForSelector(".card.passed");
  assert.match(await page.locator(".welcome button.primary").innerText(), /Operators/, "the main button is the next thing to do");
  assert.deepEqual(troubles, []);
  await close();
});
