// SPDX-License-Identifier: BSD-2-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import type { RunMessage } from "../run/source";
import { EngineWorker, type EngineModule, type EngineSettings, type MakeEngine } from "./engine";
import type { Experiment, FromWorker, LoadedEngine, ToWorker } from "./messages";
import { LocalApi, LocalPlace, type Port } from "./worker_source";

const bytesOf = (text: string): Uint8Array => new TextEncoder().encode(text);

/** A module that runs one world, "scenario:field", and fails when it is asked to. */
class FakeEngine {
  readonly texts = new Map<number, string>();
  readonly files = new Map<string, Uint8Array>();
  taken: string[] = [];
  kept = 0;
  wait = 50;
  fails = false;
  private next = 8;
  graded = "";
  isGraded = false;
  private settings: EngineSettings | null = null;
  /** The error of storing, and saves that have not ended because of `holds`. */
  storeError: Error | null = null;
  holds = false;
  readonly held: ((error: unknown) => void)[] = [];
  status = 200;

  readonly make: MakeEngine = async (settings) => {
    this.settings = settings;
    return this.module;
  };
  startsGrading(): void {
    this.settings?.soarboxGrade?.("01-a-rule", "/soarbox/lessons");
  }
  stopsGrading(): void {
    this.settings?.soarboxStopGrading?.();
  }
  private text(text: string): number {
    this.next += 8;
    this.texts.set(this.next, text);
    return this.next;
  }
  private readonly module: EngineModule = {
    HEAPU8: new Uint8Array(4096),
    _malloc: () => 1024,
    _free: (address) => void this.texts.delete(address),
    stringToNewUTF8: (text) => this.text(text),
    UTF8ToString: (address) => this.texts.get(address) ?? "",
    _soarbox_open: (what) => {
      const name = this.texts.get(what);
      if (name === "scenario:broken") {
        this.settings?.soarboxFrame?.("e", bytesOf("there is no such body"));
        return this.text('{"error":"","hint":""}');
      }
      if (name !== "scenario:field") return this.text('{"error":"there is nothing","hint":"look"}');
      this.settings?.soarboxFrame?.("h", bytesOf('{"message":"hello","scenario":"field"}'));
      this.settings?.soarboxFrame?.("f", Uint8Array.of(1, 2));
      this.settings?.soarboxFrame?.("c", bytesOf('mission\0{"title":"Ä"}'));
      return 0;
    },
    _soarbox_step: () => {
      if (this.fails) throw new Error("unreachable");
      return this.wait;
    },
    _soarbox_take: (text) => void this.taken.push(this.texts.get(text) ?? ""),
    _soarbox_answer: (method, path, body, length) => {
      this.files.set("/answer", bytesOf(`${this.texts.get(method)} ${this.texts.get(path)} ${new TextDecoder().decode(this.module.HEAPU8.slice(body, body + length))}`));
      return this.text(`{"status":${this.status},"type":"text/plain","file":"/answer"}`);
    },
    _soarbox_grade: (lesson, from) => {
      this.settings?.print(`seed 1 of 1`);
      this.settings?.print(`Passed: ${this.texts.get(lesson)} of ${this.texts.get(from)}, with ${[...this.files.keys()].join()}`);
      this.files.set("/place/state/soarbox/learn/progress.json", bytesOf("{}"));
      return 0;
    },
    _soarbox_graded: (text, isOver) => {
      this.graded += this.texts.get(text);
      this.isGraded = isOver === 1;
    },
    FS: {
      readFile: (path) => this.files.get(path)!,
      writeFile: (path, bytes) => void this.files.set(path, bytes),
      readdir: (path) => [".", "..", ...new Set([...this.files.keys()].filter((file) => file.startsWith(`${path}/`)).map((file) => file.slice(path.length + 1).split("/")[0]!))],
      stat: (path) => ({ mode: this.files.has(path) ? 0 : 1 }),
      isDir: (mode) => mode === 1,
      unlink: (path) => void this.files.delete(path),
      mkdirTree: () => undefined,
      analyzePath: (path) => ({ exists: this.files.has(path) || [...this.files.keys()].some((file) => file.startsWith(`${path}/`)) }),
      filesystems: { IDBFS: {} },
      mount: () => undefined,
      syncfs: (fromBrowser, done) => {
        if (!fromBrowser) this.kept += 1;
        if (this.holds && !fromBrowser) this.held.push(done);
        else done(fromBrowser ? null : this.storeError);
      },
    },
  };
}

