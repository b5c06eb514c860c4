// SPDX-License-Identifier: BSD-2-Clause
// `soarbox watch --browser` follows the agents of a kernel that another program drives.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { mkdtempSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import { fileURLToPath } from "node:url";
import { closeBrowser, openPage, picture, show, until } from "./browser.mjs";
import { COMMAND, freePort } from "./own_server.mjs";

const skip = COMMAND === "" ? "SOARBOX_COMMAND names no program" : false;
const here = (path) => fileURLToPath(new URL(path, import.meta.url));
const processes = [];
// Kills the processes even after a failed test, because this process could not end otherwise.
after(async () => {
  await closeBrowser();
  for (const one of processes) one.kill("SIGKILL");
});

const COUNT = `sp {begin (state <s> ^superstate nil) --> (<s> ^count 0)}
sp {propose*count
   (state <s> ^superstate nil ^io.input-link.limit <limit> ^count { <n> < <limit> })
-->
   (<s> ^operator <o> + =)
   (<o> ^name count)}
sp {apply*count
   (state <s> ^operator.name count ^count <n> ^io.output-link <out>)
-->
   (<s> ^count <n> - (+ <n> 1))
   (<out> ^counted <c>)
   (<c> ^number <n>)}
`;

/**
 * Starts a program and collects its output. An environment without PATH prevents `soarbox watch` from opening a
 * browser.
 */
function start(program, words, environment = process.env) {
  const process_ = spawn(program, words, { stdio: ["pipe", "pipe", "pipe"], env: environment });
  processes.push(process_);
  const started = { process: process_, told: "", ended: new Promise((resolve) => process_.on("exit", resolve)) };
  for (const stream of [process_.stdout, process_.stderr]) stream.on("data", (bytes) => (started.told += bytes));
  return started;
}

/** A client of a kernel, which creates agents and sends them command lines. */
function startClient(port) {
  const client = start("python3", [here("../../tests/serve/kernel_client.py"), String(port)]);
  let answered = 0;
  const ask = async (first, second) => {
    client.process.stdin.write(`${JSON.stringify([first, second])}\n`);
    const lines = () => client.told.split("\n").slice(0, -1);
    await until(() => lines().length > answered, `the kernel answers ${second}`);
    return JSON.parse(lines()[answered++]);
  };
  return { ask, end: () => client.process.kill("SIGKILL") };
}

/** Starts a kernel with an agent that has counted for three decisions, its client, and the page that watches it. */
async function watchCounter(...options) {
  const folder = mkdtempSync(join(tmpdir(), "soarbox-")), file = join(folder, "count.soar"), port = await freePort();
  writeFileSync(file, COUNT);
  const kernel = start(COMMAND, ["kernel", "--port", String(port), ...options, file]);
  await until(() => kernel.told.includes(`listens on 127.0.0.1:${port}`), "the kernel listens");
  const client = startClient(port);
  await client.ask("count", "wm add I2 limit 100");
  await client.ask("count", "run 3");
  const watch = start(COMMAND, ["watch", `127.0.0.1:${port}`, "--browser", "--page", here("../dist/page")], { ...process.env, PATH: "/nowhere" });
  const link = () => /Open (\S+) in a browser/.exec(watch.told)?.[1];
  await until(link, "it says where the page is");
  const opened = await openPage(link(), { draws: false, passed: /WebSocket|ERR_CONNECTION/ });
  await opened.page.waitForSelector(".run-page:not([hidden])");
  const end = async () => {
    client.end();
    await opened.close();
    for (const one of [kernel, watch]) one.process.kill("SIGKILL");
    await Promise.all([kernel.ended, watch.ended]);
  };
  return { ...opened, kernel, client, file, end };
}

const textOf = (page, panel) => page.locator(`.panel.${panel}`).innerText();
const shows = (page, panel, pattern) => until(async () => pattern.test(await textOf(page, panel)), `${panel} shows ${pattern}`);

test("panels show what the agents of a kernel did and do, and what is typed goes to the kernel", { skip }, async () => {
  const { page, troubles, kernel, client, file, end } = await watchCounter();
  await page.locator(".agents button", { hasText: "count" }).first().click();
  await show(page, "Trace");
  await shows(page, "trace", /counted \^number 1/);
  await show(page, "Memory");
  await shows(page, "memory", /\^count\s*2/);
  // The client continues, and the page follows.
  await client.ask("count", "run 4");
  await shows(page, "memory", /\^count\s*6/);
  await show(page, "Senses");
  await shows(page, "links", /limit\s*100/);
  await show(page, "Rules");
  await shows(page, "rules", /propose\*count/);
  await show(page, "Why");
  await page.locator(".panel.why button", { hasText: "Why this?" }).click();
  await page.waitForSelector(".panel.why .tree li");
  await shows(page, "why", /propose\*count/);
  await picture(page, "watch");

  await show(page, "Console");
  await page.locator(".panel.console input").fill("wm add I2 colour red");
  await page.keyboard.press("Enter");
  await until(async () => /\^colour red/.test(await client.ask("count", "print I2")), "the command line goes to the kernel");
  await show(page, "Mind");
  await page.locator(".flow-bar button", { hasText: "Decision" }).click();
  await until(async () => /\^count 7/.test(await client.ask("count", "print S1")), "the kernel's agent makes a decision");
  await shows(page, "mind", /decision 8/);
  await page.locator(".flow-bar button[aria-label=Run]").click();

  // The kernel gets the changed rules of a file that it has loaded.
  writeFileSync(file, COUNT.replace("(+ <n> 1)", "(+ <n> 10)"));
  await until(async () => /\+ <n> 10/.test(await client.ask("count", "print apply*count")), "the kernel has the new rule");
  await client.ask("count", "run 1");
  await show(page, "Memory");
  await shows(page, "memory", /\^count\s*17/);

  await client.ask("create", "late");
  await client.ask("late", "run --self 1");
  await until(async () => (await page.locator(".agents button", { hasText: "late" }).count()) > 0, "an agent that comes later is there, too");

  kernel.process.kill("SIGINT");
  await kernel.ended;
  await show(page, "Problems");
  await shows(page, "problems", /the kernel has ended/);
  await show(page, "Memory");
  await shows(page, "memory", /\^count\s*17/);
  assert.deepEqual(troubles, []);
  await end();
});

test("the past is shown, and what goes on from there is a copy that leaves the kernel alone", { skip }, async () => {
  const { page, troubles, client, end } = await watchCounter();
  await client.ask("count", "run 9");
  await show(page, "Memory");
  await shows(page, "memory", /\^count\s*11/);
  await page.locator(".past").focus();
  for (let i = 0; i < 4; ++i) await page.keyboard.press("ArrowLeft");
  await shows(page, "memory", /\^count\s*7/);
  await page.locator("button", { hasText: "Resume here" }).click();
  await page.waitForSelector(".is-live");
  await show(page, "Futures");
  await shows(page, "futures", /went on from/);
  assert.match(await client.ask("count", "print S1"), /\^count 11/);
  assert.deepEqual(troubles, []);
  await end();
});

test("a kernel without a log is watched as it is now", { skip }, async () => {
  const { page, troubles, client, end } = await watchCounter("--no-log");
  await until(async () => /keeps no log/.test(await page.locator("body").innerText()), "the page says what is missing");
  await show(page, "Memory");
  await shows(page, "memory", /\^count\s*2/);
  await client.ask("count", "run 4");
  await shows(page, "memory", /\^count\s*6/);
  assert.deepEqual(troubles, []);
  await end();
});
