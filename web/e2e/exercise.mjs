// SPDX-License-Identifier: BSD-2-Clause
// A run that shares a battlefield with another simulation: foreign entities are marked, and a panel shows the traffic.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { createSocket } from "node:dgram";
import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import { fileURLToPath } from "node:url";
import { closeBrowser, openPage, picture, until } from "./browser.mjs";
import { COMMAND, startServer } from "./own_server.mjs";

const SKIRMISH = fileURLToPath(new URL("../../scenarios/soar_skirmish", import.meta.url));
after(closeBrowser);

function freeUdpPort() {
  return new Promise((resolve) => {
    const socket = createSocket("udp4");
    socket.bind(0, "127.0.0.1", () => {
      const { port } = socket.address();
      socket.close(() => resolve(port));
    });
  });
}

test("foreign agents are marked, and the panel of the exercise describes it", { skip: COMMAND === "" && "SOARBOX_COMMAND names no program" }, async () => {
  const folder = join(mkdtempSync(join(tmpdir(), "soarbox-")), "joint"), port = await freeUdpPort();
  cpSync(SKIRMISH, folder, { recursive: true });
  const own = readFileSync(join(folder, "joint_blue.toml"), "utf8");
  assert.match(own, /\[dis\]/);
  writeFileSync(join(folder, "scenario.toml"), own.replace("[dis]", `[dis]\nport = ${port}`));
  rmSync(join(folder, "mission.toml"), { force: true });
  const others = spawn(COMMAND, ["run", join(SKIRMISH, "joint_red.toml"), "--headless", "--seconds", "600", "--dis", `239.1.2.3:${port},1,2`], { stdio: "ignore" });
  const server = await startServer(["--dis", folder]);
  const { page, troubles, close } = await openPage(`${server.address}/`);
  try {
    await page.waitForSelector(".agents tr:has(.team.foreign)");
    await until(async () => (await page.locator(".labels .name b").allInnerTexts()).some((name) => name.startsWith("◇ ")), "a foreign body is marked in the picture");
    await page.getByRole("tab", { name: "Exercise" }).click();
    await until(async () => /[1-9]\d* entit(y|ies) of others/i.test(await page.locator(".panel.exercise").innerText()), "there are entities of others");
    await until(async () => /Received:\s+[1-9]\d* PDUs/.test(await page.locator(".panel.exercise").innerText()), "PDUs are counted");
    const foreign = page.locator(".panel.exercise td button").first(), name = await foreign.innerText();
    await foreign.click();
    await page.waitForSelector(`.panel.exercise tr.chosen:has-text("${name}")`);
    await picture(page, "exercise");
    await page.emulateMedia({ colorScheme: "dark" });
    await picture(page, "exercise_dark");
    assert.deepEqual(troubles, []);
  } finally {
    others.kill("SIGKILL");
    await close();
    await server.kill();
  }
});

test("without --dis a learner's world joins no exercise, and says so", { skip: COMMAND === "" && "SOARBOX_COMMAND names no program" }, async () => {
  const folder = join(mkdtempSync(join(tmpdir(), "soarbox-")), "alone");
  cpSync(SKIRMISH, folder, { recursive: true });
  writeFileSync(join(folder, "scenario.toml"), readFileSync(join(folder, "joint_blue.toml"), "utf8"));
  const server = await startServer([folder]), { page, close } = await openPage(`${server.address}/`, { draws: false });
  await page.locator(".remark", { hasText: "joins no exercise" }).waitFor();
  assert.equal(await page.getByRole("tab", { name: "Exercise" }).count(), 0);
  await close();
  await server.kill();
});
