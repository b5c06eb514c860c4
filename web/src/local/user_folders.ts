// SPDX-License-Identifier: BSD-2-Clause
import { Refused } from "../app/api";
import type { FolderStore, KeptFolder } from "./folder_store";
import { areEqual, FolderProblem, FolderReader, problemOf, stepsFor, type Files, type FolderHandle, type Steps } from "./folder_sync";

/** The copy of a folder in the place. */
export interface FolderCopy {
  readonly files: Files;
  /** The files that disk and place had when they were equal. It is stored together with `files`, so that both are of the same moment. */
  readonly base: Files;
}

/** The place that has copies of the folders. */
export interface CopyPlace {
  read(world: string): Promise<FolderCopy>;
  /** `path`: "WORLD/FILE". `bytes`: null removes the file. Returns false, and writes nothing, if its text is no longer `was` (null: none). */
  write(path: string, bytes: Uint8Array | null, was: Uint8Array | null): Promise<boolean>;
  /** Changes the base of a world; null: a file is removed from it. */
  writeBase(world: string, changes: ReadonlyMap<string, Uint8Array | null>): Promise<void>;
  /** Stores all changes in the browser. */
  store(): Promise<void>;
}

/** Parts of the browser; tests give their own. */
export interface FolderSurroundings {
  /** Asks the user for a folder. */
  pick(): Promise<FolderHandle>;
  store: FolderStore;
  place: CopyPlace;
  later(call: () => void, ms: number): () => void;
  isVisible(): boolean;
  /** Whether no other tab has the place. Only then may its copies be changed. */
  readonly isOnly: boolean;
  /** Asks the user a question; returns whether the answer is yes. */
  ask(question: string): boolean;
}

export interface FolderEvents {
  /** Something that a view shows has changed. */
  changed(): void;
  say(text: string, hint: string, isError: boolean): void;
}

/** "off": the browser has to be asked first. */
export type FolderState = "off" | "connected" | "trouble";

const LOOKS_EVERY_MS = 2000, WRITES_AFTER_MS = 300;
/** Maximum number of files that a question names. */
const MOST_NAMED = 10;
const WORLD_FILES = ["scenario.toml", "Sandbox.lua"];

/** The folder that is connected. */
interface OpenFolder {
  readonly name: string;
  readonly title: string;
  readonly reader: FolderReader;
  /** Files of the place may have changed since the last look. */
  isChanged: boolean;
  /** Files that disk or place have refused, with the texts of both. They are tried again when one of these texts changes. */
  refused: ReadonlyMap<string, Refusal>;
  /** Why the browser could not store the place; null: it could. undefined: nothing was stored yet. */
  unstored: FolderProblem | null | undefined;
}
interface Refusal {
  readonly there: Uint8Array | undefined;
  readonly here: Uint8Array | undefined;
  readonly problem: FolderProblem;
}
/** What execute() has done: files that are equal now, problems, and the names of files with the user's version. */
interface Outcome {
  readonly done: ReadonlySet<string>;
  readonly refused: ReadonlyMap<string, Refusal>;
  /** The first problem that may end without a change of a file. */
  readonly passing: FolderProblem | null;
  readonly mine: ReadonlyMap<string, string>;
}

const anotherTab = (): FolderProblem => new FolderProblem("Another tab shows your files already, so this one connects no folder.", "Continue in the other tab; or close it, and reload this one.");

/** An error of the disk or of the place in words. */
function problemWith(error: unknown, what: string, folder: string): FolderProblem {
  return error instanceof Refused ? new FolderProblem(error.message, error.hint) : problemOf(error, what, folder);
}

/** The name of a world for a folder. `taken`: names that other worlds have. */
export function worldName(folder: string, taken: ReadonlySet<string>): string {
  const plain = folder.normalize("NFKD").replaceAll(/\p{M}/gu, "").replaceAll(/[^\w.-]+/g, "-").replace(/^[.-]+/, "").slice(0, 60) || "folder";
  let name = plain;
  for (let i = 2; taken.has(name); ++i) name = `${plain}-${i}`;
  return name;
}

