// SPDX-License-Identifier: BSD-2-Clause
// Measures the engine of a page: natively below `soarbox serve`, and as WebAssembly in Node.js, Chromium and Firefox. Prints a table in
// Markdown, and all measurements as JSON on standard error.
//
// usage: node site.mjs SOARBOX ENGINE SITE [--runs N] [--only WORLD,...] [--in PLATFORM,...]
//
// SOARBOX  the native program
// ENGINE   the folder of soarbox-engine.mjs (build/wasm/bin)
// SITE     what `./dev site` wrote (build/site)
//
// Each world runs at unlimited speed in an engine with one page, which gets the scene and no panels. Speed: ticks between two simulated
// times, divided by the processor time of the thread that runs the world (natively: of the process, which may use one core). So other
// work on the machine changes it little. Memory: that of the process in which the world runs, with its part of shared pages (Pss), at the
// end. First picture: time from the start of navigation until names of agents are drawn, on a page that was open before. The best of N
// runs counts (3). Needs the page's packages (npm ci in web/) and a display for Firefox (xvfb-run).
import { fork, spawn } from "node:child_process";
import { createReadStream, existsSync, mkdtempSync, readdirSync, readFileSync, rmSync, statSync } from "node:fs";
import { createServer } from "node:http";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { extname, join, resolve } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";

const REPOSITORY = fileURLToPath(new URL("../", import.meta.url)), WEB = join(REPOSITORY, "web"), require = createRequire(join(WEB, "package.json"));
const LESSON = "01-a-rule", PATIENCE_MS = 600_000;
/**
 * Variants of worlds are copies of a folder (`from`). `file`: the file that replaces the one that is opened; `change` changes its text.
 */
const WORLDS = [
  { name: "thesis", title: "`thesis`", from_s: 60, to_s: 960 },
  { name: "tactics", title: "`tactics`", from_s: 60, to_s: 960 },
  { name: "crowd", title: "`crowd`", from_s: 60, to_s: 240 },
  { name: "crowd_1000", title: "`crowd_1000`", from_s: 4, to_s: 12, from: "crowd", file: ["crowd_1000.lua", "Sandbox.lua"] },
  { name: "strollers_100", title: "100 Soar agents that stroll", from_s: 4, to_s: 64, from: "soar_wander", file: ["strollers_1000.toml", "scenario.toml"],
    change: (text) => text.replace("count = 1000", "count = 100").replace("across = 40", "across = 13") },
  { name: "skirmish_100", title: "100 soldiers that fight", from_s: 4, to_s: 24, from: "soar_skirmish", file: ["skirmish_100.toml", "scenario.toml"] },
];
const PLATFORMS = ["native", "Node.js", "Chromium", "Firefox"];

const readText = (file) => readFileSync(file, "utf8");
const wait = (ms) => new Promise((done) => setTimeout(done, ms));

/** Waits until a function returns neither null nor false, and returns its result. */
async function until(fact, what) {
  for (const end = Date.now() + PATIENCE_MS; Date.now() < end;) {
    const found = await fact();
    if (found !== null && found !== false && found !== undefined) return found;
    await wait(20);
  }
  throw new Error(`it never was so: ${what}`);
}

/** The processes below a process, itself included. */
function family(root) {
  const parents = new Map(), all = [root];
  for (const name of readdirSync("/proc")) {
    if (!/^\d+$/.test(name)) continue;
    try {
      const stat = readText(`/proc/${name}/stat`);
      parents.set(Number(name), Number(stat.slice(stat.lastIndexOf(")") + 2).split(" ")[1]));
    } catch {
      // It has ended.
    }
  }
  for (const process_ of all) for (const [child, parent] of parents) if (parent === process_) all.push(child);
  return all;
}

