// SPDX-License-Identifier: BSD-2-Clause
// Tests that need separate servers: a killed and restarted server, a token, a class with a teacher, and names that
// contain markup.
import assert from "node:assert/strict";
import { mkdirSync, mkdtempSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import { closeBrowser, openLesson, openPage, picture, show, typeRules, until } from "./browser.mjs";
import { COMMAND, startServer } from "./own_server.mjs";

const skip = COMMAND === "" ? "SOARBOX_COMMAND names no program" : false;
const MARKUP = "<img src=x onerror=globalThis.hit=1>";
after(closeBrowser);

const visit = (address, more = {}) => openPage(address, { draws: false, passed: /WebSocket|ERR_CONNECTION|401/, ...more });

test("a server that was killed comes back, and with it the page and what was typed", { skip }, async () => {
  const first = await startServer([]), { page, troubles, close } = await visit(`${first.address}/`);
  await openLesson(page, 1);
  const link = page.url();
  await typeRules(page, "# This I typed.\n");
  await until(async () => /unsaved|•/.test(await page.locator(".panel.edit select option").allInnerTexts().then((all) => all.join(" "))), "the draft is known");
  const drafts = () => readdirSync(first.state, { recursive: true, withFileTypes: true }).filter((one) => one.isFile()).map((one) => readFileSync(join(one.parentPath ?? one.path, one.name), "utf8"));
  await until(() => drafts().some((text) => text.includes("This I typed")), "the draft is on the disk");
  await first.kill();
  await page.waitForSelector(".pill.lost");
  await picture(page, "lost");
  const second = await startServer([], { port: first.port, state: first.state });
  await page.locator(".pill.lost button").click({ timeout: 5000 }).catch(() => {});
  await until(async () => (await page.locator(".pill.lost").count()) === 0, "the page is connected again");
  assert.equal(page.url(), link);
  if ((await page.locator(".start:visible").count()) > 0) await page.locator("ol.cards button.card").first().click();
  else if ((await page.locator(".over-run").count()) > 0) await page.locator(".over-run button.primary").click();
  await until(async () => /This I typed/.test(await page.locator(".cm-content").innerText()), "what was typed is there again");
  assert.deepEqual(troubles, []);
  await close();
  await second.kill();
});

test("the printed address with its token opens the page and then drops the token; without a token there is a message", { skip }, async () => {
  const server = await startServer(["--token", "a-long-secret-0123456789"]), { page, troubles, close } = await visit(`${server.address}/#token=a-long-secret-0123456789`);
  await openLesson(page, 1);
  assert.doesNotMatch(page.url(), /token/);
  assert.deepEqual(troubles, []);
  await close();
  const stranger = await visit(`${server.address}/`);
  await stranger.page.waitForSelector("[role=alert] h1");
  await stranger.close();
  await server.kill();
});

test("a teacher sees the class, and watches without changing anything; names with markup are shown as text", { skip }, async () => {
  const folder = mkdtempSync(join(tmpdir(), "soarbox-"));
  writeFileSync(join(folder, "names.txt"), `Ada\n${MARKUP}\n`);
  const server = await startServer(["--class", join(folder, "names.txt")]);
  const table = /\S*\/class\/\S+/.exec(server.told)?.[0] ?? "", links = server.told.match(/\S*\/p\/\S+/g) ?? [];
  const here = (link) => (link.startsWith("http") ? link : `${server.address}${link}`);
  assert.ok(table !== "" && links.length === 2, server.told);
  const learner = await visit(here(links[0]));
  assert.match(await learner.page.locator(".start h1").innerText(), /Ada|img/);
  await openLesson(learner.page, 1);
  const teacher = await visit(here(table));
  await teacher.page.waitForSelector("table.class tbody tr");
  assert.match(await teacher.page.locator("table.class").innerText(), /<img src=x/);
  await until(async () => (await teacher.page.locator(".here.yes").count()) === 1, "somebody is here");
  await picture(teacher.page, "class");
  await teacher.page.locator("tr:has(.here.yes) a", { hasText: "Watch" }).click();
  await teacher.page.waitForSelector(".panel.mission > .title");
  assert.match(await teacher.page.locator(".head").innerText(), /You watch/);
  assert.equal(await teacher.page.locator(".panel.edit .bar button.primary").count(), 0);
  assert.equal(await teacher.page.locator(".flow-bar button:enabled").count(), 0);
  // Learner and teacher choose their panels independently.
  await show(learner.page, "Why");
  await show(teacher.page, "Rules");
  await teacher.page.waitForSelector(".panel.rules td button.row-press");
  await show(teacher.page, "Senses");
  await teacher.page.waitForSelector(".panel.links .attribute:visible");
  assert.equal(await learner.page.locator("#tab-why[aria-selected=true]").count(), 1);
  await learner.page.locator(".panel.mission button", { hasText: "Hint 1 of" }).click();
  const hint = (await learner.page.locator(".panel.mission [data-part=hints] p").first().innerText()).replace(/^1\. /, "");
  await teacher.page.goto(here(table));
  await until(async () => (await teacher.page.locator("table.class").textContent()).includes(hint), "the last hint is in the table");
  for (const one of [learner, teacher]) {
    assert.equal(await one.page.evaluate(() => globalThis.hit), undefined);
    assert.deepEqual(one.troubles, []);
    await one.close();
  }
  await server.kill();
});

test("names of an agent and a world, and messages, with markup are shown as text everywhere", { skip }, async () => {
  const lessons = new URL("../../lessons/01-a-rule/", import.meta.url), folder = join(mkdtempSync(join(tmpdir(), "soarbox-")), "odd");
  mkdirSync(folder);
  for (const name of ["porter.soar", "visitor.soar"]) writeFileSync(join(folder, name), readFileSync(new URL(name, lessons)));
  writeFileSync(join(folder, "scenario.toml"), readFileSync(new URL("scenario.toml", lessons), "utf8").replace('name = "anna"', `name = "${MARKUP}"`).replace(/description = ".*"/, `description = "${MARKUP}"`));
  const server = await startServer([folder]), { page, troubles, close } = await visit(`${server.address}/`, { draws: true });
  await page.waitForSelector(".run-page:not([hidden])");
  await page.waitForSelector(".agents tbody tr");
  assert.match(await page.locator(".panel.agents").innerText(), /<img src=x/);
  await page.locator(".agents button", { hasText: "<img" }).click();
  for (const title of ["Mind", "Why", "Memory", "Rules", "Senses", "Timeline", "Trace", "Messages", "Console", "Watch", "Minds"]) await show(page, title);
  await until(async () => (await page.locator(".labels .name").allInnerTexts()).some((text) => text.includes("<img")), "its label is text");
  assert.equal(await page.locator("img").count(), 0);
  assert.equal(await page.evaluate(() => globalThis.hit), undefined);
  await page.locator("button.home").click();
  await page.waitForSelector(".start h1");
  assert.equal(await page.locator("img").count(), 0);
  assert.deepEqual(troubles, []);
  await close();
  await server.kill();
});