/**
 * Folders of the user's disk whose worlds are opened here. The engine works with copies in the place. While a folder is
 * connected, saved edits are written to it, and changes of other programs are read from it.
 */
export class UserFolders {
  private folders: KeptFolder[] = [];
  private events: FolderEvents = { changed: () => undefined, say: () => undefined };
  private open: OpenFolder | null = null;
  /** The world whose folder is being connected, and a number that each such call increases. */
  private connecting = "";
  private turn = 0;
  private trouble: { readonly name: string; readonly problem: FolderProblem } | null = null;
  private stopWaiting: (() => void) | null = null;
  /** Only one thing at a time reads or writes. */
  private last: Promise<void> = Promise.resolve();

  constructor(private readonly around: FolderSurroundings) {}

  /** Reads which folders the browser remembers. */
  async start(events: FolderEvents): Promise<void> {
    this.events = events;
    this.folders = await this.around.store.all().catch(() => []);
    events.changed();
  }

  get all(): readonly { name: string; title: string }[] {
    return this.folders.map(({ name, handle }) => ({ name, title: handle.name }));
  }

  /** The state of a world's folder; null: the world has none. */
  stateOf(world: string): { title: string; state: FolderState; problem: FolderProblem | null } | null {
    const found = this.folders.find((one) => one.name === world);
    if (found === undefined) return null;
    const problem = this.trouble?.name === world ? this.trouble.problem : null;
    return { title: found.handle.name, problem, state: problem !== null ? "trouble" : this.open?.name === world ? "connected" : "off" };
  }

  /** Lets the user choose a folder. Returns the name of its world, or null if the user chose none or it cannot be used. `taken`: names of worlds. */
  async choose(taken: readonly string[]): Promise<string | null> {
    if (!this.around.isOnly) {
      this.tell(anotherTab());
      return null;
    }
    let handle: FolderHandle;
    try {
      handle = await this.around.pick();
    } catch (error) {
      if ((error as { name?: string }).name !== "AbortError") this.tell(problemOf(error, "The folder", "The folder"));
      return null;
    }
    try {
      for (const one of this.folders) if (await one.handle.isSameEntry(handle)) return (await this.connect(one.name, true)) ? one.name : null;
      const reader = new FolderReader(handle), files = await reader.read();
      for (const name of WORLD_FILES) if (reader.unreadable.has(name)) throw reader.unreadable.get(name);
      if (!WORLD_FILES.some((name) => files.has(name))) throw new FolderProblem(`${handle.name} is not the folder of a world: it has neither ${WORLD_FILES.join(" nor ")}.`, "Choose the folder in which one of them is.");
      const name = worldName(handle.name, new Set([...taken, ...this.folders.map((one) => one.name)])), folder = { name, handle };
      await this.around.store.put(folder);
      this.folders = [...this.folders, folder];
      return (await this.connect(name, true)) ? name : null;
    } catch (error) {
      this.tell(problemOf(error, handle.name, handle.name));
      return null;
    }
  }

  /**
   * Connects the folder of a world, and makes copy and folder equal. `mayAsk`: the user has pressed a button, so the browser may ask for
   * permission. Returns whether the place has a copy, so that the world can be opened.
   */
  async connect(world: string, mayAsk: boolean): Promise<boolean> {
    const folder = this.folders.find((one) => one.name === world);
    if (folder === undefined) return false;
    const turn = ++this.turn, title = folder.handle.name;
    this.connecting = world;
    let problem: FolderProblem | null = null, permission: PermissionState = "denied";
    try {
      if (!this.around.isOnly) throw anotherTab();
      permission = await folder.handle.queryPermission({ mode: "readwrite" });
      if (permission !== "granted" && mayAsk) {
        permission = await folder.handle.requestPermission({ mode: "readwrite" });
        if (permission !== "granted") throw problemOf({ name: "NotAllowedError" }, title, title);
      }
    } catch (error) {
      problem = problemOf(error, title, title);
    }
    await this.flush();
    // Meanwhile the user may have opened another world.
    if (turn === this.turn) {
      this.disconnect();
      if (problem !== null) this.fail(world, problem);
      else if (permission === "granted") {
        this.open = { name: world, title, reader: new FolderReader(folder.handle), isChanged: false, refused: new Map(), unstored: undefined };
        await this.sync(false);
      }
      if (turn === this.turn) this.connecting = "";
      this.events.changed();
    }
    return this.hasCopy(world);
  }