/** The thread of a browser's worker that has computed most: [process, thread]; null: there is none. */
function workerThread(browser) {
  const found = [];
  for (const process_ of family(browser)) {
    try {
      for (const thread of readdirSync(`/proc/${process_}/task`)) if (/^(DedicatedWorker|DOM Worker)/.test(readText(`/proc/${process_}/task/${thread}/comm`))) found.push([process_, Number(thread)]);
    } catch {
      // It has ended.
    }
  }
  return found.length === 0 ? null : found.reduce((most, one) => (cpuOfThread(one) > cpuOfThread(most) ? one : most));
}
const cpuOfThread = ([process_, thread]) => Number(readText(`/proc/${process_}/task/${thread}/schedstat`).split(" ")[0]) / 1e9;
function cpuOfProcess(process_) {
  const fields = readText(`/proc/${process_}/stat`);
  const [user, system] = fields.slice(fields.lastIndexOf(")") + 2).split(" ").slice(11, 13);
  return (Number(user) + Number(system)) / 100;
}
const memoryOf = (process_) => Number(/^Pss:\s+(\d+)/m.exec(readText(`/proc/${process_}/smaps_rollup`))[1]) * 1024;

/** The world's own copy of the files of a variant: [path in the place, text] of each. */
function filesOf({ name, from, file, change = (text) => text }) {
  if (from === undefined) return [];
  const folder = join(REPOSITORY, "scenarios", from), files = readdirSync(folder, { recursive: true, withFileTypes: true }).filter((one) => one.isFile() && !/\.(png|glb)$/.test(one.name));
  return files.map((one) => join(one.parentPath ?? one.path, one.name).slice(folder.length + 1)).filter((path) => path !== file[1])
    .map((path) => (path === file[0] ? [`worlds/${name}/${file[1]}`, change(readText(join(folder, path)))] : [`worlds/${name}/${path}`, readText(join(folder, path))]));
}

// The engine's end. A page, Node.js and the client of a server offer the same three functions.

const BRIDGE = `import { LocalApi, LocalPlace } from "./src/local/worker_source";
export function bridge(makePort, engine) {
  const place = new LocalPlace(makePort, engine, false), api = new LocalApi(place), state = { flow: null, what: "", error: "" };
  place.start({ block: () => undefined, connection: () => undefined, message: (message) => {
    if (message.message === "hello") state.what = message.what;
    if (message.message === "flow") state.flow = { tick: message.tick, time_s: message.time_s };
    if (message.message === "error") state.error = message.error + " " + (message.hint ?? "");
    if (message.message === "ended") state.error = message.text;
  } });
  return { state: () => state, ask: (request) => void place.send(request), put: (path, text) => api.fetch("/api/p/local/files/" + path, { method: "PUT", body: text }).then(() => null) };
}`;

async function bundled(outfile, more, platform) {
  await require("esbuild").build({ stdin: { contents: BRIDGE + more, resolveDir: WEB }, outfile, bundle: true, platform, format: "esm", logLevel: "warning" });
  return outfile;
}

/** In a process of its own: the engine in Node.js. */
async function beNode(engine) {
  const file = await bundled(join(mkdtempSync(join(tmpdir(), "soarbox-")), "bridge.mjs"), '\nexport { EngineWorker } from "./src/local/engine";', "node");
  const { bridge, EngineWorker } = await import(pathToFileURL(file).href), { default: makeEngine } = await import(pathToFileURL(resolve(engine, "soarbox-engine.mjs")).href);
  const page = bridge(() => {
    const port = { onmessage: null, onerror: null, postMessage: (message) => void worker.take(message), terminate: () => undefined };
    const worker = new EngineWorker({
      load: async () => ({ make: (settings) => makeEngine({ ...settings, locateFile: (name) => resolve(engine, name) }), loaded: null }),
      say: (message) => port.onmessage?.({ data: message }),
      later: (call, ms) => {
        const timer = ms > 0 ? setTimeout(call, ms) : setImmediate(call);
        return () => (ms > 0 ? clearTimeout(timer) : clearImmediate(timer));
      },
    });
    return port;
  }, "");
  process.on("message", async ({ call, name, values }) => process.send({ call, result: (await page[name](...values)) ?? null }));
  process.send({ call: -1 });
}

