// SPDX-License-Identifier: BSD-2-Clause
// Shared by the end-to-end tests: a browser, the page of a running server, and the actions of a learner.
//   SOARBOX_PAGE      the server's address, by default http://127.0.0.1:8080
//   SOARBOX_BROWSER   the browser, by default /usr/bin/chromium
//   SOARBOX_PATIENCE_S  how long a condition may take (default: 150 s)
//   SOARBOX_PICTURES  a folder for screenshots of the tests
import assert from "node:assert/strict";
import { mkdirSync } from "node:fs";
import { chromium } from "playwright-core";

export const ADDRESS = (process.env.SOARBOX_PAGE ?? "http://127.0.0.1:8080").replace(/\/$/, "");
const PICTURES = process.env.SOARBOX_PICTURES ?? "";
export const PATIENCE_MS = 1000 * Number(process.env.SOARBOX_PATIENCE_S ?? 150);

const browsers = new Map();
/** `draws`: with WebGL. Tests of text are faster without it, because the processor draws. */
export async function openBrowser({ draws = true } = {}) {
  if (!browsers.has(draws)) {
    browsers.set(draws, chromium.launch({
      executablePath: process.env.SOARBOX_BROWSER ?? "/usr/bin/chromium",
      args: ["--no-sandbox", ...(draws ? ["--use-angle=swiftshader", "--enable-unsafe-swiftshader"] : ["--disable-gpu", "--disable-3d-apis"]),
        "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"],
    }));
  }
  return browsers.get(draws);
}
export async function closeBrowser() {
  for (const browser of browsers.values()) await (await browser).close();
  browsers.clear();
}

/** A new page and its errors. `size`: width and height in pixels; `passed`: a pattern of expected errors; `script`: runs in the page first. */
export async function openPage(path = "/", { size = [1280, 800], zoom = 1, scheme = "light", touch = false, draws = true, passed = /^$/, script = null } = {}) {
  const context = await (await openBrowser({ draws })).newContext({ viewport: { width: size[0], height: size[1] }, deviceScaleFactor: zoom, colorScheme: scheme, hasTouch: touch });
  const page = await context.newPage();
  page.setDefaultTimeout(PATIENCE_MS);
  if (script !== null) await page.addInitScript(script);
  const troubles = [], isExpected = (text) => passed.test(text) || (!draws && /WebGL/.test(text));
  page.on("console", (message) => message.type() === "error" && !isExpected(message.text()) && troubles.push(message.text()));
  page.on("pageerror", (error) => troubles.push(String(error.stack ?? error)));
  await page.goto(/^(https?|file):/.test(path) ? path : `${ADDRESS}${path}`);
  return { page, troubles, close: () => context.close() };
}

export async function openWorld(page, name) {
  await page.waitForSelector(".start h1");
  await page.locator("button.card", { has: page.locator("b", { hasText: new RegExp(`^${name}$`) }) }).click();
  await page.waitForSelector(".run-page:not([hidden])");
  await untilMade(page);
}

/** Until the world is made, the page shows the run before. */
async function untilMade(page) {
  await page.locator(".pill", { hasText: "The world is made" }).waitFor({ state: "hidden" });
}

export async function openLesson(page, number) {
  await page.waitForSelector(".start h1");
  await page.locator("ol.cards button.card").nth(number - 1).click();
  await untilMade(page);
  await page.waitForSelector(".panel.mission > .title");
  await page.waitForSelector(".cm-content .tok-keyword");
}

/** Replaces the text in the editor as a learner does: selects everything and types. */
export async function typeRules(page, text) {
  await page.locator(".cm-content").click();
  await page.keyboard.press("Control+a");
  await page.keyboard.press("Delete");
  await page.keyboard.insertText(text);
}

export async function apply(page) {
  await page.keyboard.press("Control+s");
  await page.waitForSelector(".panel.edit .under p");
}

/** Brings a panel to the front by a click on its tab. */
export async function show(page, title) {
  await page.locator("[role=tab]", { hasText: new RegExp(`^${title}(\\d.*)?$`) }).click();
}

/** Waits until `fact` returns true; fails with `what` after PATIENCE_MS. */
export async function until(fact, what) {
  for (const end = Date.now() + PATIENCE_MS; Date.now() < end;) {
    if (await fact()) return;
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
  assert.fail(`it never was so: ${what}`);
}

export async function picture(page, name) {
  if (PICTURES === "") return;
  mkdirSync(PICTURES, { recursive: true });
  await page.screenshot({ path: `${PICTURES}/${name}.png`, timeout: PATIENCE_MS });
}
