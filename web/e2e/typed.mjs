// SPDX-License-Identifier: BSD-2-Clause
// Typed text is not lost: after a reload, without a server, and with a second tab on the same place.
import assert from "node:assert/strict";
import { after, test } from "node:test";
import { closeBrowser, openBrowser, openLesson, openPage, until } from "./browser.mjs";
import { COMMAND, startServer } from "./own_server.mjs";

const skip = COMMAND === "" ? "SOARBOX_COMMAND names no program" : false;
after(closeBrowser);

const text = (page) => page.locator(".cm-content").innerText();
/** Adds a line at the end of the text, and waits until it is in the editor. */
async function addLine(page, line) {
  await page.locator(".cm-content").click();
  await page.keyboard.press("Control+End");
  await page.keyboard.insertText(`\n${line}`);
  await until(async () => (await text(page)).includes(line), "the editor has the line");
}

test("a reload right after the last letter, and typing without a server, lose nothing", { skip }, async () => {
  const first = await startServer([]), { page, troubles, close } = await openPage(`${first.address}/`, { draws: false, passed: /WebSocket|ERR_CONNECTION/ });
  await openLesson(page, 1);
  await addLine(page, "# typed before the reload");
  await page.reload();
  await page.waitForSelector(".panel.mission > .title");
  await until(async () => /typed before the reload/.test(await text(page)), "it is there after the reload");
  await first.kill();
  await page.waitForSelector(".pill.lost");
  await addLine(page, "# typed without a server");
  const second = await startServer([], { port: first.port, state: first.state });
  await page.reload();
  // If the run of a place has ended, the page shows the start page or a button. Otherwise it shows the run.
  await page.locator(".start h1:visible, .over-run button.primary:visible, .panel.mission > .title:visible").first().waitFor();
  if ((await page.locator(".over-run button.primary:visible").count()) > 0) await page.locator(".over-run button.primary").click();
  else if ((await page.locator(".start h1:visible").count()) > 0) await openLesson(page, 1);
  await until(async () => /typed before the reload[^]*typed without a server/.test(await text(page)), "both are there when the server is");
  assert.deepEqual(troubles, []);
  await close();
  await second.kill();
});

test("only one of two tabs on a place edits, and the other may take over", { skip }, async () => {
  const server = await startServer([]), { page, troubles, close } = await openPage(`${server.address}/`, { draws: false });
  await openLesson(page, 1);
  const other = await (await (await openBrowser({ draws: false })).newContext()).newPage();
  await other.goto(page.url());
  await other.locator(".panel.edit", { hasText: "Another tab edits the texts of this place." }).waitFor();
  assert.equal(await other.locator(".cm-content").getAttribute("contenteditable"), "false");
  await addLine(page, "# from the first tab");
  await until(async () => /from the first tab/.test(await text(other)), "the second tab follows");
  await other.locator("button", { hasText: "Edit here" }).click();
  await until(async () => (await other.locator(".cm-content").getAttribute("contenteditable")) === "true", "the second tab edits");
  assert.match(await text(other), /from the first tab/);
  await page.locator(".panel.edit", { hasText: "Another tab edits the texts of this place." }).waitFor();
  assert.equal(await page.locator(".cm-content").getAttribute("contenteditable"), "false");
  await addLine(other, "# from the second tab");
  await until(async () => /from the second tab/.test(await text(page)), "the first tab follows");
  await page.locator("button", { hasText: "Edit here" }).click();
  await until(async () => (await page.locator(".cm-content").getAttribute("contenteditable")) === "true", "the first tab edits again");
  assert.match(await text(page), /from the first tab[^]*from the second tab/);
  assert.deepEqual(troubles, []);
  await other.context().close();
  await close();
  await server.kill();
});