async function openNode({ engine }) {
  const child = fork(fileURLToPath(import.meta.url), ["--node", engine]), waiting = new Map();
  await new Promise((ready) => child.on("message", ({ call, result }) => (call < 0 ? ready() : waiting.get(call)(result))));
  let calls = 0;
  const call = (name, ...values) => new Promise((done) => {
    waiting.set(++calls, done);
    child.send({ call: calls, name, values });
  });
  return {
    state: () => call("state"), ask: (request) => call("ask", request), put: (path, text) => call("put", path, text),
    cpu: () => cpuOfThread([child.pid, child.pid]), memory: () => memoryOf(child.pid),
    close: () => child.kill("SIGKILL"),
  };
}

/** Starts `soarbox serve` on one core. */
async function startServer({ program }) {
  const state = mkdtempSync(join(tmpdir(), "soarbox-")), server = spawn("taskset", ["-c", "0", program, "serve", "--listen", "127.0.0.1:0", "--state", state, "--page", join(WEB, "dist/page"), "--memory", "2000"], { stdio: ["ignore", "pipe", "pipe"] });
  let told = "";
  for (const pipe of [server.stdout, server.stderr]) pipe.on("data", (bytes) => (told += bytes));
  const address = await until(() => (server.exitCode === null ? /Ctrl-C/.test(told) && /http:\/\/127\.0\.0\.1:\d+/.exec(told)?.[0] : Promise.reject(new Error(told))), "the server runs");
  return { address, pid: server.pid, close: () => {
    server.kill("SIGKILL");
    rmSync(state, { recursive: true, force: true });
  } };
}

async function openNative(settings) {
  const server = await startServer(settings), Socket = globalThis.WebSocket ?? require("ws").WebSocket, { place } = await (await fetch(`${server.address}/api/places`, { method: "POST", headers: { Origin: server.address } })).json();
  const state = { flow: null, what: "", error: "" }, socket = new Socket(`${server.address.replace("http", "ws")}/api/p/${place}/run`, { headers: { Origin: server.address } });
  await new Promise((done, failed) => Object.assign(socket, { onopen: done, onerror: (event) => failed(new Error(event.message)) }));
  socket.onmessage = ({ data }) => {
    if (typeof data !== "string") return;
    const message = JSON.parse(data);
    if (message.message === "hello") state.what = message.what;
    if (message.message === "flow") state.flow = { tick: message.tick, time_s: message.time_s };
    if (message.message === "error" || message.message === "ended") state.error = message.error ?? message.text;
  };
  const engine = () => family(server.pid).find((one) => one !== server.pid && readText(`/proc/${one}/cmdline`).includes("\0engine\0"));
  return {
    state: () => state, ask: (request) => socket.send(JSON.stringify(request)),
    put: async (path, text) => {
      const answer = await fetch(`${server.address}/api/p/${place}/files/${path}`, { method: "PUT", body: text, headers: { Origin: server.address } });
      if (!answer.ok) throw new Error(`${path}: ${await answer.text()}`);
    },
    cpu: () => cpuOfProcess(engine()), memory: () => memoryOf(engine()),
    close: () => {
      socket.close();
      server.close();
    },
  };
}

