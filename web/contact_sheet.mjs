// SPDX-License-Identifier: BSD-2-Clause
// A sheet with pictures of worlds and lessons in the page, to be looked at: index.html in the folder named, with one row for each and one
// picture for each size and scheme. It ends with 1 if a page scrolls sideways or the browser complains.
//   node contact_sheet.mjs FOLDER [NAME...]      without names: all worlds and lessons of the server
//   SOARBOX_PAGE      the server's address, http://127.0.0.1:8080 if it is not said
//   SOARBOX_SIZES     390,768,1280,1920 if it is not said
//   SOARBOX_SCHEMES   light,dark if it is not said
import { mkdirSync, writeFileSync } from "node:fs";
import { ADDRESS, closeBrowser, openPage, PATIENCE_MS } from "./e2e/browser.mjs";

const [folder, ...names] = process.argv.slice(2);
if (folder === undefined) {
  console.error("usage: node contact_sheet.mjs FOLDER [NAME...]");
  process.exit(2);
}
const HEIGHTS = { 390: 844, 768: 1024, 1280: 800, 1920: 1080 }, SETTLES_MS = 1500;
const sizes = (process.env.SOARBOX_SIZES ?? "390,768,1280,1920").split(",").map(Number), schemes = (process.env.SOARBOX_SCHEMES ?? "light,dark").split(",");
mkdirSync(folder, { recursive: true });

const { place } = await (await fetch(`${ADDRESS}/api/places`, { method: "POST" })).json();
const info = await (await fetch(`${ADDRESS}/api/p/${place}`)).json();
const all = [...info.lessons.map((one) => ["lesson", one.name]), ...info.scenarios.map((one) => ["world", one.name])];
const wanted = names.length === 0 ? all : all.filter(([, name]) => names.includes(name));
const unknown = names.filter((name) => all.every(([, known]) => known !== name));
if (unknown.length > 0) {
  console.error(`there is no world or lesson ${unknown.join(", ")}`);
  process.exit(2);
}

const rows = [], faults = [];
for (const [kind, name] of wanted) {
  const cells = [];
  for (const size of sizes) {
    for (const scheme of schemes) {
      const { page, troubles, close } = await openPage(`/p/${place}/#${kind}=${name}`, { size: [size, HEIGHTS[size] ?? Math.round(size * 0.62)], scheme });
      const file = `${name}_${size}_${scheme}.png`;
      await page.waitForSelector(".run-page:not([hidden])");
      // The name of an agent, or a world without agents.
      await page.waitForFunction(() => document.querySelector(".labels .name, .panel.agents") !== null);
      await page.waitForTimeout(SETTLES_MS);
      await page.screenshot({ path: `${folder}/${file}`, timeout: PATIENCE_MS });
      const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
      if (wide > 0) faults.push(`${file}: the page is ${wide} px too wide`);
      for (const trouble of troubles) faults.push(`${file}: ${trouble}`);
      cells.push(`<td><a href="${file}"><img src="${file}" alt="${name}, ${size} px, ${scheme}" width="${Math.min(320, size / 3)}"></a></td>`);
      await close();
    }
  }
  rows.push(`<tr><th>${name}</th>${cells.join("")}</tr>`);
  console.log(name);
}
const heads = sizes.flatMap((size) => schemes.map((scheme) => `<th>${size} ${scheme}</th>`)).join("");
writeFileSync(`${folder}/index.html`, `<!doctype html><meta charset="utf-8"><title>Worlds and lessons</title><style>body{font:14px sans-serif}td,th{padding:4px;vertical-align:top}</style><table><tr><th></th>${heads}</tr>${rows.join("\n")}</table>\n`);
await closeBrowser();
for (const fault of faults) console.error(fault);
process.exit(faults.length > 0 ? 1 : 0);
