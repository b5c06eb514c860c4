// SPDX-License-Identifier: BSD-2-Clause
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { Run } from "./run";
import type { Listener, Request, RunSource } from "./source";

class FakeSource implements RunSource {
  listener!: Listener;
  sent: Request[] = [];
  isOpen = true;
  start(listener: Listener): void {
    this.listener = listener;
    listener.connection("open");
  }
  send(request: Request): boolean {
    if (this.isOpen) this.sent.push(request);
    return this.isOpen;
  }
  retry(): void {}
  close(): void {}
}

const HELLO = { message: "hello", version: "1", what: "lesson:01-a-rule", scenario: "01-a-rule", seed: 1, agents: ["porter"], minds: ["porter"], step_s: 1 / 30, may_edit: true, is_recording: false } as const;

function started(): { run: Run; source: FakeSource } {
  const source = new FakeSource(), run = new Run(source);
  run.start();
  return { run, source };
}

test("contents accumulate, and a new run drops them", () => {
  const { run, source } = started();
  source.listener.message(HELLO);
  source.listener.message({ message: "contents", contents: { why: { question: "Why?", answer: null } } });
  source.listener.message({ message: "contents", contents: { messages: { messages: [] } } });
  assert.equal(run.contents.why!.question, "Why?");
  assert.deepEqual(run.contents.messages!.messages, []);
  source.listener.message(HELLO);
  assert.deepEqual(run.contents, {});
});

test("the visible panels are sent to each new run", () => {
  const { run, source } = started();
  run.look(["why", "mind"]);
  assert.equal(source.sent.length, 0);
  source.listener.message(HELLO);
  assert.deepEqual(source.sent[0], { request: "look", panels: ["mind", "why"] });
  run.look(["mind", "why", "why"]);
  assert.equal(source.sent.length, 1, "the same panels are not told twice");
  source.listener.message(HELLO);
  assert.deepEqual(source.sent.at(-1), { request: "look", panels: ["mind", "why"] });
});

test("a watching page sends only the visible panels, and says so for other requests", () => {
  const { run, source } = started(), remarks: string[] = [];
  run.on("remark", (remark) => remarks.push(remark.text));
  run.look(["why"]);
  source.listener.message({ ...HELLO, may_edit: false });
  run.look(["mind"]);
  assert.equal(run.ask("live"), false);
  assert.match(remarks[0]!, /only the learner/);
  assert.deepEqual(source.sent, [{ request: "look", panels: ["why"] }, { request: "look", panels: ["mind"] }]);
});

test("a request without a connection becomes a notice", () => {
  const { run, source } = started(), remarks: string[] = [];
  run.on("remark", (remark) => remarks.push(remark.text));
  source.isOpen = false;
  assert.equal(run.ask("live"), false);
  assert.match(remarks[0]!, /cannot be reached/);
});

test("a run requested without a connection is opened when the connection is back", () => {
  const { run, source } = started();
  source.listener.connection("lost");
  run.open("lesson:01-a-rule");
  assert.equal(source.sent.length, 0);
  source.listener.connection("open");
  assert.deepEqual(source.sent, [{ request: "open", what: "lesson:01-a-rule" }]);
  source.listener.message({ message: "none" });
  assert.equal(run.state, "joining");
  source.listener.message(HELLO);
  assert.equal(run.state, "running");
  source.listener.connection("open");
  assert.equal(source.sent.filter((one) => one.request === "open").length, 1, "a run that is there is joined, not begun again");
});

test("a world that cannot be opened leaves the run as it was", () => {
  const { run, source } = started();
  run.open("scenario:none");
  source.listener.message({ message: "error", error: "there is no such world", hint: "" });
  assert.equal(run.state, "none");
  source.listener.message(HELLO);
  run.open("scenario:none");
  source.listener.message({ message: "error", error: "there is no such world", hint: "" });
  assert.equal(run.state, "running");
  source.listener.connection("open");
  assert.equal(source.sent.filter((one) => one.request === "open").length, 2);
});

test("a run that ends says why", () => {
  const { run, source } = started();
  source.listener.message(HELLO);
  source.listener.message({ message: "busy" });
  assert.equal(run.state, "busy");
  source.listener.message({ message: "ended", text: "nobody looked", can_open_again: true });
  assert.equal(run.state, "ended");
  assert.equal(run.endedText, "nobody looked");
  source.listener.message({ message: "ready" });
  assert.equal(run.state, "ended");
});

test("blocks are decoded in order, and a bad one becomes a notice", async () => {
  const { run, source } = started(), ticks: number[] = [], remarks: string[] = [];
  const blocks = readFileSync("../tests/stream/scene_blocks.hex", "utf8").trim().split("\n").map((line) => Uint8Array.from(Buffer.from(line, "hex")));
  run.on("scene", (scene) => ticks.push(scene.tick));
  run.on("remark", (remark) => remarks.push(remark.text));
  source.listener.message(HELLO);
  source.listener.block(blocks[0]!);
  source.listener.block(blocks[1]!);
  source.listener.block(Uint8Array.from([9, 9, 9, 9]));
  source.listener.block(blocks[0]!);
  await new Promise((resolve) => setImmediate(resolve));
  for (let i = 0; i < 50 && ticks.length < 3; ++i) await new Promise((resolve) => setImmediate(resolve));
  assert.deepEqual(ticks, [300, 301, 300]);
  assert.equal(remarks.length, 1);
});
