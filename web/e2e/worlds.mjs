// SPDX-License-Identifier: BSD-2-Clause
// A world and its minds: the picture, why, memory, rules, going back, continuing from there, the keyboard, small
// screens, light and dark, and accessibility.
import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { readFileSync } from "node:fs";
import { after, test } from "node:test";
import { closeBrowser, openLesson, openPage, openWorld, picture, show, until } from "./browser.mjs";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
after(closeBrowser);

/**
 * The barriers for users that axe finds, as "rule: element". The page blocks foreign scripts, so the browser injects
 * axe.
 */
async function bars(page) {
  await page.evaluate(axe);
  const found = await page.evaluate(() => globalThis.axe.run(document, { resultTypes: ["violations"] }));
  return found.violations.flatMap((one) => one.nodes.map((node) => `${one.id}: ${node.target.join(" ")}`));
}

/** The page itself must not scroll, only parts of it. (The browser of the tests hides scroll bars.) */
const assertPageStands = async (page) =>
  assert.ok(await page.evaluate(() => document.scrollingElement.scrollHeight <= innerHeight && document.scrollingElement.scrollWidth <= innerWidth), "nothing reaches beyond the screen");

const clockOf = (text) => {
  const [minutes, seconds] = text.split(":");
  return 60 * Number(minutes) + Number(seconds);
};
const shownTime = async (page) => clockOf((await page.locator(".scrubber .moment").innerText()).split("/")[0].trim());

/** The number of colours in a part of the picture; 1: it is empty. */
async function colors(page, selector) {
  const shot = await page.locator(selector).screenshot({ timeout: 150_000 });
  return page.evaluate(async (bytes) => {
    const image = await createImageBitmap(new Blob([Uint8Array.from(bytes)], { type: "image/png" })), canvas = new OffscreenCanvas(image.width, image.height), out = canvas.getContext("2d");
    out.drawImage(image, 0, 0);
    const { data } = out.getImageData(0, 0, image.width, image.height), seen = new Set();
    for (let i = 0; i < data.length; i += 4 * 37) seen.add((data[i] >> 4) * 256 + (data[i + 1] >> 4) * 16 + (data[i + 2] >> 4));
    return seen.size;
  }, [...shot]);
}

test("soldiers are drawn, reasons are shown, and the past is visited and left again", async () => {
  const { page, troubles, close } = await openPage("/", { size: [1100, 640] });
  await openWorld(page, "soar_skirmish");
  await page.waitForSelector(".labels .name");
  await until(async () => (await colors(page, ".stage canvas")) > 60, "the picture has many colours");
  await until(async () => (await shownTime(page)) > 3, "the world runs");
  await page.keyboard.press("Space");
  await page.waitForSelector(".flow-bar button[aria-label=Run]");
  await picture(page, "skirmish_1100");

  await page.locator(".agents button", { hasText: "red-1" }).click();
  await page.waitForSelector(".agents tr.chosen:has-text('red-1')");
  await show(page, "Why");
  await page.locator(".panel.why button", { hasText: "Why this?" }).click();
  await page.waitForSelector(".panel.why .tree li");
  assert.match(await page.locator(".panel.why h3").innerText(), /red-1/);
  await page.locator(".panel.why input").fill("fighter*propose*nothing");
  await page.locator(".panel.why button", { hasText: "Why not?" }).click();
  await until(async () => /nothing|no rule|neither/i.test(await page.locator(".panel.why").innerText()), "it says that there is no such rule");
  await show(page, "Memory");
  await page.waitForSelector(".panel.memory .attribute");
  await show(page, "Rules");
  await page.locator(".panel.rules td button.row-press").first().click();
  await page.waitForSelector(".panel.rules .story td");
  await picture(page, "skirmish_rules");
  await show(page, "Senses");
  await page.waitForSelector(".panel.links .attribute:visible");
  await show(page, "Mind");
  await page.waitForSelector(".panel.mind tr");
  await show(page, "Trace");
  await page.waitForSelector(".panel.trace tbody tr");
  await show(page, "Messages");
  await page.waitForSelector(".panel.messages");
  await show(page, "Plots");
  await page.locator(".panel.plots input").fill("health");
  await page.locator(".panel.plots button[type=submit]").click();
  await page.waitForSelector(".panel.plots .u-over");
  await show(page, "Console");
  await page.locator(".panel.console input").fill("print s1");
  await page.keyboard.press("Enter");
  await until(async () => /\^io/.test(await page.locator("ol.transcript").innerText()), "the console answers");
  await show(page, "Timeline");
  await page.waitForSelector("canvas.timeline");

  const before = await shownTime(page);
  await page.locator(".past").focus();
  for (let i = 0; i < 30; ++i) await page.keyboard.press("ArrowLeft");
  await until(async () => (await shownTime(page)) <= before - 0.5, "a past moment is shown");
  await page.waitForSelector("button:has-text('Resume here'):enabled");
  await picture(page, "skirmish_past");
  await page.locator("button", { hasText: "Resume here" }).click();
  await page.waitForSelector(".is-live");
  await page.locator(".stage canvas").focus();
  await page.keyboard.press(".");
  await show(page, "Futures");
  await until(async () => /went on from/.test(await page.locator(".panel.futures").innerText()), "the old future is known");
  assert.deepEqual(troubles, []);
  await close();
});

