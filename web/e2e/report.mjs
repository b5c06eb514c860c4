// SPDX-License-Identifier: BSD-2-Clause
// Reports that are opened as files: without a server and a network.
//   SOARBOX_REPORTS  the folder with the output of tests/serve/report_samples.py
import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { readFileSync } from "node:fs";
import { after, test as tested } from "node:test";
import { closeBrowser, openBrowser, PATIENCE_MS, picture, until } from "./browser.mjs";

const FOLDER = process.env.SOARBOX_REPORTS, EVIL = `x</script><script>window.hurt=1</script>" onload='window.hurt=1' ]]>`;
const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const test = (name, run) => tested(name, { skip: FOLDER === undefined && "SOARBOX_REPORTS names no folder" }, run);
after(closeBrowser);

/**
 * Opens a report and runs the test. Then checks that there were no errors and requests, and that no text was run as a
 * script.
 */
async function look(name, run, { size = [1280, 900], scheme = "light", draws = false, ...more } = {}) {
  const context = await (await openBrowser({ draws })).newContext({ viewport: { width: size[0], height: size[1] }, colorScheme: scheme, ...more }), page = await context.newPage();
  page.setDefaultTimeout(PATIENCE_MS);
  const troubles = [], asked = [];
  page.on("console", (message) => message.type() === "error" && !(/WebGL/.test(message.text()) && !draws) && troubles.push(message.text()));
  page.on("pageerror", (error) => troubles.push(String(error.stack ?? error)));
  page.on("request", (request) => asked.push(request.url()));
  await page.goto(`file://${FOLDER}/${name}.html`);
  await run(page);
  assert.deepEqual(troubles, []);
  assert.deepEqual(asked.filter((url) => /^(https?|wss?):/.test(url)), [], "nothing is asked for");
  if (more.javaScriptEnabled !== false) assert.equal(await page.evaluate(() => globalThis.hurt), undefined, "texts stay texts");
  await context.close();
}

const heads = (page) => page.locator("main .part > h2").evaluateAll((all) => all.filter((one) => one.offsetParent !== null).map((one) => one.textContent));
const dots = (page) => page.locator("#ways g.dot").evaluateAll((all) => all.map((one) => one.getAttribute("transform")).join());
const shown = async (page) => Number.parseFloat(await page.locator(".bar output").textContent());

/** Waits until a part has this text. The browser reports an opened fold in a separate task, and its content is created only then. */
const says = (page, part, text, what) => until(async () => (await page.locator(part).innerText()).includes(text), what);