const TYPES = { ".html": "text/html", ".js": "text/javascript", ".mjs": "text/javascript", ".css": "text/css", ".wasm": "application/wasm", ".svg": "image/svg+xml", ".webmanifest": "application/manifest+json" };
/** Serves a site, with a page without a picture at /bench.html. */
async function serveSite(site) {
  const script = await bundled(join(mkdtempSync(join(tmpdir(), "soarbox-")), "bridge.js"), '\nwindow.bench = bridge(() => new Worker("assets/worker.js"), new URL("engine", document.baseURI).href);', "browser");
  const server = createServer(({ url }, answer) => {
    const path = decodeURIComponent(new URL(url, "http://site").pathname), file = path === "/bench.js" ? script : join(site, path === "/" ? "index.html" : path);
    if (path === "/bench.html") return void answer.setHeader("Content-Type", "text/html").end('<!doctype html><script type="module" src="bench.js"></script>');
    if (!existsSync(file) || !statSync(file).isFile()) return void answer.writeHead(404).end();
    answer.setHeader("Content-Type", TYPES[extname(file)] ?? "application/octet-stream").setHeader("Cache-Control", "max-age=3600");
    createReadStream(file).pipe(answer);
  });
  await new Promise((done) => server.listen(0, "127.0.0.1", done));
  return { address: `http://127.0.0.1:${server.address().port}/`, close: () => server.close() };
}