/** A page and its worker, without a thread between them. Timers do nothing until they are called. */
function pageWith(fake: FakeEngine, grader = new FakeEngine(), experiment?: Experiment, isOnly = true) {
  const timers: { call: () => void; ms: number; isOff: boolean }[] = [], ports: (Port & { isOver: boolean })[] = [];
  const makePort = (): Port => {
    const port: Port & { isOver: boolean } = { isOver: false, onmessage: null, onerror: null, postMessage: (message: ToWorker) => void worker.take(message), terminate: () => (port.isOver = true) };
    const engine = ports.length === 0 || ports.at(-1)!.isOver ? fake : grader;
    const worker = new EngineWorker({
      load: async () => ({ make: engine.make, loaded: {} as LoadedEngine }),
      say: (message: FromWorker) => port.onmessage?.({ data: message }),
      later: (call, ms) => {
        const timer = { call, ms, isOff: false };
        timers.push(timer);
        return () => (timer.isOff = true);
      },
    });
    ports.push(port);
    return port;
  };
  const place = new LocalPlace(makePort, "engine.mjs", true, experiment, isOnly), messages: RunMessage[] = [], blocks: Uint8Array[] = [], states: string[] = [];
  place.start({ message: (message) => messages.push(message), block: (block) => blocks.push(block), connection: (state) => states.push(state) });
  return { place, messages, blocks, states, timers, ports, settled: () => new Promise((resolve) => setTimeout(resolve, 5)) };
}

test("a page without a server gets the same messages as from a server", async () => {
  const fake = new FakeEngine(), page = pageWith(fake);
  await page.settled();
  assert.deepEqual(page.states, ["connecting", "open"]);
  assert.deepEqual(page.messages, [{ message: "tabs", may_type: true }, { message: "none" }]);
  page.messages.length = 0;
  page.place.send({ request: "open", what: "scenario:field" });
  await page.settled();
  assert.deepEqual(page.messages, [{ message: "hello", scenario: "field", what: "scenario:field" }, { message: "contents", contents: { mission: { title: "Ä" } } }]);
  assert.deepEqual([...page.blocks[0]!], [1, 2]);
  page.place.send({ request: "flow", what: "pause" });
  assert.deepEqual(fake.taken, ['{"request":"flow","what":"pause"}']);
  page.place.close();
});

test("an unknown world is refused, and a world that cannot begin reports why", async () => {
  const page = pageWith(new FakeEngine());
  await page.settled();
  page.messages.length = 0;
  page.place.send({ request: "open", what: "scenario:nowhere", id: 7 });
  await page.settled();
  assert.deepEqual(page.messages, [{ message: "error", error: "there is nothing", hint: "look", id: 7 }]);
  page.messages.length = 0;
  page.place.send({ request: "open", what: "scenario:broken" });
  await page.settled();
  assert.deepEqual(page.messages, [{ message: "ended", text: "there is no such body", can_open_again: true }]);
  page.place.close();
});

test("files are saved after requests that may have changed them, and only then", async () => {
  const fake = new FakeEngine(), page = pageWith(fake), fire = () => page.timers.filter(({ ms, isOff }) => ms === 1000 && !isOff).forEach((timer) => { timer.isOff = true; timer.call(); });
  await page.settled();
  page.place.send({ request: "open", what: "scenario:field" });
  await page.settled();
  fire();
  assert.equal(fake.kept, 1);
  page.place.send({ request: "look", panels: [] });
  fire();
  assert.equal(fake.kept, 1);
  page.place.send({ request: "edit-text", what: "save", text: "" });
  fire();
  assert.equal(fake.kept, 2);
  page.place.keepNow();
  assert.equal(fake.kept, 3);
  page.place.close();
});

test("changes are stored after five seconds at the latest, and refused requests store nothing", async () => {
  const fake = new FakeEngine(), page = pageWith(fake);
  await page.settled();
  fake.status = 400;
  await page.place.answer("PUT", "files/a.soar", bytesOf("x"));
  assert.deepEqual(page.timers, []);
  fake.status = 200;
  for (let i = 0; i < 4; ++i) await page.place.answer("PUT", "files/a.soar", bytesOf("x"));
  const left = page.timers.filter(({ isOff }) => !isOff);
  assert.deepEqual(left.map(({ ms }) => ms).sort(), [1000, 5000]);
  left.find(({ ms }) => ms === 5000)!.call();
  assert.deepEqual([fake.kept, page.timers.filter(({ ms, isOff }) => !isOff && ms === 1000).length], [1, 0]);
  page.place.close();
});

