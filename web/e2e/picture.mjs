// SPDX-License-Identifier: BSD-2-Clause
// Texts over the picture, keys for the world's scripts, and explanations of words in rules.
import assert from "node:assert/strict";
import { after, test } from "node:test";
import { closeBrowser, openLesson, openPage, openWorld, picture, show, until } from "./browser.mjs";

after(closeBrowser);

test("the navigation mesh, influence map, physics and forces are drawn while they are on, also over a paused world", async () => {
  const { page, troubles, close } = await openPage("/", { size: [820, 420] });
  await openWorld(page, "tactics");
  await page.waitForSelector(".labels .name");
  await until(async () => Number.parseFloat((await page.locator(".scrubber .moment").innerText()).split("/")[0].split(":")[1]) > 3, "the world runs");
  await page.keyboard.press("Space");
  await page.waitForSelector(".flow-bar button[aria-label=Run]");
  const seen = async () => (await page.locator(".stage").screenshot()).toString("base64");
  const toggle = async (title) => {
    await page.locator("button[aria-label='What is drawn over the picture']").click();
    await page.locator(".menu label", { hasText: title }).locator("input").click();
    await page.keyboard.press("Escape");
    await page.mouse.move(2, 2);
    await page.locator(".stage canvas").focus();
  };
  await page.mouse.move(2, 2);
  await page.locator(".stage canvas").focus();
  await until(async () => (await seen()) === (await seen()), "the picture stands still");
  for (const title of ["Navigation mesh", "Influence map", "Physics shapes", "Forces"]) {
    const before = await seen();
    await toggle(title);
    await until(async () => (await seen()) !== before, `${title}: it is drawn`);
    await until(async () => (await seen()) === (await seen()), "the picture stands still");
    const drawn = await seen();
    await picture(page, `overlay_${title.split(" ")[0].toLowerCase()}`);
    await toggle(title);
    await until(async () => (await seen()) !== drawn, `${title}: and no longer`);
  }
  assert.deepEqual(troubles, []);
  await close();
});

const outside = (page) => page.locator(".stage").getAttribute("data-outside");
const shownSeconds = async (page) => {
  const [minutes, seconds] = (await page.locator(".scrubber .moment").innerText()).split("/")[0].trim().split(":");
  return 60 * Number(minutes) + Number(seconds);
};

test("the camera keeps everybody in the picture until it is moved, and again on request", async () => {
  const { page, troubles, close } = await openPage("/", { size: [1280, 800] });
  for (const [name, seconds] of [["movement", 2], ["soar_flee", 6], ["eaters", 1]]) {
    await openWorld(page, name);
    await page.waitForSelector(".stage[data-outside]");
    await page.waitForSelector(".labels .name");
    assert.equal(await outside(page), "0", `${name}: everybody is in the first picture`);
    await until(async () => (await shownSeconds(page)) > seconds, `${name} runs`);
    await until(async () => (await outside(page)) === "0", `${name}: everybody is in the picture`);
    assert.equal(await page.locator("button[aria-label='Show everybody']").getAttribute("aria-pressed"), "true");
    await picture(page, `framed_${name}`);
    await page.locator("button.home").click();
  }
  await openWorld(page, "soar_flee");
  await page.waitForSelector(".stage button[aria-label='Show everybody'][aria-pressed=true]");
  // Pauses, because a running agent could come back into the picture before the button is clicked.
  await page.locator("button[aria-label=Pause]").first().click();
  await page.waitForSelector("button[aria-label=Run]");
  await page.locator(".stage canvas").focus();
  // If no agent is in the picture, a button brings the camera back. (Keys have no effect before the first picture.)
  const back = page.locator("button", { hasText: "Nobody is in the picture" });
  await until(async () => {
    for (let i = 0; i < 20; ++i) await page.keyboard.press("Shift+ArrowRight");
    return (await back.count()) > 0;
  }, "the camera is moved away from everybody");
  assert.equal(await page.locator(".stage button[aria-label='Show everybody']").getAttribute("aria-pressed"), "false");
  await back.click();
  await until(async () => (await outside(page)) === "0", "everybody is in the picture again");
  await page.waitForSelector(".stage button[aria-label='Show everybody'][aria-pressed=true]");
  assert.deepEqual(troubles, []);
  await close();
});

test("the names of agents are not cut", async () => {
  const { page, troubles, close } = await openPage("/", { size: [1280, 800] });
  await openWorld(page, "movement");
  await page.waitForSelector(".labels .name");
  const cut = () => page.locator(".labels .name b").evaluateAll((all) => all.filter((one) => one.scrollWidth > one.clientWidth).map((one) => one.textContent));
  assert.deepEqual(await cut(), []);
  assert.deepEqual(troubles, []);
  await close();
});

test("on a phone all steps and the speed are in the bar, labels are names, and signs are beside the first line of their text", async () => {
  const { page, troubles, close } = await openPage("/", { size: [390, 844] });
  await openWorld(page, "sheepdog");
  await page.waitForSelector(".labels .name");
  const right = (selector) => page.locator(selector).evaluate((one) => one.getBoundingClientRect().right);
  for (const name of ["Step a tick", "Step a decision", "Step a phase", "Begin again", "Faster"]) assert.ok((await right(`.flow-bar button[aria-label="${name}"]`)) <= 390, `${name} is in the picture`);
  await until(async () => (await page.locator(".labels .name").count()) > 3 && (await page.locator(".labels .name:not(.compact):not(.selected)").count()) === 0, "nine labels are only names");
  await show(page, "Why");
  await page.waitForSelector(".panel.why .fold-row");
  const off = await page.locator(".panel.why .fold-row:has(> button.fold)").evaluateAll((rows) => rows.map((row) => {
    const [sign, text] = [row.children[0], row.children[1]].map((one) => {
      const range = document.createRange();
      range.selectNodeContents(one);
      return range.getClientRects()[0];
    });
    return sign === undefined || text === undefined ? 0 : Math.abs(sign.top - text.top);
  }));
  assert.ok(off.length > 3 && Math.max(...off) < 6, `signs are ${Math.max(...off)} px from the first lines of their texts`);
  await picture(page, "phone");
  assert.deepEqual(troubles, []);
  await close();
});

