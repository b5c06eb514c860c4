// SPDX-License-Identifier: BSD-2-Clause
// Tests the site without a server in a browser: worlds run, changed rules are applied, a link shows another user the same
// moment of the same experiment, and the site works without a network. run_site.py starts these tests. SOARBOX_PAGE is the
// address of the site.
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { after, test } from "node:test";
import { apply, closeBrowser, openLesson, openPage, openWorld, picture, show, typeRules, until } from "../../web/e2e/browser.mjs";

after(closeBrowser);

const SITE = process.env.SOARBOX_PAGE ?? "http://127.0.0.1:8000/";
const textOf = (path) => readFileSync(new URL(`../../${path}`, import.meta.url), "utf8");
const inEditor = async (page) => (await page.locator(".cm-content").innerText()).replaceAll(/\s/g, "");

test("a world runs, its minds say why, its past is shown, and new rules take effect", async () => {
  const { page, troubles, close } = await openPage(SITE, { draws: false });
  await openWorld(page, "soar_flee");
  await until(async () => !/^0:00\b/.test(await page.locator(".scrubber .moment").innerText()), "the world runs");
  await page.locator(".agents button", { hasText: "rabbit" }).click();
  await page.waitForSelector(".agents tr.chosen:has-text('rabbit')");
  await show(page, "Why");
  await page.locator(".panel.why button", { hasText: "Why this?" }).click();
  await page.waitForSelector(".panel.why .tree li");
  await picture(page, "site_world");
  await page.locator(".past").focus();
  await page.keyboard.press("Home");
  await page.waitForSelector("button:has-text('Resume here'):enabled");
  await page.locator("button", { hasText: "To the newest" }).click();

  // Adds a rule for the rabbit.
  await page.locator("#tab-edit").click();
  await page.locator(".panel.edit select").selectOption({ label: "rabbit.soar" });
  await until(async () => (await inEditor(page)).includes("rabbit*propose*rest"), "the rabbit's rules are in the editor");
  await typeRules(page, `${textOf("scenarios/soar_flee/rabbit.soar")}\nsp {rabbit*note*here\n   (state <s> ^superstate nil)\n-->\n   (<s> ^here yes)\n}\n`);
  await apply(page);
  await until(async () => /Reloaded/.test(await page.locator(".panel.edit .under").innerText()), "the rules are reloaded");
  await picture(page, "site_edit");
  assert.deepEqual(troubles, []);
  await close();
});

test("a lesson is solved and graded, and its progress is there the next time", async () => {
  const { page, troubles, close } = await openPage(SITE, { draws: false });
  await openLesson(page, 1);
  await page.locator(".panel.mission button", { hasText: /^Grade$/ }).click();
  await page.waitForSelector(".panel.mission [data-part=grade] p");
  await page.waitForSelector(".panel.mission button:has-text('Grade'):enabled");
  assert.equal(await page.locator(".panel.mission > p > .good").count(), 0, "nothing is solved yet");
  await typeRules(page, textOf("lessons/01-a-rule/solution/porter.soar"));
  await apply(page);
  await until(async () => /Reloaded/.test(await page.locator(".panel.edit .under").innerText()), "the rules are reloaded");
  await page.locator(".panel.mission button", { hasText: /^Grade$/ }).click();
  await page.waitForSelector(".panel.mission > p > .good");
  await picture(page, "site_lesson");
  await page.waitForTimeout(2500);  // Changed files are stored after a second.
  await page.reload();
  await until(async () => /porter\*greet/.test(await page.locator(".cm-content").innerText()), "the rules are there again");
  assert.deepEqual(troubles, []);
  await close();
});

/** The rows of the panel Agents: states, operators and commands. */
const agentsOf = async (page) => (await page.locator(".panel.agents tbody tr").allInnerTexts()).map((row) => row.replaceAll(/\s+/g, " ").trim());
const isPaused = async (page) => (await page.locator("button[aria-label='Run']").count()) === 1;
const momentOf = (page) => page.locator(".scrubber .moment").evaluate((moment) => moment.firstChild.textContent);

/** The link to the experiment, from the dialog for links. */
async function experimentLink(page) {
  await page.locator("button[aria-label='Links to share']").click();
  const link = await page.locator(".dialog input.address[aria-label='This experiment']").inputValue();
  await picture(page, "site_link");
  await page.keyboard.press("Escape");
  return link;
}