test("whoever waits for a save gets one that began afterwards, and its error", async () => {
  const fake = new FakeEngine(), page = pageWith(fake);
  await page.settled();
  page.messages.length = 0;
  fake.holds = true;
  page.place.keepNow();
  let isStored = false;
  const stored = page.place.store().then(() => (isStored = true));
  fake.held.shift()!(null);
  await page.settled();
  assert.deepEqual([isStored, fake.kept, page.messages.length], [false, 2, 0]);
  fake.held.shift()!(null);
  await stored;
  fake.holds = false;
  fake.storeError = new Error("no room");
  await assert.rejects(page.place.store(), /cannot keep your files: no room/);
  page.place.keepNow();
  const told = () => page.messages.filter(({ message }) => message === "told").map((one) => (one as { text: string }).text);
  assert.match(told().join("\n"), /^The browser cannot keep your files: no room\. Download your folder.*$/);
  fake.storeError = null;
  page.place.keepNow();
  assert.equal(told().at(-1), "The browser keeps your files again.");
  page.place.close();
});

test("a file is replaced only if it has the expected text, and that is not reported as a change", async () => {
  const fake = new FakeEngine(), page = pageWith(fake), { place } = page;
  let reported = 0;
  place.mayHaveChanged = () => void (reported += 1);
  await page.settled();
  fake.files.set("/place/home/worlds/a/b", bytesOf("x"));
  const status = async (path: string, was: Uint8Array | null): Promise<number> => (await place.replace(`worlds/a/${path}`, bytesOf("y"), was)).status;
  assert.deepEqual([await status("b", bytesOf("x")), await status("b", bytesOf("z")), await status("b", null), await status("c", null), await status("c", bytesOf("x"))], [200, 409, 409, 200, 409]);
  assert.equal(reported, 0);
  await place.answer("PUT", "files/worlds/a/b", bytesOf("y"));
  assert.equal(reported, 1);
  page.place.close();
});

test("a second tab reads the place, stores nothing, and says so", async () => {
  const fake = new FakeEngine(), page = pageWith(fake, undefined, undefined, false);
  await page.settled();
  assert.match(page.messages.map((one) => ("text" in one ? one.text : "")).join(), /Another tab shows your files already.*close one/);
  page.place.send({ request: "open", what: "scenario:field" });
  page.place.keepNow();
  await page.place.store();
  assert.equal(fake.kept, 0);
  page.place.close();
});

test("files beside a run are written and removed, but not for a worker that has crashed", async () => {
  const fake = new FakeEngine(), page = pageWith(fake), start = page.place.startCount, path = "/place/state/folders/a/b";
  await page.settled();
  await page.place.write([{ path, bytes: bytesOf("x") }], [], start);
  assert.equal(fake.files.has(path), true);
  await page.place.write([], [path], start);
  assert.equal(fake.files.has(path), false);
  fake.fails = true;
  page.place.send({ request: "open", what: "scenario:field" });
  await page.settled();
  await assert.rejects(page.place.write([{ path, bytes: bytesOf("x") }], [], start));
  await page.place.answer("GET", "", new Uint8Array());
  await assert.rejects(page.place.write([{ path, bytes: bytesOf("x") }], [], start), /crashed/);
  page.place.close();
});

test("a run that crashes ends, and opening it again starts another worker", async () => {
  const fake = new FakeEngine(), page = pageWith(fake);
  await page.settled();
  page.place.send({ request: "open", what: "scenario:field" });
  await page.settled();
  fake.fails = true;
  page.place.send({ request: "flow", what: "go-on" });
  await page.settled();
  assert.equal(page.ports[0]!.isOver, true);
  assert.match((page.messages.at(-1) as { text: string }).text, /crashed.*unreachable/);
  fake.fails = false;
  page.messages.length = 0;
  page.place.send({ request: "open", what: "scenario:field" });
  await page.settled();
  assert.equal(page.ports.length, 2);
  assert.ok(page.messages.some(({ message }) => message === "hello"));
  page.place.close();
});

test("another worker grades with the learner's files, and returns the progress", async () => {
  const fake = new FakeEngine(), grader = new FakeEngine(), page = pageWith(fake, grader);
  await page.settled();
  fake.files.set("/place/home/soarbox-lessons/01-a-rule/porter.soar", bytesOf("sp {}"));
  fake.files.set("/place/state/soarbox/recordings/run.soarrec", bytesOf("long"));
  page.place.send({ request: "open", what: "scenario:field" });
  fake.startsGrading();
  await page.settled();
  assert.equal(fake.graded, "seed 1 of 1\nPassed: 01-a-rule of /soarbox/lessons, with /place/home/soarbox-lessons/01-a-rule/porter.soar\n");
  assert.equal(fake.isGraded, true);
  assert.equal(new TextDecoder().decode(fake.files.get("/place/state/soarbox/learn/progress.json")), "{}");
  assert.deepEqual(page.ports.map(({ isOver }) => isOver), [false, true]);
  page.place.close();
});

