// SPDX-License-Identifier: BSD-2-Clause
// Tests the site without a server in Firefox: a world runs and is drawn, its minds say why, its past is shown, and a lesson is
// solved, graded and still there after a reload. `run_site.py --firefox` starts these tests. Playwright, which tests Chromium,
// needs a Firefox of its own; Puppeteer starts the one that Debian packages.
//   SOARBOX_PAGE      the address of the site
//   SOARBOX_FIREFOX   the browser, by default /usr/bin/firefox-esr. It draws only if there is a display (xvfb-run)
//   SOARBOX_PATIENCE_S, SOARBOX_PICTURES   as in web/e2e/browser.mjs
import assert from "node:assert/strict";
import { mkdirSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { after, test } from "node:test";
import { pathToFileURL } from "node:url";

const REPOSITORY = new URL("../../", import.meta.url);
const { default: puppeteer } = await import(pathToFileURL(createRequire(new URL("web/package.json", REPOSITORY)).resolve("puppeteer-core")).href);
const SITE = process.env.SOARBOX_PAGE ?? "http://127.0.0.1:8000/";
const PATIENCE_MS = 1000 * Number(process.env.SOARBOX_PATIENCE_S ?? 150);
const PICTURES = process.env.SOARBOX_PICTURES ?? "";
const textOf = (path) => readFileSync(new URL(path, REPOSITORY), "utf8");

const hasDisplay = (process.env.DISPLAY ?? "") !== "";
const browser = await puppeteer.launch({
  browser: "firefox", executablePath: process.env.SOARBOX_FIREFOX ?? "/usr/bin/firefox-esr", headless: !hasDisplay,
  // On a machine without a graphics card, Firefox draws WebGL only with these two settings.
  env: { ...process.env, LIBGL_ALWAYS_SOFTWARE: "1" }, extraPrefsFirefox: { "webgl.force-enabled": true },
});
after(() => browser.close());

/** A page of a new user, and its errors. */
async function openSite() {
  const context = await browser.createBrowserContext();
  const page = await context.newPage();
  page.setDefaultTimeout(PATIENCE_MS);
  await page.setViewport({ width: 1280, height: 800 });
  const troubles = [], isExpected = (text) => !hasDisplay && /WebGL/.test(text);
  page.on("console", (message) => message.type() === "error" && !isExpected(message.text()) && troubles.push(message.text()));
  page.on("pageerror", (error) => troubles.push(String(error.stack ?? error)));
  await page.goto(SITE);
  await page.waitForSelector(".start h1");
  return { page, troubles, close: () => context.close() };
}

/** Waits for an element that contains a text, and clicks it. */
const click = async (page, selector, text) => page.locator(`${selector} ::-p-text(${text})`).click();
const has = (page, selector) => page.waitForSelector(selector);

/** Waits until a function of the page returns true. */
const until = (page, fact, ...values) => page.waitForFunction(fact, {}, ...values);

async function picture(page, name) {
  if (PICTURES === "") return;
  mkdirSync(PICTURES, { recursive: true });
  await page.screenshot({ path: `${PICTURES}/${name}.png` });
}

/** The picture of the world has many colours. */
async function assertIsDrawn(page) {
  const canvas = await has(page, ".stage canvas");
  const colours = async () => page.evaluate(async (data) => {
    const image = await createImageBitmap(new Blob([Uint8Array.from(atob(data), (letter) => letter.charCodeAt(0))], { type: "image/png" }));
    const context = new OffscreenCanvas(image.width, image.height).getContext("2d");
    context.drawImage(image, 0, 0);
    return new Set(new Uint32Array(context.getImageData(0, 0, image.width, image.height).data.buffer)).size;
  }, await canvas.screenshot({ encoding: "base64" }));
  for (const end = Date.now() + PATIENCE_MS; (await colours()) < 1000;) assert.ok(Date.now() < end, "the world is drawn");
}

/** Replaces the text in the editor as a learner does, and applies it. */
async function applyRules(page, text) {
  await has(page, ".cm-content .tok-keyword");
  await page.locator(".cm-content").click();
  await page.keyboard.down("Control");
  await page.keyboard.press("a");
  await page.keyboard.up("Control");
  await page.keyboard.press("Delete");
  await page.evaluate((typed) => document.execCommand("insertText", false, typed), text);
  await page.keyboard.down("Control");
  await page.keyboard.press("s");
  await page.keyboard.up("Control");
  await until(page, () => /Reloaded/.test(document.querySelector(".panel.edit .under")?.innerText ?? ""));
}

test("a world runs and is drawn, its minds say why, and its past is shown", async () => {
  const { page, troubles, close } = await openSite();
  await until(page, () => [...document.querySelectorAll("button.card b")].some((name) => name.textContent === "soar_flee"));
  await page.evaluate(() => [...document.querySelectorAll("button.card")].find((card) => card.querySelector("b")?.textContent === "soar_flee").click());
  await has(page, ".run-page:not([hidden])");
  await until(page, () => !/^0:00\b/.test(document.querySelector(".scrubber .moment")?.innerText ?? "0:00"));
  if (hasDisplay) await assertIsDrawn(page);
  await click(page, ".agents button", "rabbit");
  await until(page, () => document.querySelector(".agents tr.chosen")?.innerText.includes("rabbit"));
  await click(page, "[role=tab]", "Why");
  await click(page, ".panel.why button", "Why this?");
  await has(page, ".panel.why .tree li");
  await picture(page, "firefox_why");
  await page.focus(".past");
  await page.keyboard.press("Home");
  await until(page, () => [...document.querySelectorAll("button")].some((button) => /Resume here/.test(button.innerText) && !button.disabled));
  await picture(page, "firefox_past");
  assert.deepEqual(troubles, []);
  await close();
});

test("a lesson is solved and graded, and its progress is there the next time", async () => {
  const { page, troubles, close } = await openSite();
  await has(page, "ol.cards button.card");
  await page.locator("ol.cards button.card").click();
  await has(page, ".panel.mission > .title");
  await applyRules(page, textOf("lessons/01-a-rule/solution/porter.soar"));
  await click(page, ".panel.mission button", "Grade");
  await has(page, ".panel.mission > p > .good");
  await picture(page, "firefox_lesson");
  // Changed files are stored after a second.
  await new Promise((resolve) => setTimeout(resolve, 2500));
  await page.reload();
  await until(page, () => /porter\*greet/.test(document.querySelector(".cm-content")?.innerText ?? ""));
  assert.deepEqual(troubles, []);
  await close();
});
