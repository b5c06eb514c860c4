// SPDX-License-Identifier: BSD-2-Clause
// Every lesson of the first course, solved by typing, after a wrong answer and a hint.
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { after, test } from "node:test";
import { closeBrowser, openLesson, openPage, picture, typeRules, until } from "./browser.mjs";

const FOLDER = new URL("../../lessons/", import.meta.url);
const ALL = readdirSync(FOLDER).filter((name) => /^\d\d-/.test(name)).sort();
/** Only lessons about rules: the others are about a world or a script, which a page cannot edit. */
const LESSONS = ALL.filter((name) => /^rules = ".*\.soar"/m.test(readFileSync(new URL(`${name}/lesson.toml`, FOLDER), "utf8")));
/** Some wrong answers, with a pattern of their headline. */
const WRONG = new Map([
  ["03-choices", ["01-better-only", /silver and bronze tie/]],
  ["06-danger", ["01-no-negation", /graze and flee tie, because graze is still proposed/]],
  ["09-support", ["01-elaboration", /Its rule tests no selected operator/]],
]);

const titleOf = (lesson) => /^title = "(.*)"$/m.exec(readFileSync(new URL(`${lesson}/lesson.toml`, FOLDER), "utf8"))[1];
/** A wrong answer to a lesson, and a pattern of its grade: at least a headline before the checks. */
function wrongAnswerOf(lesson) {
  const [wrong, told] = WRONG.get(lesson) ?? [readdirSync(new URL(`${lesson}/wrong/`, FOLDER)).sort()[0], /^grade\s+(?!(yes|no)\s)\S[^\n]{20,}/i];
  return { told, rules: rulesBelow(lesson, `wrong/${wrong}`) };
}
/** The file of rules in a folder of a lesson. */
function rulesBelow(lesson, part) {
  const folder = new URL(`${lesson}/${part}/`, FOLDER), name = readdirSync(folder).find((one) => one.endsWith(".soar"));
  return { name, text: readFileSync(new URL(name, folder), "utf8") };
}
after(closeBrowser);

async function applyAndGrade(page, { name, text }) {
  await page.locator(".panel.edit select").selectOption({ label: name }).catch(() => page.locator(".panel.edit select").selectOption({ label: `${name} •` }));
  await until(async () => (await page.locator(".cm-content").innerText()).includes("sp {"), `${name} is in the editor`);
  await typeRules(page, text);
  await page.keyboard.press("Control+s");
  await until(async () => /Reloaded|no changes/i.test(await page.locator(".panel.edit .under").innerText()), `${name} was reloaded`);
  await page.locator(".panel.mission button", { hasText: /^Grade$/ }).click();
  await page.waitForSelector(".panel.mission [data-part=grade] p");
  await page.waitForSelector(".panel.mission button:has-text('Grade'):enabled");
}

test("each lesson is solved by typing, from the first to the last", async () => {
  const { page, troubles, close } = await openPage("/", { draws: false });
  await openLesson(page, 1);
  for (const [i, lesson] of LESSONS.entries()) {
    const title = titleOf(lesson);
    await until(async () => (await page.locator(".panel.mission > .title").innerText()).endsWith(title), `lesson ${i + 1} is open`);
    await page.waitForSelector(".cm-content .tok-keyword");
    assert.ok((await page.locator(".panel.mission [data-part=task]").innerText()).length > 40);
    const wrong = wrongAnswerOf(lesson);
    await applyAndGrade(page, wrong.rules);
    const grade = await page.locator(".panel.mission [data-part=grade]").innerText();
    assert.match(grade, wrong.told, `lesson ${i + 1}`);
    assert.doesNotMatch(grade, /soarbox run/);
    assert.equal(await page.locator(".panel.mission > p > .good").count(), 0);
    await page.locator(".panel.mission button", { hasText: "Hint 1 of" }).click();
    await page.waitForSelector(".panel.mission [data-part=hints] p");
    await picture(page, `wrong_${lesson}`);
    await applyAndGrade(page, rulesBelow(lesson, "solution"));
    await page.waitForSelector(".panel.mission > p > .good");
    for (let at = ALL.indexOf(lesson); i + 1 < LESSONS.length && ALL[at] !== LESSONS[i + 1]; ++at) {
      await page.locator(".panel.mission button", { hasText: "Next lesson" }).click();
      await until(async () => (await page.locator(".panel.mission > .title").innerText()).endsWith(titleOf(ALL[at + 1])), `${ALL[at + 1]} follows`);
    }
  }
  await page.locator("button.home").click();
  await until(async () => (await page.locator("section[aria-label=Lessons] .card.passed").count()) === LESSONS.length, "all lessons are passed");
  await picture(page, "lessons_all_passed");
  assert.deepEqual(troubles, []);
  await close();
});
