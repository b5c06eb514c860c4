// SPDX-License-Identifier: BSD-2-Clause
// Takes the pictures of the site for the documents, in Chromium and Firefox, and 390 px wide as on a phone. `./dev pictures site` builds
// the site, starts this below a display, and makes the pictures smaller.
//   SOARBOX_PAGE      the address of the site
//   SOARBOX_PICTURES  the folder of the pictures
//   SOARBOX_BROWSER, SOARBOX_FIREFOX   the browsers
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { test } from "node:test";
import { pathToFileURL } from "node:url";

const REPOSITORY = new URL("../../", import.meta.url);
const { default: puppeteer } = await import(pathToFileURL(createRequire(new URL("web/package.json", REPOSITORY)).resolve("puppeteer-core")).href);
const { SOARBOX_PAGE: SITE = "http://127.0.0.1:8000/", SOARBOX_PICTURES: PICTURES = "." } = process.env;
const PATIENCE_MS = 300_000, WIDE = [1280, 800], PHONE = [390, 844];

function launch(name) {
  if (name === "Firefox") {
    return puppeteer.launch({ browser: "firefox", executablePath: process.env.SOARBOX_FIREFOX ?? "/usr/bin/firefox-esr", headless: false, protocolTimeout: PATIENCE_MS,
      env: { ...process.env, LIBGL_ALWAYS_SOFTWARE: "1" }, extraPrefsFirefox: { "webgl.force-enabled": true } });
  }
  return puppeteer.launch({ browser: "chrome", executablePath: process.env.SOARBOX_BROWSER ?? "/usr/bin/chromium", headless: true, protocolTimeout: PATIENCE_MS,
    args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--no-first-run", "--disable-background-networking", "--hide-scrollbars"] });
}

const until = (page, fact, ...values) => page.waitForFunction(fact, { timeout: PATIENCE_MS }, ...values);
/** Waits for an element with a text, and clicks it. */
async function click(page, selector, text) {
  await until(page, (where, what) => [...document.querySelectorAll(where)].some((one) => one.innerText.includes(what) || one.getAttribute("aria-label") === what), selector, text);
  await page.evaluate((where, what) => [...document.querySelectorAll(where)].find((one) => one.innerText.includes(what) || one.getAttribute("aria-label") === what).click(), selector, text);
}
/** Waits until the world has run for some seconds, and pauses it. */
async function pauseAt(page, seconds) {
  await until(page, (least) => {
    const [minutes, rest] = (document.querySelector(".scrubber .moment")?.innerText ?? "0:00").split(":");
    return Number(minutes) * 60 + parseFloat(rest) >= least;
  }, seconds);
  await page.focus(".stage canvas");
  await page.keyboard.press(" ");
  await page.waitForSelector(".flow-bar button[aria-label=Run]", { timeout: PATIENCE_MS });
  // Without the frame that shows the focus.
  await page.evaluate(() => document.activeElement?.blur());
  // Surfaces and clouds are painted in the seconds after the first picture.
  await new Promise((done) => setTimeout(done, 8000));
}

const solved = () => readFileSync(new URL("lessons/01-a-rule/solution/porter.soar", REPOSITORY), "utf8");

async function typeRules(page, text) {
  await page.waitForSelector(".cm-content .tok-keyword", { timeout: PATIENCE_MS });
  await page.click(".cm-content");
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

/** A solved lesson with its grade. */
async function lesson(page) {
  await typeRules(page, solved());
  await click(page, ".panel.mission button", "Grade");
  await page.waitForSelector(".panel.mission .passed", { timeout: PATIENCE_MS });
  await pauseAt(page, 3);
}

/** A fight, and why a soldier does what it does. */
async function why(page) {
  await click(page, ".agents button", "blue-1");
  await pauseAt(page, 6);
  await click(page, "[role=tab]", "Why");
  await click(page, ".panel.why button", "Why this?");
  await page.waitForSelector(".panel.why .tree li", { timeout: PATIENCE_MS });
}

const PICTURES_OF = [
  { name: "site_chromium", browser: "Chromium", size: WIDE, hash: "#lesson=01-a-rule", prepare: lesson },
  { name: "site_firefox", browser: "Firefox", size: WIDE, hash: "#world=soar_skirmish", prepare: why },
  { name: "site_phone_start", browser: "Chromium", size: PHONE, hash: "", prepare: (page) => until(page, () => document.querySelectorAll(".card .map, .card svg").length > 3) },
  { name: "site_phone_lesson", browser: "Chromium", size: PHONE, hash: "#lesson=02-operators", prepare: (page) => pauseAt(page, 3) },
  { name: "site_phone_world", browser: "Firefox", size: PHONE, hash: "#world=soar_flee", prepare: (page) => pauseAt(page, 3) },
];

for (const { name, browser, size: [width, height], hash, prepare } of PICTURES_OF) {
  test(name, async () => {
    const program = await launch(browser);
    try {
      const page = await program.newPage();
      await page.setViewport({ width, height });
      await page.goto(SITE + hash);
      await page.waitForSelector(hash === "" ? ".start h1" : ".labels .name", { timeout: PATIENCE_MS });
      await prepare(page);
      await page.mouse.move(1, 1);
      // The remarks of the run are gone, and nothing of the page is wider than the window.
      await until(page, () => document.querySelectorAll(".remark").length === 0);
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), "nothing is cut off at the side");
      await page.screenshot({ path: `${PICTURES}/${name}.png` });
    } finally {
      await program.close();
    }
  });
}