test("a link is an experiment: it shows the same moment of the same rules, paused, and says why", async () => {
  const rules = `${textOf("scenarios/soar_flee/rabbit.soar")}\nsp {rabbit*note*here\n   (state <s> ^superstate nil)\n-->\n   (<s> ^here yes)\n}\n`;
  // Wide enough for all buttons.
  const { page, troubles, close } = await openPage(SITE, { draws: false, size: [1600, 900] });
  await openWorld(page, "soar_flee");
  await page.locator(".agents button", { hasText: "rabbit" }).click();
  await page.waitForSelector(".agents tr.chosen:has-text('rabbit')");
  await page.locator("#tab-edit").click();
  await page.locator(".panel.edit select").selectOption({ label: "rabbit.soar" });
  await until(async () => (await inEditor(page)).includes("rabbit*propose*rest"), "the rabbit's rules are in the editor");
  await typeRules(page, rules);
  await apply(page);
  await until(async () => /Reloaded/.test(await page.locator(".panel.edit .under").innerText()), "the rules are reloaded");
  // Begins with the next seed, so that the link must contain the seed.
  await page.locator("button[aria-label='Begin again with the next seed']").click();
  await page.waitForSelector(".seed:has-text('seed 2')");
  await until(async () => (await momentOf(page)) >= "0:03", "the world runs");
  await page.locator("button[aria-label='Pause']").click();
  await until(() => isPaused(page), "it stands");
  const link = await experimentLink(page), moment = await momentOf(page), agents = await agentsOf(page);
  assert.match(link, /#world=soar_flee&t=[\d.]+&seed=2&agent=rabbit&rules=[\w-]+$/);
  assert.ok(link.length < 4000, `the link has ${link.length} letters`);

  // Another user, in a browser without any data of this site.
  const other = await openPage(link, { draws: false });
  await other.page.waitForSelector(".pill:has-text('An experiment from a link')");
  await until(async () => (await momentOf(other.page)) === moment && (await isPaused(other.page)), "the moment is shown, paused");
  await other.page.waitForSelector(".panel.why .tree li");
  await other.page.waitForSelector(".seed:has-text('seed 2')");
  await until(async () => (await agentsOf(other.page)).join("\n") === agents.join("\n"), "the agents do what they did");
  await picture(other.page, "site_experiment");
  await other.page.locator("#tab-edit").click();
  await until(async () => (await inEditor(other.page)).includes("rabbit*note*here"), "the rules of the link are in the editor");
  // A reload shows the experiment again. A world that is opened from the start page has the user's own files.
  await other.page.reload();
  await until(async () => (await momentOf(other.page)) === moment, "the moment is shown again");
  await other.page.locator("button.home").click();
  await openWorld(other.page, "soar_flee");
  await other.page.locator(".agents button", { hasText: "rabbit" }).click();
  await other.page.locator("#tab-edit").click();
  await until(async () => (await inEditor(other.page)).includes("rabbit*propose*rest"), "the rabbit's rules are in the editor");
  assert.equal((await inEditor(other.page)).includes("rabbit*note*here"), false, "the link has changed nothing of one's own");
  assert.equal(await other.page.locator(".pill:has-text('An experiment from a link')").count(), 0);
  // A truncated link.
  await other.page.goto(link.slice(0, -40));
  await other.page.waitForSelector("[role=alert]:has-text('damaged')");
  await other.page.locator("button", { hasText: "Lessons and worlds" }).click();
  await other.page.waitForSelector(".start h1");
  assert.deepEqual([...troubles, ...other.troubles], []);
  await other.close();
  await close();
});

test("the link of a lesson has the rules of its editor in it", async () => {
  const { page, troubles, close } = await openPage(SITE, { draws: false });
  await openLesson(page, 1);
  await typeRules(page, textOf("lessons/01-a-rule/solution/porter.soar"));
  const link = await experimentLink(page), other = await openPage(link, { draws: false });
  await until(async () => /porter\*greet/.test(await other.page.locator(".cm-content").innerText()), "the rules are in the other editor");
  await other.page.locator(".panel.mission button", { hasText: /^Grade$/ }).click();
  await other.page.waitForSelector(".panel.mission > p > .good");
  assert.deepEqual([...troubles, ...other.troubles], []);
  await other.close();
  await close();
});

test("after the first visit the site works without a network", { skip: SITE.startsWith("file:") && "one file needs none" }, async () => {
  const { page, troubles, close } = await openPage(SITE, { draws: false });
  await page.waitForSelector(".start h1");
  await page.evaluate(async () => void (await navigator.serviceWorker.ready));
  await page.context().setOffline(true);
  await page.reload();
  await openWorld(page, "soar_flee");
  await until(async () => !/^0:00\b/.test(await page.locator(".scrubber .moment").innerText()), "the world runs");
  assert.deepEqual(troubles, []);
  await close();
});

// A browser without a screen has no dialog for folders, so a folder of the origin's private file system takes the place of what a user
// would choose. Its handles are the same class. They need no permission, so `folderPermission` replaces the browser's answer.
const FOLDER_PICKER = () => {
  window.showDirectoryPicker = async () => (await navigator.storage.getDirectory()).getDirectoryHandle("My burrow", { create: true });
  const answer = () => localStorage.getItem("folderPermission") ?? "granted";
  FileSystemHandle.prototype.queryPermission = async () => (answer() === "granted" ? "granted" : "prompt");
  FileSystemHandle.prototype.requestPermission = async () => {
    if (answer() === "prompt") localStorage.setItem("folderPermission", "granted");
    return answer();
  };
};

/** Writes a file of that folder as another program would; returns the texts of all its files. */
async function inFolder(page, path = "", text = "") {
  return page.evaluate(async ({ name, contents }) => {
    const root = await (await navigator.storage.getDirectory()).getDirectoryHandle("My burrow", { create: true }), texts = {};
    if (name !== "") {
      const out = await (await root.getFileHandle(name, { create: true })).createWritable();
      await out.write(contents);
      await out.close();
    }
    for await (const one of root.values()) if (one.kind === "file") texts[one.name] = await (await one.getFile()).text();
    return texts;
  }, { name: path, contents: text });
}
const remark = (page, text) => page.waitForSelector(`.remark:has-text('${text}')`);
const NOTE = (name) => `\nsp {rabbit*note*${name}\n   (state <s> ^superstate nil)\n-->\n   (<s> ^${name} yes)\n}\n`;

test("a folder of the disk: its world runs, saved edits are written to it, and another program's changes run", { skip: SITE.startsWith("file:") && "the page of a file has no private file system" }, async () => {
  const rules = textOf("scenarios/soar_flee/rabbit.soar");
  const { page, troubles, close } = await openPage(SITE, { draws: false, size: [1600, 900], script: FOLDER_PICKER });
  const open = page.locator("button", { hasText: "Open a folder of your disk" });
  // A folder without a world is refused.
  await inFolder(page, "notes.txt", "Nothing\n");
  await open.click();
  await remark(page, "My burrow is not the folder of a world");
  for (const name of readdirSync(new URL("../../scenarios/soar_flee", import.meta.url))) await inFolder(page, name, textOf(`scenarios/soar_flee/${name}`));
  await open.click();
  await page.waitForSelector(".pill.folder:has-text('Folder My burrow')");
  await until(async () => !/^0:00\b/.test(await page.locator(".scrubber .moment").innerText()), "the world runs");
  await page.locator(".agents button", { hasText: "rabbit" }).click();
  await page.locator("#tab-edit").click();
  await page.locator(".panel.edit select").selectOption({ label: "rabbit.soar" });
  await until(async () => (await inEditor(page)).includes("rabbit*propose*rest"), "the rabbit's rules are in the editor");
  await typeRules(page, rules + NOTE("here"));
  await apply(page);
  await until(async () => (await inFolder(page))["rabbit.soar"] === rules + NOTE("here"), "the edit is in the folder");
  await picture(page, "site_folder");

  // Another program changes the file.
  await inFolder(page, "rabbit.soar", rules + NOTE("there"));
  await remark(page, "Another program has changed rabbit.soar");
  await until(async () => (await inEditor(page)).includes("rabbit*note*there"), "the editor has the other program's text");
  await show(page, "Rules");
  await page.waitForSelector(".panel.rules :has-text('rabbit*note*there')");
  await page.locator("#tab-edit").click();

  // Both change it before the page looks: both texts are kept.
  await page.evaluate(() => Object.defineProperty(document, "visibilityState", { configurable: true, value: "hidden" }));
  await page.waitForTimeout(2500);
  await inFolder(page, "rabbit.soar", rules + NOTE("elsewhere"));
  await typeRules(page, rules + NOTE("mine"));
  await apply(page);
  await remark(page, "rabbit.soar was changed here and by another program");
  const both = await inFolder(page);
  assert.equal(both["rabbit.soar"], rules + NOTE("elsewhere"));
  assert.equal(both["rabbit.soar.mine"], rules + NOTE("mine"));

  // After a reload the browser has to be asked again, and may refuse.
  await page.evaluate(() => localStorage.setItem("folderPermission", "denied"));
  await page.reload();
  await page.waitForSelector(".pill.folder:has-text('Folder not connected')");
  await page.locator("button[aria-label='Connect the folder My burrow']").click();
  await remark(page, "The browser does not let this page read and change My burrow");
  await page.evaluate(() => localStorage.setItem("folderPermission", "prompt"));
  await inFolder(page, "rabbit.soar", rules + NOTE("meanwhile"));
  await page.locator("button[aria-label='Connect the folder My burrow']").click();
  await page.waitForSelector(".pill.folder:has-text('Folder My burrow'):not(:has-text('not'))");
  await page.locator("#tab-edit").click();
  await until(async () => (await inEditor(page)).includes("rabbit*note*meanwhile"), "what was changed meanwhile is in the editor");

  // The folder is removed.
  await page.evaluate(async () => (await navigator.storage.getDirectory()).removeEntry("My burrow", { recursive: true }));
  await remark(page, "My burrow is no longer where it was");
  await page.waitForSelector(".pill.folder.lost");
  await page.locator("button.home").click();
  await page.waitForSelector(".folders li");
  await picture(page, "site_folders");
  await page.locator("button", { hasText: "Forget" }).click();
  await until(async () => (await page.locator(".folders li").count()) === 0, "the folder is forgotten");
  assert.deepEqual(troubles, []);
  await close();
});

test("a folder of the disk: a second tab leaves it alone, and a crash does not bring an old text back", { skip: SITE.startsWith("file:") && "the page of a file has no private file system" }, async () => {
  const rules = textOf("scenarios/soar_flee/rabbit.soar"), { page, troubles, close } = await openPage(SITE, { draws: false, size: [1600, 900], script: FOLDER_PICKER });
  const another = async () => {
    const next = await page.context().newPage();
    await next.addInitScript(FOLDER_PICKER);
    await next.goto(SITE);
    return next;
  };
  for (const name of readdirSync(new URL("../../scenarios/soar_flee", import.meta.url))) await inFolder(page, name, textOf(`scenarios/soar_flee/${name}`));
  await page.locator("button", { hasText: "Open a folder of your disk" }).click();
  await page.waitForSelector(".pill.folder:has-text('Folder My burrow')");
  await page.locator(".agents button", { hasText: "rabbit" }).click();
  await page.locator("#tab-edit").click();
  await page.locator(".panel.edit select").selectOption({ label: "rabbit.soar" });
  await until(async () => (await inEditor(page)).includes("rabbit*propose*rest"), "the rabbit's rules are in the editor");
  const second = await another();
  await remark(second, "Another tab shows your files already");
  await second.locator(".folders li button.link").click();
  await second.waitForSelector(".pill.folder.lost");
  await second.waitForSelector(".agents button:has-text('rabbit')");
  await second.close();

  // The renderer crashes a moment after the folder has the text.
  await typeRules(page, rules + NOTE("newest"));
  await apply(page);
  await page.evaluate(async (text) => {
    const file = await (await (await navigator.storage.getDirectory()).getDirectoryHandle("My burrow")).getFileHandle("rabbit.soar");
    // While the file is replaced, it cannot be read.
    const read = async () => (await file.getFile()).text();
    while ((await read().catch(() => "")) !== text) await new Promise((done) => setTimeout(done, 5));
  }, rules + NOTE("newest"));
  await page.waitForTimeout(250);
  const crashed = page.waitForEvent("crash");
  void page.goto("chrome://crash").catch(() => undefined);
  await crashed;
  const after = await another();
  await after.locator(".folders li button.link").click();
  await after.waitForSelector(".pill.folder:has-text('Folder My burrow'):not(:has-text('not'))");
  await until(async () => !/^0:00\b/.test(await after.locator(".scrubber .moment").innerText()), "the world runs");
  assert.equal((await inFolder(after))["rabbit.soar"], rules + NOTE("newest"));
  assert.equal((await inFolder(after))["rabbit.soar.mine"], undefined);
  assert.deepEqual(troubles, []);
  await close();
});

test("without File System Access there is no button for folders", async () => {
  const { page, close } = await openPage(SITE, { draws: false, script: () => delete window.showDirectoryPicker });
  await page.waitForSelector(".start h1");
  assert.equal(await page.locator("button", { hasText: "Open a folder of your disk" }).count(), 0);
  await page.waitForSelector("label:has-text('Upload a folder (zip)')");
  await close();
});
