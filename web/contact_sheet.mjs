// SPDX-License-Identifier: BSD-2-Clause
// Writes a sheet with pictures of worlds, lessons and panels in the page, to be inspected by eye: index.html in
// FOLDER, with a row for each and a picture for each size and scheme. The exit code is 1 if a page scrolls sideways or
// the browser reports an error.
//   node contact_sheet.mjs FOLDER [NAME...]      without names: all worlds, lessons and panels; a panel's name is its title
//   SOARBOX_PAGE      address of the server (default: http://127.0.0.1:8080)
//   SOARBOX_SIZES     widths in pixels (default: 390,768,1280,1920,1280x2); 1280x2 is 1280 px at a zoom of 200 percent
//   SOARBOX_SCHEMES   default: light,dark
//   SOARBOX_WORLD     world in which panels are shown (default: soar_skirmish)
//   SOARBOX_AT        simulated seconds at which this world is paused for the pictures of panels (default: 8)
import { mkdirSync, writeFileSync } from "node:fs";
import { ADDRESS, closeBrowser, openPage, PATIENCE_MS, show } from "./e2e/browser.mjs";

const [folder, ...names] = process.argv.slice(2);
if (folder === undefined) {
  console.error("usage: node contact_sheet.mjs FOLDER [NAME...]");
  process.exit(2);
}
const HEIGHTS = { 390: 844, 768: 1024, 1280: 800, 1920: 1080 }, SETTLES_MS = 1500;
const sizes = (process.env.SOARBOX_SIZES ?? "390,768,1280,1920,1280x2").split(",").map(sizeOf), schemes = (process.env.SOARBOX_SCHEMES ?? "light,dark").split(",");
const panelWorld = process.env.SOARBOX_WORLD ?? "soar_skirmish", pausedAt_s = Number(process.env.SOARBOX_AT ?? 8);
mkdirSync(folder, { recursive: true });

/** "1280x2": a browser with a width of 1280 px at a zoom of 200 percent. */
function sizeOf(text) {
  const [width, zoom = 1] = text.split("x").map(Number), height = HEIGHTS[width] ?? Math.round(width * 0.62);
  return { text, zoom, view: [Math.round(width / zoom), Math.round(height / zoom)] };
}

const { place } = await (await fetch(`${ADDRESS}/api/places`, { method: "POST" })).json();
const info = await (await fetch(`${ADDRESS}/api/p/${place}`)).json();
const all = [...info.lessons.map((one) => ["lesson", one.name]), ...info.scenarios.map((one) => ["world", one.name]), ...(await titlesOfPanels()).map((title) => ["panel", title])];
const wanted = names.length === 0 ? all : all.filter(([, name]) => names.includes(name));
const unknown = names.filter((name) => all.every(([, known]) => known !== name));
if (unknown.length > 0) {
  console.error(`there is no world, lesson or panel ${unknown.join(", ")}`);
  process.exit(2);
}

/** Returns the titles of the panels, from a page that is wide enough to show all of them. */
async function titlesOfPanels() {
  const { page, close } = await openPage(`/p/${place}/#world=${panelWorld}`, { size: [1280, 800], draws: false });
  await page.waitForSelector(".run-page:not([hidden]) [role=tab]");
  const titles = await page.locator(".run-page [role=tab]").evaluateAll((tabs) => tabs.map((tab) => tab.dataset.title ?? tab.firstChild.textContent));
  await close();
  return titles;
}

/** Pauses the world of the panels at the same moment for all pictures. The place keeps its run from one page to the next. */
async function pauseWorld(page) {
  await page.waitForSelector(".flow-bar button[aria-label=Pause]:enabled, .flow-bar button[aria-label=Run]:enabled");
  if (await page.locator(".flow-bar button[aria-label=Run]").count() > 0) return;
  await page.locator(".flow-bar button[aria-label='Begin again']").click();
  for (const isLater of [false, true]) {
    await page.waitForFunction(([wanted, later]) => {
      const [minutes, seconds] = (document.querySelector(".scrubber .moment")?.firstChild?.textContent ?? "").split(":").map(Number);
      return minutes * 60 + seconds >= wanted === later;
    }, [pausedAt_s, isLater]);
  }
  await page.locator(".flow-bar button[aria-label=Pause]").click();
  await page.waitForSelector(".flow-bar button[aria-label=Run]");
}

/** Takes a picture. Returns the file name, and the faults of the page. */
async function picture(kind, name, size, scheme) {
  const world = kind === "panel" ? `world=${panelWorld}` : `${kind}=${name}`;
  const { page, troubles, close } = await openPage(`/p/${place}/#${world}`, { size: size.view, zoom: size.zoom, scheme });
  const file = `${name}_${size.text}_${scheme}.png`.replaceAll(" ", "_"), faults = [];
  try {
    await page.waitForSelector(".run-page:not([hidden])");
    // Waits for the name of an agent, or for the empty panel of a world without agents.
    await page.waitForFunction(() => document.querySelector(".labels .name, .panel.agents") !== null);
    if (kind === "panel") {
      await pauseWorld(page);
      await show(page, name);
    }
    await page.waitForTimeout(SETTLES_MS);
    await page.screenshot({ path: `${folder}/${file}`, timeout: PATIENCE_MS });
    const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    if (wide > 0) faults.push(`${file}: the page is ${wide} px too wide`);
  } catch (error) {
    faults.push(`${file}: ${error.message}`);
  }
  await close();
  return { file, faults: [...faults, ...troubles.map((trouble) => `${file}: ${trouble}`)] };
}

const rows = [], faults = [];
for (const [kind, name] of wanted) {
  const cells = [];
  for (const size of sizes) {
    for (const scheme of schemes) {
      const made = await picture(kind, name, size, scheme);
      faults.push(...made.faults);
      cells.push(`<td><a href="${made.file}"><img src="${made.file}" alt="${name}, ${size.text} px, ${scheme}" width="${Math.min(320, size.view[0] / 3)}"></a></td>`);
    }
  }
  rows.push(`<tr><th>${name}</th>${cells.join("")}</tr>`);
  console.log(name);
}
const heads = sizes.flatMap((size) => schemes.map((scheme) => `<th>${size.text} ${scheme}</th>`)).join("");
writeFileSync(`${folder}/index.html`, `<!doctype html><meta charset="utf-8"><title>Worlds, lessons and panels</title><style>body{font:14px sans-serif}td,th{padding:4px;vertical-align:top}</style><table><tr><th></th>${heads}</tr>${rows.join("\n")}</table>\n`);
await closeBrowser();
for (const fault of faults) console.error(fault);
process.exit(faults.length > 0 ? 1 : 0);
