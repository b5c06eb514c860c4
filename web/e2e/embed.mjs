// SPDX-License-Identifier: BSD-2-Clause
// A page of another site shows live worlds if the server allows this site, and otherwise none.
import assert from "node:assert/strict";
import { createServer } from "node:http";
import { after, test } from "node:test";
import { closeBrowser, openPage, picture, until } from "./browser.mjs";
import { COMMAND, freePort, startServer } from "./own_server.mjs";

const skip = COMMAND === "" ? "SOARBOX_COMMAND names no program" : false;
after(closeBrowser);

/** A site with one page. */
async function site(port, body) {
  const server = createServer((_request, response) => response.setHeader("Content-Type", "text/html; charset=utf-8").end(`<!doctype html><title>A course</title><h1>A course</h1>${body}`));
  await new Promise((resolve) => server.listen(port, "127.0.0.1", resolve));
  return { address: `http://127.0.0.1:${port}/`, close: () => server.close() };
}

test("worlds begin when they are clicked, each in its own place, and accept keys and rules", { skip }, async () => {
  const port = await freePort(), server = await startServer(["--embed", `http://127.0.0.1:${port}`]);
  const course = await site(port, `<p>Click.</p><soarbox-world src="${server.address}/#world=soar_hallway" panels="mind why"></soarbox-world>
    <soarbox-world src="#lesson=02-operators" panels="edit" label="Try the mower"></soarbox-world><soarbox-world src="nothing"></soarbox-world><script src="${server.address}/embed.js"></script>`);
  const { page, troubles, close } = await openPage(course.address, { passed: /favicon/ });
  const worlds = page.locator("soarbox-world");
  assert.match(await worlds.nth(0).locator("button").innerText(), /Start soar_hallway/);
  assert.match(await worlds.nth(2).locator("button").innerText(), /cannot be shown/);
  assert.equal(await page.locator("soarbox-world iframe").count(), 0, "nothing runs before a click");
  await worlds.nth(0).locator("button").click();
  const first = page.frameLocator("soarbox-world >> nth=0 >> iframe");
  await until(async () => (await first.locator(".labels .name").count()) === 2, "the world lives");
  await first.locator("#tab-mind").waitFor();
  assert.equal(await first.locator("[role=tab]").count(), 2, "only the panels that are asked for");
  await picture(page, "embedded");
  await worlds.nth(1).locator("button").click();
  const second = page.frameLocator("soarbox-world >> nth=1 >> iframe");
  await second.locator(".cm-content .tok-keyword").first().waitFor();
  // The first world continues at the same time.
  const clock = () => first.locator(".foot").innerText();
  const before = await clock();
  await until(async () => (await clock()) !== before, "both run at the same time");
  assert.match(await first.locator("a", { hasText: "Open in Soarbox" }).getAttribute("href"), /#world=soar_hallway$/);
  assert.deepEqual(troubles, []);
  await close();
  course.close();
  await server.kill();
});

test("a site that --embed does not name shows no world", { skip }, async () => {
  const [port, other] = [await freePort(), await freePort()], server = await startServer(["--embed", `http://127.0.0.1:${port}`]);
  const course = await site(other, `<iframe src="${server.address}/embed#world=soar_hallway"></iframe><iframe src="${server.address}/#world=soar_hallway"></iframe>`);
  const { page, close } = await openPage(course.address, { draws: false, passed: /./ });
  const refused = [];
  page.on("console", (message) => /frame-ancestors/.test(message.text()) && refused.push(message.text()));
  await page.reload();
  await until(() => refused.length >= 2, "the browser refuses both frames");
  for (const frame of page.frames().slice(1)) assert.equal(await frame.locator(".run-page, .start").count(), 0);
  await close();
  course.close();
  await server.kill();
});
