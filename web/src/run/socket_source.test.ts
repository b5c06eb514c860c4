// SPDX-License-Identifier: BSD-2-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import { pauseBefore, readMessage, SocketSource, type Socket, type Surroundings } from "./socket_source";
import type { Connection, RunMessage } from "./source";

class FakeSocket implements Socket {
  binaryType = "";
  readyState = 0;
  onopen: (() => void) | null = null;
  onclose: ((event: { code: number; reason: string }) => void) | null = null;
  onmessage: ((event: { data: unknown }) => void) | null = null;
  sent: string[] = [];
  constructor(readonly url: string, readonly protocols: string[]) {}
  send(text: string): void {
    this.sent.push(text);
  }
  close(): void {
    this.readyState = 3;
  }
  opens(): void {
    this.readyState = 1;
    this.onopen?.();
  }
  breaks(code = 1006, reason = ""): void {
    this.readyState = 3;
    this.onclose?.({ code, reason });
  }
}

function surroundings(): Surroundings & { sockets: FakeSocket[]; waits: { call: () => void; ms: number; stopped: boolean }[] } {
  const sockets: FakeSocket[] = [], waits: { call: () => void; ms: number; stopped: boolean }[] = [];
  return {
    sockets, waits, now: () => 1000,
    open: (url, protocols) => {
      sockets.push(new FakeSocket(url, protocols));
      return sockets.at(-1)!;
    },
    later: (call, ms) => {
      const wait = { call, ms, stopped: false };
      waits.push(wait);
      return () => (wait.stopped = true);
    },
  };
}

function listen(): { messages: RunMessage[]; blocks: Uint8Array[]; states: Connection[]; message(m: RunMessage): void; block(b: Uint8Array): void; connection(s: Connection): void } {
  const messages: RunMessage[] = [], blocks: Uint8Array[] = [], states: Connection[] = [];
  return { messages, blocks, states, message: (m) => messages.push(m), block: (b) => blocks.push(b), connection: (s) => states.push(s) };
}

test("pauses between tries grow up to a maximum", () => {
  assert.deepEqual([1, 2, 3, 4, 5, 6, 7, 40].map(pauseBefore), [500, 1000, 2000, 4000, 8000, 15000, 15000, 15000]);
});

test("a lost connection is retried, and the token is the subprotocol", () => {
  const world = surroundings(), listener = listen(), source = new SocketSource("ws://host/run", "secret", world);
  source.start(listener);
  assert.deepEqual(world.sockets[0]!.protocols, ["soarbox.secret"]);
  assert.equal(source.send({ request: "live" }), false);
  world.sockets[0]!.opens();
  assert.equal(source.send({ request: "live" }), true);
  assert.deepEqual(world.sockets[0]!.sent, ['{"request":"live"}']);
  world.sockets[0]!.breaks();
  assert.equal(source.send({ request: "live" }), false);
  assert.equal(world.waits[0]!.ms, 500);
  world.waits[0]!.call();
  world.sockets[1]!.breaks();
  assert.equal(world.waits[1]!.ms, 1000);
  world.waits[1]!.call();
  world.sockets[2]!.opens();
  world.sockets[2]!.breaks();
  assert.equal(world.waits[2]!.ms, 500, "a connection that was open begins with the short pause again");
  assert.deepEqual(listener.states.slice(0, 3), ["connecting", "open", "lost"]);
});

test("an immediate try does not wait, and a closed source does not try again", () => {
  const world = surroundings(), source = new SocketSource("ws://host/run", "", world);
  source.start(listen());
  world.sockets[0]!.breaks();
  source.retry();
  assert.equal(world.waits[0]!.stopped, true);
  assert.equal(world.sockets.length, 2);
  source.close();
  world.sockets[1]!.breaks();
  assert.equal(world.waits.length, 1);
});

test("a refusal is reported and not retried", () => {
  const world = surroundings(), listener = listen(), source = new SocketSource("ws://host/run", "", world);
  source.start(listener);
  world.sockets[0]!.opens();
  world.sockets[0]!.breaks(1008, "too many worlds");
  assert.deepEqual(listener.messages, [{ message: "ended", text: "too many worlds", can_open_again: false }]);
  assert.equal(world.waits.length, 0);
});

test("bytes are blocks, texts are messages, and other data is skipped", () => {
  const world = surroundings(), listener = listen();
  new SocketSource("ws://host/run", "", world).start(listener);
  const socket = world.sockets[0]!;
  socket.onmessage?.({ data: Uint8Array.from([1, 2]).buffer });
  socket.onmessage?.({ data: '{"message":"none"}' });
  socket.onmessage?.({ data: "{" });
  socket.onmessage?.({ data: "[1]" });
  assert.deepEqual([...listener.blocks[0]!], [1, 2]);
  assert.deepEqual(listener.messages, [{ message: "none" }]);
  assert.equal(readMessage("null"), null);
});