test("grading that is cancelled ends its worker, and the run goes on", async () => {
  const fake = new FakeEngine(), grader = new FakeEngine(), page = pageWith(fake, grader);
  await page.settled();
  page.place.send({ request: "open", what: "scenario:field" });
  fake.startsGrading();
  fake.stopsGrading();
  await page.settled();
  assert.deepEqual(page.ports.map(({ isOver }) => isOver), [false, true]);
  assert.equal(fake.graded, "");
  page.place.close();
});

test("the place answers the same requests as a server", async () => {
  const page = pageWith(new FakeEngine()), api = new LocalApi(page.place);
  const response = await api.fetch("/api/p/local/files/a.soar", { method: "PUT", body: "sp {}" });
  assert.equal(await response.text(), "PUT files/a.soar sp {}");
  assert.equal(await (await api.fetch("/api/p/local")).text(), "GET  ");
  assert.equal(await (await api.fetch("/api/p/local/files/my%20rules.soar")).text(), "GET files/my rules.soar ", "names are decoded, as a server does");
  page.place.close();
});

/** An engine with a world and a lesson of the program. */
function withShipped(fake: FakeEngine): FakeEngine {
  for (const [path, text] of [["scenarios/field/scenario.toml", "world"], ["scenarios/field/hare.soar", "hare"], ["scenarios/field/maps/hill.png", "\0"],
    ["lessons/tanks/t1/lesson.toml", "task"], ["lessons/tanks/t1/tank.soar", "tank"], ["lessons/tanks/t1/solution/tank.soar", "solved"]] as const) fake.files.set(`/soarbox/${path}`, bytesOf(text));
  return fake;
}

test("what the user has changed in a world or a lesson is told, and nothing else", async () => {
  const fake = withShipped(new FakeEngine()), page = pageWith(fake), api = new LocalApi(page.place), put = (path: string, text: string) => fake.files.set(`/place/home/${path}`, bytesOf(text));
  assert.deepEqual(await api.changedFiles("scenario:field"), { folder: "/place/home/worlds/field/", files: {}, leftOut: [] });
  put("worlds/field/scenario.toml", "world");
  put("worlds/field/hare.soar", "other hare");
  put("worlds/field/rules/more.soar", "more");
  fake.files.set("/place/home/worlds/field/photo.png", Uint8Array.of(0xff, 0xfe));
  put("worlds/mine/scenario.toml", "my world");
  put("soarbox-lessons/t1/tank.soar", "my tank");
  assert.deepEqual(await api.changedFiles("scenario:field"), { folder: "/place/home/worlds/field/", files: { "hare.soar": "other hare", "rules/more.soar": "more" }, leftOut: ["photo.png"] });
  assert.deepEqual((await api.changedFiles("scenario:mine"))?.files, { "scenario.toml": "my world" });
  assert.deepEqual(await api.changedFiles("lesson:t1"), { folder: "/place/home/soarbox-lessons/t1/", files: { "tank.soar": "my tank" }, leftOut: [] });
  for (const what of ["lesson:t9", "recording:a", "scenario:..", "scenario:a/b"]) assert.deepEqual((await api.changedFiles(what))?.files, {}, what);
  page.place.close();
});

test("the experiment of a link has the program's files and its own, in a place that is not kept", async () => {
  const fake = withShipped(new FakeEngine()), page = pageWith(fake, undefined, { what: "scenario:field", files: { "hare.soar": "other hare" } }), text = (path: string) => new TextDecoder().decode(fake.files.get(path));
  await page.settled();
  assert.equal(text("/place/home/worlds/field/hare.soar"), "other hare");
  assert.equal(text("/place/home/worlds/field/scenario.toml"), "world");
  assert.ok(fake.files.has("/place/home/worlds/field/maps/hill.png"));
  page.place.send({ request: "open", what: "scenario:field" });
  await page.settled();
  page.place.keepNow();
  assert.equal(fake.kept, 0);
  assert.deepEqual(page.messages.filter(({ message }) => message === "told"), []);
  page.place.close();

  const lesson = withShipped(new FakeEngine()), another = pageWith(lesson, undefined, { what: "lesson:t1", files: { "tank.soar": "my tank" } });
  await another.settled();
  assert.deepEqual([...lesson.files.keys()].filter((path) => path.startsWith("/place/")), ["/place/home/soarbox-lessons/t1/tank.soar"]);
  another.place.close();
});
