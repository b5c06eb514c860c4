// SPDX-License-Identifier: BSD-2-Clause
// Only one tab may store the files of the place in this browser: each stores its own copy of all files over those of the others.

/** The parts of the browser that are used; tests give their own. */
export interface LockSurroundings {
  /** navigator.locks; null: the browser has none for this page, for example without TLS. */
  readonly locks: { request(name: string, options: { signal: AbortSignal }, call: () => Promise<void>): Promise<void> } | null;
  /** A BroadcastChannel; null: the browser has none. */
  makeChannel(name: string): { postMessage(message: unknown): void; onmessage: ((event: { data: unknown }) => void) | null } | null;
}

const NAME = "soarbox-place";
/** After a reload, the page from before has the lock for a moment. */
const WAITS_MS = 800;
/** Other tabs answer a question within this time. */
const ANSWERS_WITHIN_MS = 300;

const ofBrowser: LockSurroundings = {
  get locks() {
    return (navigator as { locks?: LockManager }).locks ?? null;
  },
  makeChannel: (name) => ("BroadcastChannel" in globalThis ? (new BroadcastChannel(name) as unknown as ReturnType<LockSurroundings["makeChannel"]>) : null),
};

/** Takes the lock for as long as the page exists. Returns false if another tab has it. */
export async function takePlaceLock({ locks, makeChannel }: LockSurroundings = ofBrowser, waits = WAITS_MS): Promise<boolean> {
  if (locks !== null) {
    try {
      return await takeLock(locks, waits);
    } catch {
      // Some browsers refuse locks to a page that was opened from the disk.
    }
  }
  try {
    const channel = makeChannel(NAME);
    return channel === null || (await ask(channel, Math.min(waits, ANSWERS_WITHIN_MS)));
  } catch {
    return true;
  }
}

async function takeLock(locks: NonNullable<LockSurroundings["locks"]>, waits: number): Promise<boolean> {
  const ending = new AbortController();
  return new Promise((done, failed) => {
    const timer = setTimeout(() => ending.abort(), waits);
    const end = (): void => clearTimeout(timer);
    // The lock is released when the page ends, because the inner promise never settles.
    locks.request(NAME, { signal: ending.signal }, async () => {
      end();
      done(true);
      return new Promise<void>(() => undefined);
    }).catch((error: unknown) => {
      end();
      if ((error as { name?: string }).name === "AbortError") done(false);
      else failed(error);
    });
  });
}

/** Asks the other tabs. Of tabs that ask at the same time, the one with the smallest number gets the place. */
async function ask(channel: NonNullable<ReturnType<LockSurroundings["makeChannel"]>>, waits: number): Promise<boolean> {
  const me = Math.random();
  let isMine: boolean | null = null;
  channel.onmessage = ({ data }) => {
    const { asks, answers } = data as { asks?: number; answers?: number };
    if (answers === me) isMine ??= false;
    if (asks !== undefined && isMine !== false && (isMine === true || me < asks)) channel.postMessage({ answers: asks });
  };
  channel.postMessage({ asks: me });
  await new Promise((done) => setTimeout(done, waits));
  // onmessage may have set it.
  return (isMine as boolean | null) === null ? (isMine = true) : false;
}