async function launch(browser) {
  const { default: puppeteer } = await import(pathToFileURL(require.resolve("puppeteer-core")).href);
  if (browser === "Firefox") {
    return puppeteer.launch({ browser: "firefox", executablePath: process.env.SOARBOX_FIREFOX ?? "/usr/bin/firefox-esr", headless: (process.env.DISPLAY ?? "") === "",
      env: { ...process.env, LIBGL_ALWAYS_SOFTWARE: "1" }, extraPrefsFirefox: { "webgl.force-enabled": true }, protocolTimeout: PATIENCE_MS });
  }
  return puppeteer.launch({ browser: "chrome", executablePath: process.env.SOARBOX_BROWSER ?? "/usr/bin/chromium", headless: true, protocolTimeout: PATIENCE_MS,
    args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--no-first-run", "--disable-background-networking"] });
}

const openBrowser = (name) => async ({ address }) => {
  const browser = await launch(name), page = await browser.newPage();
  await page.goto(`${address}bench.html`);
  await page.waitForFunction(() => window.bench !== undefined);
  const thread = () => workerThread(browser.process().pid);
  return {
    state: () => page.evaluate(() => window.bench.state()), ask: (request) => page.evaluate((one) => window.bench.ask(one), request),
    put: (path, text) => page.evaluate((file, contents) => window.bench.put(file, contents), path, text),
    cpu: () => cpuOfThread(thread()), memory: () => memoryOf(thread()[0]), close: () => browser.close(),
  };
};
const OPENERS = { native: openNative, "Node.js": openNode, Chromium: openBrowser("Chromium"), Firefox: openBrowser("Firefox") };

/** Runs a world once. Returns ticks per second of processor time, seconds of the world per second, and memory. */
async function measure(platform, world, settings) {
  const engine = await OPENERS[platform](settings), what = `scenario:${world.name}`;
  const stateOf = async () => {
    const state = await engine.state();
    if (state.error !== "") throw new Error(`${platform}, ${world.name}: ${state.error}`);
    return state;
  };
  const reached = (seconds) => until(async () => {
    const { flow } = await stateOf();
    return flow !== null && flow.time_s >= seconds && { ...flow, cpu_s: engine.cpu() };
  }, `${world.name} runs for ${seconds} s`);
  try {
    for (const [path, text] of filesOf(world)) await engine.put(path, text);
    await engine.ask({ request: "open", what });
    await until(async () => (await stateOf()).what === what, `${world.name} is open`);
    await engine.ask({ request: "flow", what: "unlimited" });
    const first = await reached(world.from_s), last = await reached(world.to_s), cpu_s = last.cpu_s - first.cpu_s;
    return { ticks_per_s: (last.tick - first.tick) / cpu_s, real_time: (last.time_s - first.time_s) / cpu_s, bytes: engine.memory() };
  } finally {
    await engine.close();
  }
}

/** Opens a lesson a second time in a browser. Returns the milliseconds until names are drawn, and the memory of the tab. */
async function firstPicture(name, address) {
  const browser = await launch(name);
  const visit = async () => {
    const page = await browser.newPage();
    await page.setViewport({ width: 1280, height: 800 });
    await page.evaluateOnNewDocument(() => {
      const look = () => (document.querySelector(".labels .name") === null ? requestAnimationFrame(look) : requestAnimationFrame(() => (window.pictureAfter_ms = performance.now())));
      look();
    });
    await page.goto(`${address}#lesson=${LESSON}`);
    await page.waitForFunction(() => window.pictureAfter_ms !== undefined, { timeout: PATIENCE_MS });
    return page;
  };
  try {
    await visit();
    await wait(8000);  // The browser stores files and compiled code.
    const before = (await browser.pages()).at(-1);
    await before.close();
    const page = await visit(), ms = await page.evaluate(() => window.pictureAfter_ms);
    await wait(5000);
    return { ms, bytes: workerThread(browser.process().pid) === null ? null : memoryOf(workerThread(browser.process().pid)[0]) };
  } finally {
    await browser.close();
  }
}

const best = (runs, of, pick = Math.max) => (runs.length === 0 ? null : pick(...runs.map(of)));
const MB = (bytes) => `${Math.round(bytes / 1e6)} MB`;

async function main() {
  const words = process.argv.slice(2), options = {};
  for (let at; (at = words.findIndex((word) => word.startsWith("--"))) >= 0;) {
    const [option, value] = words.splice(at, 2);
    options[option] = value;
  }
  const [program, engine, site] = words.map((word) => resolve(word));
  if (site === undefined || !existsSync(join(engine, "soarbox-engine.mjs")) || !existsSync(join(site, "index.html"))) {
    console.error("usage: node site.mjs SOARBOX ENGINE SITE [--runs N] [--only WORLD,...] [--in PLATFORM,...]");
    process.exit(2);
  }
  const runs = Number(options["--runs"] ?? 3), wanted = (name, option) => (options[option] ?? name).split(",").includes(name);
  const worlds = WORLDS.filter(({ name }) => wanted(name, "--only")), platforms = PLATFORMS.filter((name) => wanted(name, "--in"));
  const served = await serveSite(site), settings = { program, engine, address: served.address };
  const row = (title, cells) => console.log(`| ${[title, ...cells].join(" | ")} |`), told = (one) => console.error(JSON.stringify(one));
  row("", platforms);
  console.log(`| --- |${" ---: |".repeat(platforms.length)}`);
  for (const world of worlds) {
    const all = platforms.map(() => []);
    // One platform after the other in each round, so that other work on the machine affects all of them.
    for (let run = 0; run < runs; ++run) {
      for (const [i, platform] of platforms.entries()) {
        all[i].push(await measure(platform, world, settings));
        told({ world: world.name, platform, ...all[i].at(-1) });
      }
    }
    row(`${world.title}, ticks per second`, all.map((ours) => best(ours, (one) => one.ticks_per_s).toFixed(0)));
    row(`${world.title}, times real time`, all.map((ours) => best(ours, (one) => one.real_time).toFixed(1)));
    row(`${world.title}, memory`, all.map((ours) => MB(best(ours, (one) => one.bytes, Math.min))));
  }
  if (wanted("lesson", "--only")) {
    const all = [];
    for (const platform of platforms) {
      const ours = [];
      for (let run = 0; run < runs && platform !== "Node.js"; ++run) {
        const server = platform === "native" ? await startServer(settings) : null;
        ours.push(await firstPicture(platform === "Firefox" ? platform : "Chromium", server === null ? served.address : `${server.address}/`));
        told({ lesson: LESSON, platform, ...ours.at(-1) });
        server?.close();
      }
      all.push(ours);
    }
    row("first picture of a lesson", all.map((ours) => (ours.length === 0 ? "" : `${(best(ours, (one) => one.ms, Math.min) / 1000).toFixed(1)} s`)));
    row("the tab with the lesson, memory", all.map((ours) => (ours.length === 0 || ours[0].bytes === null ? "" : MB(best(ours, (one) => one.bytes, Math.min)))));
  }
  served.close();
  process.exit(0);
}

await (process.argv[2] === "--node" ? beNode(process.argv[3]) : main());
