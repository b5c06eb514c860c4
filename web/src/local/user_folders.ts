// SPDX-License-Identifier: BSD-2-Clause
import { Refused } from "../app/api";
import type { FolderStore, KeptFolder } from "./folder_store";
import { FolderProblem, FolderReader, MINE, problemOf, stepsFor, type Files, type FolderHandle, type Steps } from "./folder_sync";

/** The place that has copies of the folders. Paths begin below the folder of worlds: "NAME/FILE". */
export interface CopyPlace {
  read(world: string): Promise<Files>;
  /** null: removes the file. */
  write(path: string, bytes: Uint8Array | null): Promise<void>;
}

/** Parts of the browser; tests give their own. */
export interface FolderSurroundings {
  /** Asks the user for a folder. */
  pick(): Promise<FolderHandle>;
  store: FolderStore;
  place: CopyPlace;
  later(call: () => void, ms: number): () => void;
  isVisible(): boolean;
}

export interface FolderEvents {
  /** Something that a view shows has changed. */
  changed(): void;
  say(text: string, hint: string, isError: boolean): void;
}

/** "off": the browser has to be asked first. */
export type FolderState = "off" | "connected" | "trouble";

const LOOKS_EVERY_MS = 2000, WRITES_AFTER_MS = 300;
const WORLD_FILES = ["scenario.toml", "Sandbox.lua"];

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
  private open: { readonly name: string; readonly reader: FolderReader } | null = null;
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
    let handle: FolderHandle;
    try {
      handle = await this.around.pick();
    } catch (error) {
      if ((error as { name?: string }).name !== "AbortError") this.tell(problemOf(error, "The folder", "The folder"));
      return null;
    }
    try {
      for (const one of this.folders) if (await one.handle.isSameEntry(handle)) return (await this.connect(one.name, true)) ? one.name : null;
      const files = await new FolderReader(handle).read();
      if (!WORLD_FILES.some((name) => files.has(name))) throw new FolderProblem(`${handle.name} is not the folder of a world: it has neither ${WORLD_FILES.join(" nor ")}.`, "Choose the folder in which one of them is.");
      const name = worldName(handle.name, new Set([...taken, ...this.folders.map((one) => one.name)])), folder = { name, handle, base: new Map() };
      await this.around.store.put(folder);
      this.folders = [...this.folders, folder];
      return (await this.connect(name, true)) ? name : null;
    } catch (error) {
      this.tell(problemOf(error, handle.name, handle.name));
      return null;
    }
  }

  /** Connects the folder of a world, and makes copy and folder equal. `mayAsk`: the user has pressed a button, so the browser may ask for permission. */
  async connect(world: string, mayAsk: boolean): Promise<boolean> {
    const folder = this.folders.find((one) => one.name === world);
    if (folder === undefined) return false;
    this.disconnect();
    try {
      let permission = await folder.handle.queryPermission({ mode: "readwrite" });
      if (permission !== "granted" && mayAsk) permission = await folder.handle.requestPermission({ mode: "readwrite" });
      if (permission !== "granted") {
        if (mayAsk) throw problemOf({ name: "NotAllowedError" }, folder.handle.name, folder.handle.name);
        return false;
      }
      this.open = { name: world, reader: new FolderReader(folder.handle) };
      await this.sync(false);
    } catch (error) {
      this.fail(world, problemOf(error, folder.handle.name, folder.handle.name));
    }
    this.events.changed();
    return this.open?.name === world && this.trouble === null;
  }

  /** The world that is shown now; "": none. Connects its folder if the browser allows it without asking. */
  show(world: string): void {
    if (world === this.open?.name) return;
    this.disconnect();
    if (world !== "") void this.connect(world, false);
  }

  async forget(world: string): Promise<void> {
    if (this.open?.name === world) this.disconnect();
    this.folders = this.folders.filter((one) => one.name !== world);
    await this.around.store.remove(world);
    for (const path of (await this.around.place.read(world)).keys()) await this.around.place.write(`${world}/${path}`, null);
    this.events.changed();
  }

  /** Files of the place may have changed: writes them to the folder soon. */
  placeChanged(): void {
    if (this.open !== null) this.lookIn(WRITES_AFTER_MS);
  }

  /** The page is shown again, or about to be hidden. */
  lookNow(): void {
    if (this.open !== null) this.lookIn(0);
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

  /** Makes folder and copy equal, and does so again later. `tells`: says what another program has changed. */
  private sync(tells: boolean): Promise<void> {
    const next = this.last.then(() => this.syncOnce(tells));
    this.last = next;
    return next;
  }

  private async syncOnce(tells: boolean): Promise<void> {
    const { open } = this, folder = this.folders.find((one) => one.name === open?.name);
    if (open === null || folder === undefined) return;
    this.stopWaiting?.();
    this.stopWaiting = null;
    try {
      const disk = await open.reader.read(), copy = await this.around.place.read(open.name), steps = stepsFor(folder.base, disk, copy);
      // A moment later the user may have opened another world.
      if (this.open !== open) return;
      const refused = await this.execute(steps, open.name, open.reader);
      if (steps.toDisk.size > 0 || steps.toPlace.size > 0 || folder.base.size === 0) await this.keep(folder, steps, disk, refused);
      for (const path of steps.both) this.events.say(`${path} was changed here and by another program. The run uses the other program's text.`, `Your text is in ${path}${MINE}, in your folder.`, true);
      const read = [...steps.toPlace.keys()].filter((path) => !steps.both.includes(path) && !refused.has(path));
      if (tells && read.length > 0) this.events.say(`Another program has changed ${read.length > 3 ? `${read.length} files` : read.join(", ")} in ${folder.handle.name}.`, "", false);
      const [first] = refused.values();
      if (first !== undefined) throw first;
      if (this.trouble !== null) {
        this.trouble = null;
        this.events.changed();
      }
    } catch (error) {
      if (this.open === open) this.fail(open.name, problemOf(error, folder.handle.name, folder.handle.name));
    }
    // Meanwhile another look may have been scheduled.
    if (this.open === open && this.stopWaiting === null) this.lookAgain();
  }

  /** Writes files to the folder and to the place. Returns the problems with those that were refused, by their paths. */
  private async execute({ toDisk, toPlace }: Steps, world: string, reader: FolderReader): Promise<Map<string, FolderProblem>> {
    const refused = new Map<string, FolderProblem>();
    const write = async (path: string, call: () => Promise<void>): Promise<void> => {
      try {
        await call();
      } catch (error) {
        refused.set(path, error instanceof Refused ? new FolderProblem(`${path} cannot be used here: ${error.message}`, error.hint) : problemOf(error, path, world));
      }
    };
    for (const [path, bytes] of toDisk) await write(path, () => reader.write(path, bytes));
    // The place keeps its text if the disk has refused it under another name.
    for (const [path, bytes] of toPlace) if (!refused.has(path + MINE)) await write(path, () => this.around.place.write(`${world}/${path}`, bytes));
    return refused;
  }

  private lookAgain(): void {
    this.stopWaiting = this.around.later(() => (this.around.isVisible() ? void this.sync(true) : this.lookAgain()), LOOKS_EVERY_MS);
  }

  private async keep(folder: KeptFolder, { toDisk }: Steps, disk: Files, refused: ReadonlyMap<string, FolderProblem>): Promise<void> {
    const base = new Map(disk);
    for (const [path, bytes] of toDisk) if (!path.endsWith(MINE)) base.set(path, bytes);
    // Refused files are compared with the same base the next time.
    for (const one of refused.keys()) {
      const path = one.endsWith(MINE) ? one.slice(0, -MINE.length) : one, was = folder.base.get(path);
      if (was === undefined) base.delete(path);
      else base.set(path, was);
    }
    const next = { ...folder, base };
    this.folders = this.folders.map((one) => (one.name === folder.name ? next : one));
    await this.around.store.put(next);
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