  /** The world that is shown now; "": none. Connects its folder if the browser allows it without asking. */
  show(world: string): void {
    if (world === this.open?.name || (world !== "" && (world === this.connecting || world === this.trouble?.name))) return;
    if (this.folders.some((one) => one.name === world)) void this.connect(world, false);
    else void this.leave();
  }

  /** Forgets a folder and removes its copy. Asks first if the copy has edits that the disk lacks. */
  async forget(world: string): Promise<void> {
    const folder = this.folders.find((one) => one.name === world);
    if (folder === undefined) return;
    if (!this.around.isOnly) return this.tell(anotherTab());
    if (this.open?.name === world) await this.sync(false);
    await this.last;
    const { files, base } = await this.around.place.read(world), unwritten = [...files].filter(([path, bytes]) => !areEqual(bytes, base.get(path))).map(([path]) => path).sort();
    const named = unwritten.slice(0, MOST_NAMED).join(", "), more = unwritten.length - MOST_NAMED;
    if (unwritten.length > 0 && !this.around.ask(`The folder ${folder.handle.name} on the disk lacks what you changed here in ${named}${more > 0 ? ` and ${more} more` : ""}. Forget the folder and lose these changes?`)) return;
    if (this.open?.name === world || this.trouble?.name === world) this.disconnect();
    await this.last;
    this.folders = this.folders.filter((one) => one.name !== world);
    await this.around.store.remove(world);
    for (const [path, bytes] of files) await this.around.place.write(`${world}/${path}`, null, bytes);
    await this.around.place.writeBase(world, new Map([...base.keys()].map((path) => [path, null])));
    this.events.changed();
  }

  /** Files of the place may have changed: writes them to the folder soon. */
  placeChanged(): void {
    if (this.open === null) return;
    this.open.isChanged = true;
    this.lookIn(WRITES_AFTER_MS);
  }

  /** The page is shown again, or about to be hidden. */
  lookNow(): void {
    if (this.open !== null) this.lookIn(0);
  }

  private async hasCopy(world: string): Promise<boolean> {
    try {
      const { files } = await this.around.place.read(world);
      return WORLD_FILES.some((name) => files.has(name));
    } catch {
      return false;
    }
  }

  /** Writes what waits to be written, and waits for a running look. */
  private async flush(): Promise<void> {
    if (this.open?.isChanged === true) await this.sync(false);
    else await this.last;
  }

  private async leave(): Promise<void> {
    const turn = ++this.turn;
    this.connecting = "";
    await this.flush();
    if (turn === this.turn) this.disconnect();
  }

  private disconnect(): void {
    this.stopWaiting?.();
    this.stopWaiting = null;
    this.open = null;
    this.trouble = null;
  }

  private lookIn(ms: number): void {
    this.stopWaiting?.();
    this.stopWaiting = this.around.later(() => void this.sync(true), ms);
  }

  /** Makes folder and copy equal, and does so again later. `tells`: shows a message about files that another program has changed. */
  private sync(tells: boolean): Promise<void> {
    const next = this.last.then(() => this.syncOnce(tells));
    this.last = next;
    return next;
  }