/** The barriers for users that axe finds, as "rule: element". */
async function bars(page) {
  await page.evaluate(axe);
  const found = await page.evaluate(() => globalThis.axe.run(document, { resultTypes: ["violations"], runOnly: ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa"] }));
  return found.violations.flatMap((one) => one.nodes.map((node) => `${one.id}: ${node.target.join(" ")}`));
}

test("a report shows its run in 3D at every moment, and all parts below follow", () => look("fight", async (page) => {
  await page.locator(".scene").getByText("blue-leader").first().waitFor();
  const pixels = () => page.locator(".scene canvas").first().screenshot();
  const before = await pixels(), dotsBefore = await dots(page);
  await page.locator("input.past").fill("200");
  await until(async () => !before.equals(await pixels()), "the picture is another one at another moment");
  await until(async () => (await dots(page)) !== dotsBefore, "the map shows the same moment");
  assert.ok(Math.abs((await shown(page)) - 200 / 30) < 0.1);
  await page.getByRole("tab", { name: "Messages" }).click();
  await page.locator(".scene").getByText("advance").first().waitFor();
  await picture(page, "report_run");
  // Takes the picture for docs/images/report.png: the run, and the part directly below it.
  await page.setViewportSize({ width: 1280, height: 700 });
  for (const name of ["Timeline", "Why"]) await page.getByRole("tab", { name }).click();
  await until(async () => (await page.locator(".scene").boundingBox()).height < 640, "it is as high as the window");
  if (process.env.SOARBOX_PICTURES !== undefined) await page.screenshot({ path: `${process.env.SOARBOX_PICTURES}/report_docs.png`, fullPage: true, clip: { x: 0, y: 0, width: 1280, height: 1180 } });
  await page.setViewportSize({ width: 1280, height: 900 });
  assert.equal(await page.locator("#messages").isVisible(), false, "the panel has them");
  await page.locator("#moments button.link").last().click();
  const there = await shown(page);
  await until(async () => Math.abs(Number(await page.locator("input.past").inputValue()) / 30 - there) < 0.2, "a key moment moves the run");
  await page.locator("input.past").fill("200");
  await page.getByRole("button", { name: "Run" }).first().click();
  await until(async () => Number(await page.locator("input.past").inputValue()) > 220, "time goes on");
  await page.locator("#timeline").scrollIntoViewIfNeeded();
  await page.locator("#play").waitFor();
  assert.match(await page.locator("#play").innerText(), /Pause/, "where the run is out of sight, the bar below plays it");
  await page.locator("#play").click();
  await page.locator(".flow-bar button[aria-label=Run]").waitFor();
}, { draws: true }));

test("names and texts that are markup stay texts, in every part", () => look("markup", async (page) => {
  await page.locator("#checks").waitFor();
  assert.deepEqual(await heads(page), ["Checks", "Key moments", "Map", "Timeline", "Numbers", "Rules", "Files", "About"]);
  assert.ok((await page.locator("#checks").innerText()).includes(`${EVIL} \ufffd`), "a name, whose mark turns nothing behind it");
  assert.equal(await page.locator("h1").count(), 1);
  assert.match(await page.locator(".report-head").innerText(), /soarbox replay/);
  assert.match(await page.locator("#rules").innerText(), /scout\*apply\*go/);
  await page.locator("summary", { hasText: "Events as table" }).click();
  await says(page, "#timeline", '<img src=x onerror="window.hurt=1">', "what is printed");
  await page.locator("summary", { hasText: "scout.soar" }).click();
  await says(page, "#files", '<img src=x onerror="window.hurt=1">', "a file");
  await page.getByRole("tab", { name: "Trace" }).click();
  assert.equal(await page.locator("img").count(), 0);
}));

test("runs of a folder are chosen by name, each with all sections", () => look("several", async (page) => {
  await page.locator("#messages").waitFor();
  assert.deepEqual(await heads(page), ["Checks", "Key moments", "Map", "Timeline", "Numbers", "Messages", "Rules", "Files", "About"]);
  assert.ok((await page.locator("#messages").innerText()).includes('<img src=x onerror="window.hurt=1">'));
  const before = await dots(page), title = await page.locator("h1").innerText();
  await page.locator("#slider").fill("4");
  assert.notEqual(await dots(page), before, "the slider moves the map");
  await page.locator("#checks li button").nth(1).click();
  assert.equal(await shown(page), 5, "the moment at which the second check failed");
  await page.locator("#spans").click({ position: { x: 400, y: 10 } });
  assert.notEqual(await shown(page), 5, "a click on the timeline moves it, too");
  await page.locator("#play").click();
  const from = await shown(page);
  await until(async () => (await shown(page)) > from, "time goes by");
  await page.locator("#run").selectOption({ index: 1 });
  assert.notEqual(await page.locator("h1").innerText(), title);
  assert.equal(await shown(page), 0);
  assert.match(await page.locator("#play").innerText(), /Play/);
}));

test("everything can be done with the keyboard", () => look("several", async (page) => {
  await page.locator("#slider").focus();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowRight");
  assert.equal(await shown(page), 0.2);
  assert.equal(await page.locator("#slider").getAttribute("aria-valuetext"), "0.2 s of 8.0 s");
  const head = page.locator("#rules th").nth(2), fired = async () => (await page.locator("#rules td:nth-child(3)").allInnerTexts()).map(Number), up = (a, b) => a - b;
  await head.locator("button").focus();
  await page.keyboard.press("Enter");
  assert.deepEqual(await fired(), (await fired()).sort(up));
  assert.equal(await head.getAttribute("aria-sort"), "ascending");
  await page.keyboard.press("Enter");
  assert.deepEqual(await fired(), (await fired()).sort(up).reverse());
  assert.equal(await head.getAttribute("aria-sort"), "descending");
  await page.locator("#messages th button").first().press("Enter");
  const times = (await page.locator("#messages td:first-child").allInnerTexts()).map(Number.parseFloat);
  assert.deepEqual(times, [...times].sort(up), "times sort as numbers");
  await page.evaluate(() => document.activeElement.blur());
  const seen = new Set();
  for (let i = 0; i < 40; i += 1) {
    await page.keyboard.press("Tab");
    seen.add(await page.evaluate(() => document.activeElement.closest("section, .bar, header")?.id || document.activeElement.closest("section, .bar, header")?.className));
  }
  for (const part of ["report-head", "checks", "timeline", "numbers", "rules"]) assert.ok(seen.has(part), `${part} is reached: ${[...seen]}`);
  assert.ok(await page.evaluate(() => {
    getSelection().selectAllChildren(document.querySelector("#ways"));
    return getSelection().toString().includes("gate");
  }), "what stands in a picture can be copied");
}));

test("a phone shows reports without scrolling sideways, with buttons for fingers", async () => {
  for (const name of ["several", "sweep", "cup", "fight"]) {
    await look(name, async (page) => {
      await page.locator("main h2").first().waitFor();
      assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 390, name);
      const small = await page.locator(".report-head button, .bar button, .checks button, .moments button").evaluateAll((all) => all.filter((one) => one.offsetParent !== null && one.getBoundingClientRect().height < 43.9).map((one) => one.textContent));
      assert.deepEqual(small, []);
      assert.ok((await page.locator(".chart text").first().evaluate((one) => one.getBoundingClientRect().height)) > 11, "what stands in pictures can be read");
      await picture(page, `report_${name}_390`);
    }, { size: [390, 844], hasTouch: true, isMobile: true, draws: name === "fight" });
  }
});

test("there are no accessibility errors, in light and dark", async () => {
  const grounds = new Set();
  for (const scheme of ["light", "dark"]) {
    for (const name of ["several", "sweep", "cup", "markup"]) {
      await look(name, async (page) => {
        await page.locator("main h2").first().waitFor();
        assert.deepEqual(await bars(page), [], `${name}, ${scheme}`);
        const ground = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor), first = await ground();
        grounds.add(first);
        await picture(page, `report_${name}_${scheme}`);
        await page.locator("#theme").click();
        assert.notEqual(await ground(), first, "the other one by a button");
      }, { scheme });
    }
  }
  assert.equal(grounds.size, 2);
});

test("a sweep shows variants, distributions, differences, and every run", () => look("sweep", async (page) => {
  const told = await heads(page);
  for (const head of ["Variants", "Checks", "Distributions", "Differences from slow, on equal seeds", "All runs", "About"]) assert.ok(told.includes(head), `${head}: ${told}`);
  assert.equal(await page.locator("#rows tbody tr").count(), 12);
  assert.ok((await page.locator("#distributions svg").count()) > 1);
  assert.ok((await page.locator("#distributions svg").first().locator("circle").count()) >= 12, "each run and two means");
  assert.ok((await page.locator("#variants").innerText()).includes("<img src=x"), "a variant's name stays text");
  assert.equal(await page.locator(".bar").isVisible(), false, "a sweep has no moments");
  assert.ok(readFileSync(`${FOLDER}/sweep.html`).length < 200_000, "it holds nothing that draws in 3D");
  await page.locator("#rows th button").nth(1).click();
  assert.deepEqual((await page.locator("#rows td:nth-child(2)").allInnerTexts()).map(Number), [1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6, 6]);
}));

test("a tournament begins with its standings", () => look("cup", async (page) => {
  assert.equal((await heads(page))[0], "Standings");
  assert.equal(await page.locator("#standings tbody tr").count(), 3);
  assert.match(await page.locator("#standings tbody tr").first().innerText(), /^east/);
  assert.equal(await page.locator("#standings svg[role=img] circle").count(), 3);
  assert.ok((await page.locator("#standings").innerText()).includes("<img src=x"));
}));

test("the printed page is light, and nothing is cut off", async () => {
  for (const [name, draws] of [["fight", true], ["sweep", false]]) {
    await look(name, async (page) => {
      await page.locator("main h2").first().waitFor();
      await page.emulateMedia({ media: "print", colorScheme: "dark" });
      await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
      assert.equal(await page.evaluate(() => getComputedStyle(document.documentElement).colorScheme), "light");
      for (const gone of [".scene", ".bar"]) assert.equal(await page.locator(gone).isVisible(), false, gone);
      assert.deepEqual(await page.locator(".scroll").evaluateAll((all) => all.filter((one) => one.scrollHeight > one.clientHeight + 1).length), 0);
      if (name === "fight") assert.ok((await page.locator("#messages tbody tr").count()) > 5, "paper has no panels");
      assert.equal(await page.locator("details.why:not([open])").count(), 0, "reasons are open");
      assert.ok((await page.pdf({ path: process.env.SOARBOX_PICTURES === undefined ? undefined : `${process.env.SOARBOX_PICTURES}/report_${name}.pdf`, format: "A4" })).length > 10_000);
    }, { draws });
  }
});

test("a frame without storage shows a report, as in a notebook", async () => {
  const page = await (await openBrowser()).newPage(), troubles = [];
  page.on("pageerror", (error) => troubles.push(String(error)));
  await page.setContent('<iframe sandbox="allow-scripts" style="width: 1200px; height: 700px"></iframe>');
  await page.locator("iframe").evaluate((frame, text) => (frame.srcdoc = text), readFileSync(`${FOLDER}/fight.html`, "utf8"));
  const frame = page.frameLocator("iframe");
  await frame.locator(".labels .name").first().waitFor({ timeout: PATIENCE_MS });
  await frame.locator("#theme").click();
  assert.equal(await frame.locator("main .part > h2").first().innerText(), "Checks");
  assert.deepEqual(troubles, []);
  await page.close();
});

test("without scripts a report shows the most important results", () => look("markup", async (page) => {
  const told = await page.locator("body").innerText();
  assert.match(told, /to the gate/);
  assert.match(told, /failed: 1 of 2 checks/);
  assert.ok(told.includes(EVIL));
}, { javaScriptEnabled: false }));
