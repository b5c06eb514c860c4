// SPDX-License-Identifier: BSD-2-Clause
// A class in the browser: the table at 1280 px, a raised hand, a message about a line, unsaved text, the arena, and a link to watch.
import assert from "node:assert/strict";
import { mkdtempSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import { closeBrowser, openLesson, openPage, openWorld, picture, typeRules, until } from "./browser.mjs";
import { COMMAND, startServer } from "./own_server.mjs";

const skip = COMMAND === "" ? "SOARBOX_COMMAND names no program" : false;
after(closeBrowser);

async function begin(names) {
  const folder = mkdtempSync(join(tmpdir(), "soarbox-"));
  writeFileSync(join(folder, "names.txt"), names.map((name) => `${name}\n`).join(""));
  const server = await startServer(["--class", join(folder, "names.txt")]), here = (link) => (link.startsWith("http") ? link : `${server.address}${link}`);
  return { server, table: here(/\S*\/class\/\S+/.exec(server.told)[0]), links: server.told.match(/\S*\/p\/\S+/g).map(here) };
}
const visit = (address, more = {}) => openPage(address, { draws: false, passed: /WebSocket|ERR_CONNECTION/, ...more });

test("the table fits 1280 px, a course unfolds into lessons with names, and a learner gets help", { skip }, async () => {
  const { server, table, links } = await begin(["Ada", "Bob", "Cy"]), learner = await visit(links[0]), teacher = await visit(table);
  await openLesson(learner.page, 1);
  await teacher.page.waitForSelector("table.class tbody tr");
  const fits = () => teacher.page.evaluate(() => {
    const main = document.querySelector(".class-page main");
    return main.scrollWidth <= main.clientWidth && document.documentElement.scrollWidth <= innerWidth;
  });
  assert.ok(await fits(), "all columns are in the picture");
  const heads = (await teacher.page.locator("table.class thead th").allInnerTexts()).map((one) => one.replace(/^[▸▾] /, ""));
  assert.deepEqual([...heads.slice(0, 4), heads.length < 8], ["Learner", "Now", "Lessons", "Eaters", true], "a column for each course, not for each lesson");
  await teacher.page.locator("thead button", { hasText: "Eaters" }).click();
  await until(async () => (await teacher.page.locator("th.lesson").count()) === 8, "eight lessons unfold");
  assert.ok((await teacher.page.locator("th.lesson").allInnerTexts()).every((text) => /[a-z]{3}/i.test(text)), "lessons have names");
  assert.ok(await fits(), "they fit as well");
  await teacher.page.locator("thead button", { hasText: "Eaters" }).click();
  await teacher.page.locator("thead button", { hasText: "Lessons" }).click();
  await until(async () => (await teacher.page.locator("th.lesson").count()) > 22, "all lessons of the first course unfold");
  assert.ok(await fits(), "the longest course fits");
  await teacher.page.locator("thead button", { hasText: "Eaters" }).click();
  await picture(teacher.page, "class_unfolded");
  await until(async () => (await teacher.page.locator("th.lesson").count()) > 30, "both are unfolded");
  await picture(teacher.page, "class_both");
  // The teacher's table shows a mistake with its line.
  await typeRules(learner.page, "sp {greet\n   (state <s> ^io.input-link <in>\n-->\n   (write |hello|)}\n");
  await learner.page.keyboard.press("Control+s");
  await until(async () => /porter\.soar, line \d/.test(await teacher.page.locator("tr", { hasText: "Ada" }).locator("td.now").innerText()), "the mistake is in the table");
  // The learner raises a hand, and the teacher lowers it.
  await learner.page.locator("button", { hasText: "Raise hand" }).click();
  await learner.page.locator("button", { hasText: "Your hand is up" }).waitFor();
  await teacher.page.locator("tr.hand", { hasText: "Ada" }).waitFor();
  await picture(teacher.page, "class_hand");
  await teacher.page.locator("tr.hand .raised button").click();
  await learner.page.locator("button", { hasText: "Raise hand" }).waitFor();
  // A watcher sees the learner's name and the typed text, and can write about a line.
  await teacher.page.locator("tr", { hasText: "Ada" }).locator("a", { hasText: "Watch" }).click();
  await teacher.page.waitForSelector(".cm-content .tok-keyword");
  assert.match(await teacher.page.locator(".head").innerText(), /You watch Ada's place/);
  await typeRules(learner.page, "# Not applied yet.\n# The second line.\n");
  await until(async () => /The second line/.test(await teacher.page.locator(".cm-content").innerText()), "unsaved text is seen");
  await teacher.page.locator(".pill", { hasText: "not applied yet" }).waitFor();
  await teacher.page.locator(".cm-line").nth(1).click();
  await teacher.page.locator(".write input").fill("Think of the sign here");
  await picture(teacher.page, "class_watch");
  await teacher.page.locator(".write button", { hasText: "about this line" }).click();
  const note = learner.page.locator(".remark.note");
  await note.waitFor();
  assert.match(await note.innerText(), /Think of the sign here\s+porter\.soar, line 2/);
  await picture(learner.page, "class_note");
  await note.locator("button", { hasText: "line 2" }).click();
  await until(async () => /second line/.test(await learner.page.locator(".cm-activeLine").innerText()), "the caret is in the line");
  await note.locator("button", { hasText: "I have read it" }).click();
  await note.waitFor({ state: "detached" });
  for (const one of [learner, teacher]) {
    assert.deepEqual(one.troubles, []);
    await one.close();
  }
  await server.kill();
});

test("learners hand in, the teacher plays, a ladder appears, and a match is watched", { skip }, async () => {
  const { server, table, links } = await begin(["Ada", "Bob"]);
  for (const [i, rules] of ["greedy", "wanderer"].entries()) {
    const { page, troubles, close } = await visit(links[i]);
    await openWorld(page, "eaters");
    await page.locator("button.home").click();
    const file = page.locator(".arena button", { hasText: `Hand in ${rules}.soar` });
    await file.click();
    await page.locator(".remark", { hasText: `${rules}.soar is handed in` }).waitFor();
    assert.deepEqual(troubles, []);
    await close();
  }
  const teacher = await visit(table);
  await teacher.page.locator(".arena button", { hasText: "Play Eaters" }).click();
  await until(async () => (await teacher.page.locator(".arena table.ladder tbody tr").count()) === 2 && (await teacher.page.locator(".arena progress").count()) === 0, "the ladder is there");
  assert.match(await teacher.page.locator(".arena table.ladder tbody tr").first().innerText(), /^1\s+Ada\s+[46]\s+[23]/, "who eats greedily wins most games");
  assert.match(await teacher.page.locator(".arena").innerText(), /seeds 1 to 3/);
  await picture(teacher.page, "class_arena");
  const learner = await visit(links[1], { draws: true });
  // The world with the changed rules is still open.
  await learner.page.waitForSelector(".run-page:not([hidden])");
  await learner.page.locator("button.home").click();
  await learner.page.locator(".arena summary").first().click();
  await picture(learner.page, "class_arena_learner");
  await learner.page.locator(".arena button[aria-label^='Replay of']").first().click();
  await learner.page.waitForSelector(".pill:has-text('Recording')");
  assert.match(await learner.page.locator("h1.run-title").innerText(), /ada against bob|bob against ada/);
  await until(async () => (await learner.page.locator(".labels .name").count()) === 2, "both play");
  await picture(learner.page, "class_match");
  const address = learner.page.url();
  assert.match(address, /#match=\w{26}/);
  await learner.page.reload();
  await until(async () => (await learner.page.locator(".labels .name").count()) === 2, "a match has an address");
  for (const one of [learner, teacher]) {
    assert.deepEqual(one.troubles, []);
    await one.close();
  }
  await server.kill();
});

test("a link to watch shows the live run and changes nothing; it can be withdrawn", { skip }, async () => {
  const server = await startServer([]), owner = await visit(`${server.address}/`);
  await openLesson(owner.page, 2);
  await owner.page.locator("button[aria-label='Links to share']").click();
  const section = owner.page.locator("section.link", { hasText: "Watch what I do" });
  await section.locator("button", { hasText: "Make this link" }).click();
  await section.locator("input.address").waitFor();
  const link = await section.locator("input.address").inputValue(), place = new URL(owner.page.url()).pathname.split("/")[2];
  assert.match(link, /\/w\/\w{26}\/$/);
  assert.ok(!link.includes(place));
  await picture(owner.page, "links");
  const guest = await visit(link);
  await guest.page.waitForSelector(".panel.mission > .title");
  assert.match(await guest.page.locator(".head").innerText(), /You watch somebody's run; you cannot change anything/);
  assert.equal(await guest.page.locator(".panel.edit .bar button.primary").count(), 0);
  assert.equal(await guest.page.locator("button[aria-label='Links to share']").count(), 0);
  assert.ok(!(await guest.page.content()).includes(place), "the place's link stays a secret");
  // The guest sees the next world that the owner opens.
  await owner.page.keyboard.press("Escape");
  await owner.page.locator("button.home").click();
  await openWorld(owner.page, "soar_hallway");
  await until(async () => /soar_hallway/.test(await guest.page.locator(".head").innerText()), "the guest follows");
  await owner.page.locator("button[aria-label='Links to share']").click();
  await section.locator("button", { hasText: "Withdraw" }).click();
  await section.locator("button", { hasText: "Make this link" }).waitFor();
  assert.deepEqual([owner.troubles, guest.troubles], [[], []]);
  await guest.close();
  const late = await visit(link, { passed: /404/ });
  await late.page.locator("[role=alert] h1").waitFor();
  await late.close();
  await owner.close();
  await server.kill();
});