  private async syncOnce(tells: boolean): Promise<void> {
    const { open } = this;
    if (open === null) return;
    this.stopWaiting?.();
    this.stopWaiting = null;
    open.isChanged = false;
    try {
      const disk = await open.reader.read(), copy = await this.around.place.read(open.name), { unreadable } = open.reader;
      const steps = stepsFor(copy.base, disk, copy.files, unreadable);
      if (this.open !== open) return;
      const outcome = await this.execute(steps, disk, copy.files, open);
      open.refused = outcome.refused;
      await this.keep(open, steps, disk, copy, outcome);
      for (const [path, mine] of outcome.mine) this.events.say(`${path} was changed here and by another program. The run uses the other program's text.`, `Your text is in ${mine}, in your folder.`, true);
      const read = [...steps.toPlace.keys()].filter((path) => !steps.both.has(path) && outcome.done.has(path));
      if (tells && read.length > 0) this.events.say(`Another program has changed ${read.length > 3 ? `${read.length} files` : read.join(", ")} in ${open.title}.`, "", false);
      const [refusal] = outcome.refused.values(), [unread] = unreadable.values(), problem = refusal?.problem ?? outcome.passing ?? unread ?? open.unstored ?? null;
      if (problem !== null) throw problem;
      if (this.trouble !== null) {
        this.trouble = null;
        this.events.changed();
      }
    } catch (error) {
      if (this.open === open) this.fail(open.name, problemWith(error, open.title, open.title));
    }
    // Meanwhile another look may have been scheduled.
    if (this.open === open && this.stopWaiting === null) this.lookAgain();
  }

  /** Writes files to the folder and to the place. */
  private async execute({ toDisk, toPlace, both }: Steps, disk: Files, copy: Files, open: OpenFolder): Promise<Outcome> {
    const done = new Set<string>(), refused = new Map<string, Refusal>(), mine = new Map<string, string>(), { place } = this.around;
    let passing: FolderProblem | null = null;
    const attempt = async (path: string, call: () => Promise<boolean>): Promise<void> => {
      const there = disk.get(path), here = copy.get(path), before = open.refused.get(path);
      if (before !== undefined && areEqual(before.there, there) && areEqual(before.here, here)) {
        refused.set(path, before);
        return;
      }
      try {
        if (await call()) done.add(path);
      } catch (error) {
        const isOfPlace = error instanceof Refused;
        // An engine that has crashed may have another answer the next time.
        if (isOfPlace && error.status >= 500) passing ??= problemWith(error, path, open.title);
        else refused.set(path, { there, here, problem: isOfPlace ? new FolderProblem(`${path} cannot be used here: ${error.message}`, error.hint) : problemOf(error, path, open.title) });
      }
    };
    for (const [path, bytes] of toDisk) await attempt(path, () => open.reader.write(path, bytes));
    for (const [path, bytes] of toPlace) {
      await attempt(path, async () => {
        const own = both.get(path);
        // The place keeps its text if the disk refuses it under another name.
        const name = own === undefined ? "" : await open.reader.writeMine(path, own);
        const isWritten = await place.write(`${open.name}/${path}`, bytes, copy.get(path) ?? null);
        if (isWritten && name !== "") mine.set(path, name);
        return isWritten;
      });
    }
    return { done, refused, passing, mine };
  }

  private lookAgain(): void {
    this.stopWaiting = this.around.later(() => (this.around.isVisible() ? void this.sync(true) : this.lookAgain()), LOOKS_EVERY_MS);
  }

  /** Changes the base where disk and place are equal now, and stores it with the files. */
  private async keep(open: OpenFolder, { toDisk, toPlace }: Steps, disk: Files, { files, base }: FolderCopy, { done }: Outcome): Promise<void> {
    const changes = new Map<string, Uint8Array | null>();
    for (const path of new Set([...base.keys(), ...disk.keys(), ...files.keys()])) {
      const there = disk.get(path);
      if (open.reader.unreadable.has(path) || (!done.has(path) && !areEqual(there, files.get(path)))) continue;
      const common = (done.has(path) ? (toDisk.get(path) ?? toPlace.get(path)) : there) ?? null;
      if (!areEqual(common ?? undefined, base.get(path))) changes.set(path, common);
    }
    if (changes.size > 0) await this.around.place.writeBase(open.name, changes);
    if (changes.size === 0 && done.size === 0 && open.unstored !== undefined) return;
    try {
      await this.around.place.store();
      open.unstored = null;
    } catch (error) {
      open.unstored = problemWith(error, open.title, open.title);
    }
  }

  private fail(world: string, problem: FolderProblem): void {
    const isNew = this.trouble?.name !== world || this.trouble.problem.message !== problem.message;
    this.trouble = { name: world, problem };
    if (isNew) this.tell(problem);
    this.events.changed();
  }

  private tell(problem: FolderProblem): void {
    this.events.say(problem.message, problem.hint, true);
  }
}