test("the dots of the timeline are explained", async () => {
  const { page, troubles, close } = await openPage("/", { draws: false });
  await openWorld(page, "thesis");
  await show(page, "Timeline");
  await page.waitForSelector(".mark-kinds li:has-text('command')");
  assert.deepEqual((await page.locator(".mark-kinds li").allInnerTexts()).filter((name) => !/^(command|answer|message|event|error)$/.test(name)), []);
  assert.deepEqual(troubles, []);
  await close();
});

test("keys reach a world's scripts as in the window", async () => {
  const { page, troubles, close } = await openPage("/", { size: [1000, 560] });
  await openWorld(page, "thesis");
  await page.waitForSelector(".script-ui .box");
  const boxes = () => page.locator(".script-ui .box:visible").count();
  const before = await boxes();
  await page.locator(".stage canvas").focus();
  await page.keyboard.press("F2");
  await until(async () => (await boxes()) !== before, "F2 shows or hides the help of this world");
  await page.keyboard.press("F2");
  await until(async () => (await boxes()) === before, "and F2 again");
  // Keys that are pressed in a panel do not reach the world.
  await page.locator("[role=tab]", { hasText: /^Agents/ }).focus();
  await page.keyboard.press("F2");
  await page.waitForTimeout(500);
  assert.equal(await boxes(), before);
  await picture(page, "keys");
  assert.deepEqual(troubles, []);
  await close();
});

test("what an agent prints is over its head, and in the panel Output from the first tick", async () => {
  const { page, troubles, close } = await openPage();
  await openLesson(page, 1);
  await show(page, "Output");
  await page.locator(".lines.output li", { hasText: "Somebody is there" }).last().waitFor();
  // Pauses, because each new line at the top moves the first one.
  await page.locator("button[aria-label=Pause]").first().click();
  await page.waitForSelector("button[aria-label=Run]");
  const first = page.locator(".lines.output li").last().locator(".time");
  const [minutes, seconds] = (await first.innerText()).split(":");
  assert.ok(60 * Number(minutes) + Number(seconds) < 2, "the first one is there, though the panel was opened later");
  // Speech disappears after some seconds. At its moment it is always shown.
  await first.click();
  await page.waitForSelector(".labels .speech:has-text('Somebody is there')");
  await picture(page, "output");
  assert.deepEqual(troubles, []);
  await close();
});

test("an empty world and agents without a mind are explained, with what to do", async () => {
  const { page, troubles, close } = await openPage();
  await openWorld(page, "mind_body");
  await page.waitForSelector(".stage .nobody:has-text('F4 calls a soldier')");
  await page.waitForSelector(".panel.mind:has-text('Nobody is in this world yet')");
  await page.locator(".stage canvas").focus();
  await page.keyboard.press("F4");
  await page.waitForSelector(".labels .name");
  await until(async () => (await page.locator(".stage .nobody").count()) === 0, "somebody is there now");
  await until(async () => (await outside(page)) === "0", "and in the picture");
  await page.locator("button.home").click();
  await openWorld(page, "decisions");
  await page.waitForSelector(".panel.mind:has-text('No agent of this world has a Soar mind')");
  // The rules of the previous world are no longer in the editor.
  await show(page, "Edit");
  assert.doesNotMatch(await page.locator(".cm-content").innerText(), /sp \{/);
  assert.deepEqual(troubles, []);
  await close();
});

test("a word of a rule under the mouse is explained", async () => {
  const { page, troubles, close } = await openPage();
  await openLesson(page, 1);
  const word = page.locator(".cm-line", { hasText: "sp {porter" }).first().locator("span", { hasText: "porter" }).first();
  const tooltip = page.locator(".about-word");
  await until(async () => {
    const box = await word.boundingBox();
    await page.mouse.move(box.x + box.width / 2 - 3, box.y + box.height / 2);
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.waitForTimeout(800);
    return (await tooltip.count()) > 0;
  }, "the name of a rule is explained");
  assert.match(await tooltip.innerText(), /rule porter\*/);
  // Words that a beginner meets first are explained in plain words.
  for (const [text, told] of [["state", /first condition looks at a state/], ["-->", /between conditions and actions/], ["^superstate", /top state/]]) {
    // Moves the mouse away first, because an explanation may cover the next word.
    await page.mouse.move(640, 770);
    await until(async () => (await tooltip.count()) === 0, "the explanation goes with the mouse");
    await until(async () => {
      // Looks up the position again, because the text may have moved.
      const at = await page.locator(".cm-line span", { hasText: text }).first().boundingBox();
      await page.mouse.move(at.x + at.width / 2 - 3, at.y + at.height / 2);
      await page.mouse.move(at.x + at.width / 2, at.y + at.height / 2);
      await page.waitForTimeout(800);
      return told.test(await tooltip.allInnerTexts().then((all) => all.join(" ")));
    }, `${text} is explained`);
  }
  await picture(page, "hover");
  assert.deepEqual(troubles, []);
  await close();
});
