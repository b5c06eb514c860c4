// SPDX-License-Identifier: BSD-2-Clause
// Names in a crowd at 1280 px: many are shown, complete and readable, and none covers another.
import assert from "node:assert/strict";
import { after, test } from "node:test";
import { closeBrowser, openPage, openWorld, picture, until } from "./browser.mjs";

after(closeBrowser);

test("in a crowd only names are shown, readable and without overlaps", async () => {
  const { page, troubles, close } = await openPage("/");
  await openWorld(page, "crowd");
  await until(async () => (await page.locator(".labels .name.compact").count()) >= 12, "a dozen names are shown");
  // Reads all names at once, because the picture changes.
  const names = await page.locator(".labels").evaluate((labels) => [...labels.querySelectorAll(".name")].map((one) => {
    const { left, top, right, bottom } = one.getBoundingClientRect(), name = one.querySelector("b");
    return { text: name.textContent, left, top, right, bottom, size: parseFloat(getComputedStyle(name).fontSize), isCut: name.scrollWidth > name.clientWidth + 1 };
  }));
  for (const one of names) {
    assert.ok(one.size >= 12, `${one.text} has ${one.size} px`);
    assert.ok(!one.isCut, `${one.text} is cut`);
  }
  for (const [i, a] of names.entries()) for (const b of names.slice(i + 1)) assert.ok(a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top, `${a.text} covers ${b.text}`);
  await picture(page, "crowd_1280");
  assert.deepEqual(troubles, []);
  await close();
});
