// SPDX-License-Identifier: BSD-2-Clause
// Tests the engine of a page without a server in Node.js: its answers to a page's requests, in every world and lesson.
//
// usage: node run_engine.mjs ENGINE [NAME...]     ENGINE: the folder of soarbox-engine.mjs; NAME: only these worlds and lessons
//
// Each world runs for some seconds at full speed. Each lesson's solution is applied and graded. The test "experiment" checks
// that an experiment from a link shows the same moment as the original run. Prints one line for each test; the exit status is
// 1 if a test fails. Needs the page's packages (npm ci in web/).
import assert from "node:assert/strict";
import { existsSync, mkdtempSync, readdirSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

const REPOSITORY = new URL("../../", import.meta.url).pathname, WEB = join(REPOSITORY, "web");
const PATIENCE_MS = 300_000, SECONDS = 5;
const [folder, ...names] = process.argv.slice(2);
if (folder === undefined || !existsSync(join(folder, "soarbox-engine.mjs"))) {
  console.error("usage: node run_engine.mjs ENGINE [NAME...], where ENGINE has soarbox-engine.mjs (./dev site builds it)");
  process.exit(2);
}
const { build } = createRequire(join(WEB, "package.json"))("esbuild");
const bundled = join(mkdtempSync(join(tmpdir(), "soarbox-")), "local.mjs");
await build({ stdin: { contents: 'export * from "./src/local/engine"; export * from "./src/local/worker_source";', resolveDir: WEB }, outfile: bundled, bundle: true, platform: "node", format: "esm", logLevel: "warning" });
const { EngineWorker, LocalPlace, LocalApi } = await import(pathToFileURL(bundled).href);
const { default: makeEngine } = await import(pathToFileURL(resolve(folder, "soarbox-engine.mjs")).href);

/** A page with its place: stores the latest messages from the engine, and waits for new ones. */
class Page {
  hello = null;
  contents = {};
  flow = null;
  blocks = 0;
  errors = [];
  ended = "";

  constructor(experiment) {
    this.place = new LocalPlace(() => {
      const port = { onmessage: null, onerror: null, postMessage: (message) => void worker.take(message), terminate: () => undefined };
      const worker = new EngineWorker({
        // There is no other worker, so this engine also grades.
        load: async () => ({ make: (settings) => makeEngine({ ...settings, locateFile: (name) => resolve(folder, name) }), loaded: null }),
        say: (message) => port.onmessage?.({ data: message }),
        later: (call, ms) => {
          const timer = ms > 0 ? setTimeout(call, ms) : setImmediate(call);
          return () => (ms > 0 ? clearTimeout(timer) : clearImmediate(timer));
        },
      });
      return port;
    }, "", false, experiment);
    this.api = new LocalApi(this.place);
    this.place.start({ message: (message) => this.take(message), block: () => (this.blocks += 1), connection: () => undefined });
  }

  take(message) {
    if (message.message === "hello") this.hello = message;
    if (message.message === "contents") Object.assign(this.contents, message.contents);
    if (message.message === "flow") this.flow = message;
    if (message.message === "error") this.errors.push(message.error);
    if (message.message === "ended") this.ended = message.text;
  }

  ask(request, fields = {}) {
    assert.ok(this.place.send({ request, ...fields }));
  }

  async until(fact, what) {
    for (const end = Date.now() + PATIENCE_MS; Date.now() < end;) {
      if (this.ended !== "") throw new Error(`the run ended: ${this.ended}`);
      if (fact()) return;
      await new Promise((done) => setTimeout(done, 10));
    }
    throw new Error(`it never was so: ${what}`);
  }

  async open(what) {
    this.hello = this.flow = null;
    this.contents = {};
    this.blocks = 0;
    this.errors = [];
    this.ask("open", { what });
    await this.until(() => this.hello?.what === what || this.errors.length > 0, `${what} is open`);
    assert.deepEqual(this.errors, []);
  }
}

async function runWorld(page, name) {
  await page.open(`scenario:${name}`);
  page.ask("look", { panels: ["agents", "messages"] });
  page.ask("flow", { what: "unlimited" });
  await page.until(() => page.flow !== null && page.flow.time_s >= SECONDS, `${name} has run for ${SECONDS} s`);
  page.ask("flow", { what: "pause" });
  await page.until(() => page.flow.paused, "it stands");
  assert.ok(page.blocks > 0, "there was something to see");
  return `${page.hello.agents.length} agents, ${page.flow.time_s.toFixed(1)} s, ${page.blocks} blocks`;
}

/** The files of a lesson's solution: [name, text] of each. */
function solutionOf(lesson) {
  const below = join(REPOSITORY, "lessons"), home = [below, ...readdirSync(below).map((course) => join(below, course))].find((one) => existsSync(join(one, lesson, "lesson.toml")));
  const solution = join(home, lesson, "solution");
  return readdirSync(solution).map((name) => [name, readFileSync(join(solution, name), "utf8")]);
}

async function solveLesson(page, name) {
  // Saves the files as the learner's editor would.
  for (const [file, text] of solutionOf(name)) await page.api.fetch(`/api/p/local/files/soarbox-lessons/${name}/${file}`, { method: "PUT", body: text });
  await page.open(`lesson:${name}`);
  page.ask("look", { panels: ["mission"] });
  await page.until(() => page.contents.mission !== undefined, "the mission is told");
  page.ask("lesson", { what: "grade" });
  await page.until(() => page.contents.mission.lesson?.is_graded !== true && (page.contents.mission.lesson?.grade ?? []).length > 0, `${name} is graded`);
  assert.ok(page.contents.mission.lesson.is_passed, page.contents.mission.lesson.grade.join("\n"));
  return page.contents.mission.lesson.grade[0];
}

/** Runs a world to a tick and returns the contents of its panel Agents at this tick, as JSON. */
async function agentsAt(page, what, tick) {
  await page.open(what);
  page.ask("look", { panels: ["mission"] });
  page.ask("flow", { what: "unlimited" });
  await page.until(() => page.flow !== null && page.flow.tick >= tick, `tick ${tick} is reached`);
  page.ask("flow", { what: "pause" });
  page.ask("seek", { tick });
  await page.until(() => page.contents.moment?.time.shown_tick === tick && page.contents.moment.time.is_live === false, `tick ${tick} is shown`);
  // Requested only now, so that the contents are about this moment.
  page.ask("look", { panels: ["agents", "mission"] });
  await page.until(() => page.contents.agents !== undefined, "the agents are told");
  return JSON.stringify(page.contents.agents);
}

/** The data of a link to a world with changed rules must lead to the same moment; the original rules must lead to a different one. */
async function tryExperiment(_page, _name) {
  const what = "scenario:soar_flee", file = "rabbit.soar", TICK = 90;
  const shipped = readFileSync(join(REPOSITORY, "scenarios/soar_flee", file), "utf8"), changed = shipped.replaceAll(/\bflee\b/g, "pursue");
  const before = await agentsAt(new Page(), what, TICK), page = new Page();
  await page.open(what);
  assert.deepEqual((await page.api.changedFiles(what)).files, {}, "nothing is changed yet");
  await page.api.fetch(`/api/p/local/files/worlds/soar_flee/${file}`, { method: "PUT", body: changed });
  const { files } = await page.api.changedFiles(what), here = await agentsAt(page, what, TICK);
  assert.deepEqual(files, { [file]: changed });
  const other = new Page({ what, files });
  assert.equal(await agentsAt(other, what, TICK), here, "the link shows the same");
  assert.notEqual(here, before, "other rules, another moment");
  return `tick ${TICK} is the same`;
}

const info = await new Page().api.json("/api/p/local");
const all = [...info.scenarios.map(({ name }) => ({ name, run: runWorld })), ...info.lessons.map(({ name }) => ({ name, run: solveLesson })), { name: "experiment", run: tryExperiment }];
assert.ok(info.scenarios.length >= 29 && info.lessons.length >= 23, `${info.scenarios.length} worlds, ${info.lessons.length} lessons`);
let failed = 0, done = 0;
for (const { name, run } of all.filter((one) => names.length === 0 || names.includes(one.name))) {
  const start = Date.now();
  try {
    // Each test has its own place, because a place is too small for the files of all lessons.
    const told = await run(new Page(), name);
    console.log(`good     ${name}: ${told}; ${((Date.now() - start) / 1000).toFixed(1)} s`);
  } catch (error) {
    failed += 1;
    console.log(`FAILED   ${name}: ${error.message}`);
  }
  done += 1;
}
console.log(`${done} worlds and lessons, ${failed} failed; ${Math.round(process.memoryUsage().rss / 1e6)} MB`);
process.exit(failed > 0 || done === 0 ? 1 : 0);
