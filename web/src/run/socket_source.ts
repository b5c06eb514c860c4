// SPDX-License-Identifier: BSD-2-Clause
import type { Listener, Request, RunMessage, RunSource } from "./source";

const FIRST_PAUSE_MS = 500, LONGEST_PAUSE_MS = 15_000;
const NO_RETRY_CODE = 1008;

/** The parts of a WebSocket that are used; tests give their own. */
export interface Socket {
  binaryType: string;
  readyState: number;
  onopen: (() => void) | null;
  onclose: ((event: { code: number; reason: string }) => void) | null;
  onmessage: ((event: { data: unknown }) => void) | null;
  send(text: string): void;
  close(): void;
}
export interface Surroundings {
  open(url: string, protocols: string[]): Socket;
  later(call: () => void, ms: number): () => void;
  now(): number;
}

const BROWSER: Surroundings = {
  open: (url, protocols) => new WebSocket(url, protocols) as unknown as Socket,
  later: (call, ms) => {
    const timer = setTimeout(call, ms);
    return () => clearTimeout(timer);
  },
  now: () => Date.now(),
};

/** How long to wait before try number `tries`, counted from 1: twice as long each time. */
export function pauseBefore(tries: number): number {
  return Math.min(FIRST_PAUSE_MS * 2 ** (tries - 1), LONGEST_PAUSE_MS);
}

/** Reads a text message; null if it is none. */
export function readMessage(text: string): RunMessage | null {
  try {
    const value: unknown = JSON.parse(text);
    if (typeof value !== "object" || value === null || typeof (value as { message?: unknown }).message !== "string") return null;
    return value as RunMessage;
  } catch {
    return null;
  }
}

/** A run on a server. Connects again when the connection is lost, with growing pauses, until it is closed. */
export class SocketSource implements RunSource {
  private socket: Socket | null = null;
  private listener: Listener | null = null;
  private tries = 0;
  private stopWaiting: (() => void) | null = null;
  private closed = false;

  constructor(private readonly url: string, private readonly token: string, private readonly world: Surroundings = BROWSER) {}

  start(listener: Listener): void {
    this.listener = listener;
    this.connect();
  }

  send(request: Request): boolean {
    if (this.socket?.readyState !== 1) return false;
    this.socket.send(JSON.stringify(request));
    return true;
  }

  retry(): void {
    if (this.stopWaiting === null) return;
    this.stopWaiting();
    this.connect();
  }

  close(): void {
    this.closed = true;
    this.stopWaiting?.();
    this.socket?.close();
    this.listener?.connection("closed");
  }

  private connect(): void {
    this.stopWaiting = null;
    this.listener?.connection("connecting");
    const socket = this.world.open(this.url, this.token === "" ? [] : [`soarbox.${this.token}`]);
    this.socket = socket;
    socket.binaryType = "arraybuffer";
    socket.onopen = () => {
      this.tries = 0;
      this.listener?.connection("open");
    };
    socket.onmessage = ({ data }) => {
      if (socket !== this.socket) return;
      if (data instanceof ArrayBuffer) this.listener?.block(new Uint8Array(data));
      else if (typeof data === "string") {
        const message = readMessage(data);
        if (message !== null) this.listener?.message(message);
      }
    };
    socket.onclose = ({ code, reason }) => {
      if (socket !== this.socket || this.closed) return;
      this.socket = null;
      if (code === NO_RETRY_CODE) {
        this.listener?.message({ message: "ended", text: reason === "" ? "The server refused this page." : reason, can_open_again: false });
        this.listener?.connection("closed");
        return;
      }
      this.tries += 1;
      const pause = pauseBefore(this.tries);
      this.listener?.connection("lost", this.world.now() + pause);
      this.stopWaiting = this.world.later(() => this.connect(), pause);
    };
  }
}
