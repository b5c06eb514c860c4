// SPDX-License-Identifier: BSD-2-Clause
// Lua scripts that stop at lines: a click beside a line, local variables, steps, and the run goes on.
import assert from "node:assert/strict";
import { after, test } from "node:test";
import { closeBrowser, openPage, openWorld, picture, show, until } from "./browser.mjs";

after(closeBrowser);

const SCRIPT = "SeekingLuaAgent.lua";

/** The text of the line in which the script is stopped. */
const stoppedText = (page) => page.locator(".cm-line.stopped-line").innerText();

/** The position in the editor of the line with this text. */
const lineBox = (page, text) => page.locator(".cm-line", { hasText: text }).first().boundingBox();

async function clickBeside(page, text) {
  let line = await lineBox(page, text);
  // The text moves while the panel is laid out.
  await until(async () => {
    const before = line;
    await page.waitForTimeout(300);
    line = await lineBox(page, text);
    return line !== null && before !== null && line.y === before.y;
  }, "the text rests");
  const gutter = await page.locator(".cm-stops").boundingBox();
  await page.mouse.click(gutter.x + gutter.width / 2, line.y + line.height / 2);
}

test("a script stops where its user clicked, shows its variables, takes steps and goes on", async () => {
  const { page, troubles, close } = await openPage("/", { size: [1440, 900] });
  await openWorld(page, "thesis");
  // The files in the editor are those of the selected agent.
  await page.locator(".panel.agents tr", { hasText: "SeekingLuaAgent-1" }).getByRole("button").first().click();
  await show(page, "Edit");
  await until(async () => (await page.locator(".panel.edit select option").allInnerTexts()).some((name) => name.startsWith(SCRIPT)), "the script is among the files");
  await page.locator(".panel.edit select").selectOption({ label: SCRIPT });
  await page.locator(".cm-line", { hasText: "function Agent_Update" }).waitFor();
  await clickBeside(page, "local target = agent:GetTarget()");
  await page.waitForSelector(".cm-line.stopped-line");
  assert.match(await stoppedText(page), /local target = agent:GetTarget\(\)/);
  await page.waitForSelector(".cm-stops .stop-set");

  const panel = page.locator(".panel.script");
  await panel.locator("text=deltaTimeInMillis").first().waitFor();
  await panel.getByRole("button", { name: "Step over" }).click();
  await until(async () => /if \(Vector\.Distance/.test(await stoppedText(page)), "the next line");
  await until(async () => /target = /.test(await panel.innerText()), "the new variable");
  await panel.getByLabel(/An expression of Lua/).fill("agent:GetTargetRadius() * 2");
  await panel.getByRole("button", { name: "Watch" }).click();
  await until(async () => /GetTargetRadius\(\) \* 2\s*= 5/.test(await panel.innerText()), "the watched value");
  await picture(page, "script_stopped");
  await page.emulateMedia({ colorScheme: "dark" });
  await picture(page, "script_stopped_dark");

  // The same with keys: over, and on to the next tick.
  await page.locator(".cm-content").click();
  await page.keyboard.press("F10");
  await until(async () => !/if \(Vector\.Distance/.test(await stoppedText(page)), "a step with a key");
  await page.keyboard.press("F8");
  await until(async () => /local target/.test(await stoppedText(page)), "the next tick");

  // Without the stop the run goes on.
  await clickBeside(page, "local target = agent:GetTarget()");
  await until(async () => (await page.locator(".cm-stops .stop-set").count()) === 0, "the stop is gone");
  await page.getByRole("button", { name: "Run", exact: true }).click();
  await until(async () => (await page.locator(".cm-line.stopped-line").count()) === 0, "no line is marked");
  const clock = () => page.locator(".scrubber .moment").innerText(), before = await clock();
  await until(async () => (await clock()) !== before, "time goes on");
  assert.deepEqual(troubles, []);
  await close();
});