test("with the keyboard alone: run, step, select, cameras, panels, keys", async () => {
  const { page, troubles, close } = await openPage();
  await page.waitForSelector(".start h1");
  await until(async () => {
    await page.keyboard.press("Tab");
    return page.evaluate(() => document.activeElement?.textContent?.startsWith("Begin with lesson") ?? false);
  }, "Tab comes to the first lesson");
  await page.keyboard.press("Enter");
  await page.waitForSelector(".panel.mission > .title");
  await page.waitForSelector(".cm-content .tok-keyword");
  await page.waitForSelector(".labels .name.selected");
  await page.locator(".stage canvas").focus();
  await page.keyboard.press("Space");
  await page.waitForSelector(".flow-bar button[aria-label=Run]");
  const at = await shownTime(page);
  await page.keyboard.press(".");
  await until(async () => (await shownTime(page)) > at, "one tick");
  const chosen = await page.locator(".labels .name.selected b").innerText();
  await page.keyboard.press("n");
  await show(page, "Agents");
  await until(async () => (await page.locator(".agents tr.chosen button").allInnerTexts()).some((name) => name !== chosen), "the next agent is selected");
  await page.keyboard.press("m");
  await page.waitForSelector(".stage-tools button[aria-label^=Map][aria-pressed=true]");
  await page.keyboard.press("o");
  await page.keyboard.press("Alt+1");
  await page.waitForSelector("#tab-why[aria-selected=true]");
  await page.locator("#tab-why").focus();
  await page.keyboard.press("ArrowRight");
  await page.waitForSelector("#tab-mind[aria-selected=true]:focus");
  await page.keyboard.press("?");
  await page.waitForSelector("[role=dialog]");
  await page.keyboard.press("Escape");
  await until(async () => (await page.locator("[role=dialog]").count()) === 0, "the list of keys is closed");
  // Escape and Tab leave the editor.
  await page.locator(".cm-content").focus();
  await page.keyboard.press("Escape");
  await page.keyboard.press("Tab");
  assert.equal(await page.evaluate(() => document.activeElement?.closest(".cm-content") === null), true);
  assert.deepEqual(troubles, []);
  await close();
});

test("arrow keys move in lists and trees and move the bars between panels; everything works at a zoom of 200 %", async () => {
  const { page, troubles, close } = await openPage("/", { draws: false });
  await openLesson(page, 6);
  await show(page, "Agents");
  const names = page.locator(".panel.agents td button.row-press");
  await names.first().focus();
  await page.keyboard.press("ArrowDown");
  assert.equal(await page.evaluate(() => document.activeElement.textContent), await names.nth(1).innerText());
  await page.keyboard.press("Home");
  assert.equal(await page.evaluate(() => document.activeElement.textContent), await names.first().innerText());
  await show(page, "Senses");
  const fold = page.locator(".panel.links button.fold:visible").first();
  await fold.focus();
  await page.keyboard.press("ArrowLeft");
  await page.waitForSelector(".panel.links button.fold[aria-expanded=false]:focus");
  await page.keyboard.press("ArrowRight");
  await page.waitForSelector(".panel.links button.fold[aria-expanded=true]:focus");
  const bar = page.locator("[role=separator][aria-orientation=horizontal]"), high = async () => (await page.locator(".dock.bottom").boundingBox()).height;
  const before = await high();
  await bar.focus();
  await page.keyboard.press("ArrowUp");
  await until(async () => (await high()) > before, "the bar moves");
  // 200 % of 1280 x 800.
  await page.setViewportSize({ width: 640, height: 400 });
  await page.waitForSelector("[data-shape=narrow]");
  for (const selector of [".stage", ".dock"]) assert.ok((await page.locator(selector).boundingBox()).height >= 190, `${selector} is large enough`);
  await show(page, "Mission");
  await page.locator(".panel.mission [data-part=task]").scrollIntoViewIfNeeded();
  assert.ok(await page.locator(".panel.mission [data-part=task]").isVisible());
  await picture(page, "zoom_200");
  assert.deepEqual(troubles, []);
  await close();
});

for (const scheme of ["light", "dark"]) {
  test(`nothing bars people, in ${scheme} colours: the beginning, a lesson, a dialog, a phone`, async () => {
    const { page, troubles, close } = await openPage("/", { scheme });
    await page.waitForSelector(".start h1");
    await assertPageStands(page);
    assert.deepEqual(await bars(page), []);
    await picture(page, `start_1280_${scheme}`);
    await page.locator("button[aria-label='Links to share']").click();
    await page.waitForSelector(".dialog :is(.qr, .address, h2)");
    assert.deepEqual(await bars(page), []);
    await picture(page, `link_${scheme}`);
    await page.keyboard.press("Escape");
    await openLesson(page, 6);
    await page.waitForSelector(".labels .name");
    await page.keyboard.press("Escape");
    await assertPageStands(page);
    assert.deepEqual(await bars(page), []);
    await picture(page, `lesson_1280_${scheme}`);
    await show(page, "Why");
    await page.locator(".panel.why button", { hasText: "Why this?" }).click();
    await page.waitForSelector(".panel.why .tree li");
    assert.deepEqual(await bars(page), []);
    await show(page, "Senses");
    await page.waitForSelector(".panel.links .attribute:visible");
    assert.deepEqual(await bars(page), []);
    await page.setViewportSize({ width: 390, height: 780 });
    await page.waitForSelector("[data-shape=narrow]");
    await assertPageStands(page);
    assert.deepEqual(await bars(page), []);
    await picture(page, `lesson_390_${scheme}`);
    await page.setViewportSize({ width: 360, height: 640 });
    await assertPageStands(page);
    await show(page, "Edit");
    await page.waitForSelector(".cm-content .tok-keyword");
    await picture(page, `editor_360_${scheme}`);
    assert.deepEqual(troubles, []);
    await close();
  });
}
