// SPDX-License-Identifier: BSD-2-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import { deflateSync } from "node:zlib";
import { FileSource, lastUntil, type RecordedRun } from "./file_source";
import type { RunMessage } from "./source";

/** The document of the panel Trace with such lines. */
const traceOf = (...lines: readonly (readonly [number, string])[]): unknown =>
  ({ document: [{ is: "table", key: "lines", columns: [], rows: lines.map(([tick, text]) => ({ k: text, c: [[[tick]], text] })) }] });

const base64 = (bytes: readonly number[]): string => btoa(String.fromCharCode(...bytes));

function recorded(): RecordedRun {
  const contents = [
    { tick: 0, agent: "", name: "agents", content: { agents: ["early"] } },
    { tick: 0, agent: "a", name: "mind", content: { of: "a" } },
    { tick: 0, agent: "b", name: "mind", content: { of: "b" } },
    { tick: 20, agent: "", name: "agents", content: { agents: ["late"] } },
    { tick: 0, agent: "a", name: "imagery", content: { imagery: { note: "", scenes: [{ state: "S1", nodes: [], extracts: [{ values: [{ record: "R5", value: "1.4", lines: [{ from: [0, 0, 0], to: [1, 0, 0], is_crossed: false }] }] }] }] }, state: "", record: "" } },
    { tick: 10, agent: "", name: "timeline", content: { until: 10 } },
    { tick: 30, agent: "", name: "timeline", content: { until: 30 } },
    { tick: 30, agent: "", name: "trace", content: traceOf([4, "early"], [25, "late"]) },
  ];
  return {
    scenario: "yard", seed: 3, agents: ["a", "b"], minds: ["a", "b"], step_s: 1 / 30, first_tick: 0, last_tick: 30,
    scene: [0, 3, 6, 9, 12].map((tick, i) => ({ tick, full: i % 3 === 0, block: base64([tick]) })),
    contents: deflateSync(Buffer.from(JSON.stringify(contents))).toString("base64"),
  };
}

function listen(source: FileSource): { blocks: number[]; messages: RunMessage[]; content: (name: string) => unknown } {
  const heard = { blocks: [] as number[], messages: [] as RunMessage[], content: (name: string): unknown => {
    const found = heard.messages.filter((one) => one.message === "contents" && name in one.contents).at(-1);
    return found?.message === "contents" ? (found.contents as Record<string, unknown>)[name] : undefined;
  } };
  source.start({ message: (message) => heard.messages.push(message), block: (bytes) => heard.blocks.push(bytes[0]!), connection: () => undefined });
  return heard;
}

test("the last entry up to a tick is found", () => {
  const entries = [0, 3, 6].map((tick) => ({ tick }));
  assert.deepEqual([-1, 0, 2, 3, 5, 6, 99].map((tick) => lastUntil(entries, tick)), [0, 0, 0, 1, 1, 2, 2]);
});

test("a moment is decoded from the preceding full block, or from the current one", () => {
  const source = new FileSource(recorded()), heard = listen(source);
  assert.equal(heard.messages[0]!.message, "hello");
  assert.deepEqual(heard.blocks, [0]);
  source.send({ request: "seek", tick: 7 });
  assert.deepEqual(heard.blocks.splice(0), [0, 3, 6]);
  source.send({ request: "seek", tick: 12 });
  assert.deepEqual(heard.blocks.splice(0), [9, 12]);
  source.send({ request: "seek", tick: 4 });
  assert.deepEqual(heard.blocks.splice(0), [0, 3]);
  source.send({ request: "seek", tick: 5 });
  assert.deepEqual(heard.blocks.splice(0), []);
});

test("panels show the contents at the moment, for the selected agent", { timeout: 20_000 }, async () => {
  const source = new FileSource(recorded()), heard = listen(source);
  while (heard.content("agents") === undefined) await new Promise((done) => setTimeout(done, 5));
  assert.deepEqual(heard.content("agents"), { agents: ["early"] });
  assert.deepEqual(heard.content("mind"), { of: "a" });
  assert.deepEqual(heard.content("timeline"), { until: 10 }, "it tells of the past of its moment");
  source.send({ request: "select", agent: "b" });
  assert.deepEqual(heard.content("mind"), { of: "b" });
  source.send({ request: "seek", tick: 25 });
  assert.deepEqual(heard.content("agents"), { agents: ["late"] });
  assert.deepEqual(heard.content("timeline"), { until: 30 });
  assert.deepEqual(heard.content("trace"), traceOf([4, "early"], [25, "late"]));
  source.send({ request: "seek", tick: 24 });
  assert.deepEqual(heard.content("trace"), traceOf([4, "early"]), "nothing is told before it happens");
  source.send({ request: "edit", file: "x" });
  assert.equal(heard.messages.at(-1)!.message, "told");
});

test("an answer about what an agent imagines is drawn from what is recorded", { timeout: 20_000 }, async () => {
  const source = new FileSource(recorded()), heard = listen(source);
  while (heard.content("imagery") === undefined) await new Promise((done) => setTimeout(done, 5));
  source.send({ request: "imagine", state: "", record: "R5" });
  assert.deepEqual(heard.content("ghosts"), { ghosts: [], shapes: [], answer: { text: "1.4", lines: [{ from: [0, 0, 0], to: [1, 0, 0], is_crossed: false }] } });
  source.send({ request: "imagine", state: "", record: "" });
  assert.deepEqual(heard.content("ghosts"), { ghosts: [], shapes: [], answer: { text: "", lines: [] } });
  source.send({ request: "imagine", state: "S1", record: "" });
  assert.ok(heard.messages.some((one) => one.message === "told" && one.text.includes("whole scenes")));
});

test("it plays to its end, and then begins again", { timeout: 20_000 }, async () => {
  const source = new FileSource(recorded()), heard = listen(source);
  for (let i = 0; i < 6; i += 1) source.send({ request: "flow", what: "faster" });
  source.send({ request: "flow", what: "go-on" });
  const flow = (): { paused: boolean; tick: number } => heard.messages.filter((one) => one.message === "flow").at(-1) as never;
  assert.equal(flow().paused, false);
  while (!flow().paused || flow().tick < 30) await new Promise((done) => setTimeout(done, 5));
  source.send({ request: "flow", what: "go-on" });
  assert.equal(flow().paused, false);
  source.close();
});

test("a step of a game goes on to the end of a turn", () => {
  const source = new FileSource({ ...recorded(), turn_ticks: 10 }), heard = listen(source);
  const shown = (): unknown => heard.messages.filter((one) => one.message === "flow").map((one) => (one as { tick?: number }).tick).at(-1);
  source.send({ request: "flow", what: "step-turn" });
  assert.equal(shown(), 10);
  source.send({ request: "seek", tick: 13 });
  source.send({ request: "flow", what: "step-turn" });
  assert.equal(shown(), 20);
  source.send({ request: "flow", what: "step-turn" });
  source.send({ request: "flow", what: "step-turn" });
  assert.equal(shown(), 30, "no further than the recording");
});
