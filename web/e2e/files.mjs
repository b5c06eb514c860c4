// SPDX-License-Identifier: BSD-2-Clause
// Actions of the editor: formatting, renaming, going to a definition, and creating files.
import assert from "node:assert/strict";
import { after, test } from "node:test";
import { apply, closeBrowser, openLesson, openPage, openWorld, picture, typeRules, until } from "./browser.mjs";

after(closeBrowser);

const text = async (page) => (await page.locator(".cm-line").allInnerTexts()).map((line) => line.replace(/\n$/, "")).join("\n");
/** Moves the caret into the first occurrence of a word. */
async function caretAt(page, word) {
  await page.locator(".cm-content").click();
  await page.keyboard.press("Control+Home");
  const all = await text(page), at = all.indexOf(word), before = all.slice(0, at + 1);
  const lines = before.split("\n");
  for (let i = 1; i < lines.length; ++i) await page.keyboard.press("ArrowDown");
  await page.keyboard.press("Home");
  await page.keyboard.press("Home");
  for (let i = 0; i < lines.at(-1).length; ++i) await page.keyboard.press("ArrowRight");
}

test("rules are formatted, a name is renamed, and F12 goes to the rule that makes it", async () => {
  const { page, troubles, close } = await openPage("/", { draws: false });
  await openLesson(page, 1);
  await typeRules(page, "sp {porter*make\n(state <s> ^superstate nil)\n-->\n (<s> ^mood good)}\nsp {porter*use\n(state <s> ^mood good)\n-->\n(write |hello|)}\n");
  await page.locator(".commands button", { hasText: "Lay out" }).click();
  await until(async () => /\n   \(<s> \^mood good\)\}/.test(await text(page)), "conditions and actions are indented");
  await caretAt(page, "mood good");
  await page.keyboard.press("F2");
  const field = page.locator("input[aria-label='New name of mood']");
  await field.fill("temper");
  await page.keyboard.press("Enter");
  await until(async () => (await text(page)).match(/\^temper good/g)?.length === 2 && !/mood/.test(await text(page)), "both places have the new name");
  await picture(page, "renamed");
  await page.keyboard.press("Control+z");
  await until(async () => (await text(page)).match(/\^mood good/g)?.length === 2, "one step back");
  // From a condition to the action that creates its element.
  const all = await text(page), lines = all.split("\n"), use = lines.findIndex((line) => line.includes("porter*use")), made = lines.findIndex((line) => line.includes("(<s> ^mood good)"));
  assert.ok(made >= 0 && made < use, all);
  await page.locator(".cm-content").click();
  await page.keyboard.press("Control+Home");
  const condition = lines.findIndex((line, i) => i > use && line.includes("^mood"));
  for (let i = 0; i < condition; ++i) await page.keyboard.press("ArrowDown");
  for (let i = 0; i < lines[condition].indexOf("mood") + 1; ++i) await page.keyboard.press("ArrowRight");
  await page.keyboard.press("F12");
  await until(async () => (await page.locator(".cm-activeLine").innerText()).includes("^mood good") && (await page.locator(".cm-lineNumbers .cm-activeLineGutter").innerText()) === String(made + 1), "the caret is at the action");
  assert.deepEqual(troubles, []);
  await close();
});

test("a new file is created next to the first, sourced, and its rules are loaded", async () => {
  const { page, troubles, close } = await openPage("/", { draws: false, passed: /404/ });
  await openWorld(page, "soar_hallway");
  await page.locator("#tab-edit").click();
  await page.waitForSelector(".cm-content .tok-keyword");
  const first = await page.locator(".panel.edit select option:checked").innerText();
  await page.locator(".commands button", { hasText: "New file" }).click();
  await page.locator("input[aria-label='Name of the new file']").fill("greetings");
  await page.locator(".panel.edit form button", { hasText: "Create" }).click();
  await until(async () => (await text(page)).includes("# greetings.soar"), "the new file is in the editor");
  await typeRules(page, "sp {hello*once\n   (state <s> ^superstate nil)\n-->\n   (<s> ^greeted yes)}\n");
  await apply(page);
  await page.locator(".panel.edit select[aria-label=File]").selectOption({ label: first });
  await until(async () => /sp \{/.test(await text(page)) && !/hello\*once/.test(await text(page)), "the first file is back");
  await page.locator(".cm-content").click();
  await page.keyboard.press("Control+End");
  await page.keyboard.insertText("\nsource greetings.soar\n");
  await apply(page);
  await page.locator("#tab-rules").click();
  await page.locator(".panel.rules", { hasText: "hello*once" }).waitFor();
  // The same name again is refused.
  await page.locator("#tab-edit").click();
  await page.locator(".commands button", { hasText: "New file" }).click();
  await page.locator("input[aria-label='Name of the new file']").fill("greetings.soar");
  await page.keyboard.press("Enter");
  await page.locator(".remark.error", { hasText: "already" }).waitFor();
  assert.deepEqual(troubles, []);
  await close();
});
