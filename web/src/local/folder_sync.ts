// SPDX-License-Identifier: BSD-2-Clause
// Files of a folder on the user's disk (File System Access), and how they are kept equal to their copies in the place.

/** The parts of FileSystemFileHandle and FileSystemDirectoryHandle that are used; tests give their own. */
export interface FileHandle {
  readonly kind: "file";
  readonly name: string;
  getFile(): Promise<{ size: number; lastModified: number; arrayBuffer(): Promise<ArrayBuffer> }>;
  createWritable(): Promise<{ write(bytes: Uint8Array<ArrayBuffer>): Promise<void>; close(): Promise<void>; abort(): Promise<void> }>;
}
export interface FolderHandle {
  readonly kind: "directory";
  readonly name: string;
  values(): AsyncIterable<FileHandle | FolderHandle>;
  getFileHandle(name: string, options?: { create: boolean }): Promise<FileHandle>;
  getDirectoryHandle(name: string, options?: { create: boolean }): Promise<FolderHandle>;
  removeEntry(name: string): Promise<void>;
  isSameEntry(other: FolderHandle): Promise<boolean>;
  queryPermission(what: { mode: "readwrite" }): Promise<PermissionState>;
  requestPermission(what: { mode: "readwrite" }): Promise<PermissionState>;
}

/** Files by their paths below the folder. */
export type Files = ReadonlyMap<string, Uint8Array>;

/** A problem with a folder, for the user. */
export class FolderProblem extends Error {
  constructor(message: string, readonly hint: string) {
    super(message);
  }
}

/** The limits of a place (serve/place.h), which has the copies. */
const MOST_FILES = 256, MOST_BYTES = 4 << 20, MOST_DEPTH = 6;
/** End of the name of a file with the page's version, if the other program's version replaced it; further ones end in ".mine-2", ... */
const MINE = ".mine", MOST_MINE = 100;
/** An editor that saves may empty or remove a file for a moment. */
const SETTLED_AFTER_MS = 250;

const isUsed = (name: string): boolean => !name.startsWith(".") && !/\.mine(-\d+)?$/.test(name);
/** Whether a file is kept equal in folder and place. */
const isShared = (path: string): boolean => path.split("/").every(isUsed);
export const areEqual = (a: Uint8Array | undefined, b: Uint8Array | undefined): boolean => a === b || (a !== undefined && b !== undefined && a.length === b.length && a.every((byte, i) => byte === b[i]));

/** The result of a call, or null if the file or folder does not exist. */
async function orNone<T>(call: () => Promise<T>): Promise<T | null> {
  try {
    return await call();
  } catch (error) {
    if ((error as { name?: string }).name === "NotFoundError") return null;
    throw error;
  }
}

/** The error of a browser in words. `what`: the file or folder. */
export function problemOf(error: unknown, what: string, folder: string): FolderProblem {
  if (error instanceof FolderProblem) return error;
  const { name, message } = error as { name?: string; message?: string };
  switch (name) {
    case "NotAllowedError":
    case "SecurityError":
      return new FolderProblem(`The browser does not let this page read and change ${what}.`, `Choose "Connect" and allow it. If the browser does not ask any more, use the symbol to the left of its address bar.`);
    case "NotFoundError":
      return new FolderProblem(`${what} is no longer where it was.`, what === folder ? `Choose "Open a folder of your disk" and look for it again. "Download my folder" has the copy of it in this browser.` : "If another program has moved it, move it back, or save the text again.");
    case "NoModificationAllowedError":
    case "InvalidStateError":
      return new FolderProblem(`${what} cannot be written: another program uses it, or it is protected.`, `Close it there, and choose "Connect".`);
    case "QuotaExceededError":
      return new FolderProblem(`${what} cannot be written: the disk is full.`, `Make room, and choose "Connect". The browser keeps your text until then.`);
    case "TypeError":
    case "TypeMismatchError":
      return new FolderProblem(`${what} cannot be used: the disk refuses this name, or a folder has it.`, "Give the file another name.");
    default:
      return new FolderProblem(`${what} cannot be read or written: ${message ?? String(error)}`, `Choose "Connect" to try again.`);
  }
}

/** Reads the files of a folder. Keeps their bytes, and reads only files again that have changed. */
export class FolderReader {
  private known = new Map<string, { modified: number; bytes: Uint8Array }>();
  private problems = new Map<string, FolderProblem>();

  constructor(private readonly folder: FolderHandle, private readonly wait: (ms: number) => Promise<void> = (ms) => new Promise((done) => setTimeout(done, ms))) {}

  /** Files that exist but could not be read the last time. */
  get unreadable(): ReadonlyMap<string, FolderProblem> {
    return this.problems;
  }

  async read(): Promise<Files> {
    const before = this.known;
    let files = await this.readOnce();
    const isUnsettled = [...before].some(([path, { bytes }]) => bytes.length > 0 && !this.problems.has(path) && (files.get(path)?.length ?? 0) === 0);
    if (isUnsettled) {
      await this.wait(SETTLED_AFTER_MS);
      files = await this.readOnce();
    }
    return files;
  }

  private async readOnce(): Promise<Files> {
    const next = new Map<string, { modified: number; bytes: Uint8Array }>(), problems = new Map<string, FolderProblem>(), title = this.folder.name;
    let sum = 0;
    const visit = async (folder: FolderHandle, prefix: string, depth: number): Promise<void> => {
      if (depth > MOST_DEPTH) throw new FolderProblem(`${prefix} is too deep in ${title}: a world has at most ${MOST_DEPTH} folders in each other.`, "Choose the folder that has scenario.toml or Sandbox.lua in it.");
      for await (const one of folder.values()) {
        if (!isUsed(one.name)) continue;
        const path = prefix + one.name;
        if (one.kind === "directory") {
          await visit(one, `${path}/`, depth + 1);
          continue;
        }
        try {
          const file = await one.getFile();
          sum += file.size;
          if (next.size >= MOST_FILES || sum > MOST_BYTES) throw new FolderProblem(`${title} is too large: a world has at most ${MOST_FILES} files and ${MOST_BYTES >> 20} MB, and ${path} is beyond that.`, "Choose the folder of the world alone, and move large files out of it.");
          const known = this.known.get(path);
          if (known?.modified === file.lastModified && known.bytes.length === file.size) next.set(path, known);
          else next.set(path, { modified: file.lastModified, bytes: new Uint8Array(await file.arrayBuffer()) });
        } catch (error) {
          // It was removed after the folder was listed.
          if ((error as { name?: string }).name === "NotFoundError") continue;
          // The folder is too large.
          if (error instanceof FolderProblem) throw error;
          problems.set(path, problemOf(error, path, title));
        }
      }
    };
    try {
      await visit(this.folder, "", 1);
    } catch (error) {
      throw problemOf(error, title, title);
    }
    this.known = next;
    this.problems = problems;
    return new Map([...next].map(([path, { bytes }]) => [path, bytes]));
  }

  /** Writes a file, and the folders above it. Returns false, and writes nothing, if the file is no longer as it was read. */
  async write(path: string, bytes: Uint8Array): Promise<boolean> {
    try {
      const { folder, name } = await this.folderFor(path), known = this.known.get(path), handle = await orNone(() => folder.getFileHandle(name));
      if (handle === null) {
        if (known !== undefined) return false;
        return await this.create(folder, name, path, bytes);
      }
      this.refuseOtherSpelling(path, name, handle.name);
      return known !== undefined && (await this.fill(handle, known.modified, known.bytes.length, path, bytes));
    } catch (error) {
      throw problemOf(error, path, this.folder.name);
    }
  }

  /** Writes the page's version of a file under a name that is free. Returns the path of the new file, or of one with the same text. */
  async writeMine(path: string, bytes: Uint8Array): Promise<string> {
    try {
      const { folder, name } = await this.folderFor(path);
      for (let i = 1; i <= MOST_MINE; ++i) {
        const end = i === 1 ? MINE : `${MINE}-${i}`, there = await orNone(() => folder.getFileHandle(name + end));
        if (there === null) {
          if (await this.create(folder, name + end, path + end, bytes)) return path + end;
        } else if (areEqual(new Uint8Array(await (await there.getFile()).arrayBuffer()), bytes)) {
          return path + end;
        }
      }
    } catch (error) {
      throw problemOf(error, path + MINE, this.folder.name);
    }
    throw new FolderProblem(`${path} has ${MOST_MINE} versions that end in ${MINE}.`, "Remove those that you do not need.");
  }

  /** The folder of a file; creates what is missing. */
  private async folderFor(path: string): Promise<{ folder: FolderHandle; name: string }> {
    const parts = path.split("/"), name = parts.pop() ?? "";
    let folder = this.folder, prefix = "";
    for (const part of parts) {
      prefix += `${part}/`;
      const there = await orNone(() => folder.getDirectoryHandle(part));
      if (there !== null) this.refuseOtherSpelling(prefix, part, there.name);
      folder = there ?? (await folder.getDirectoryHandle(part, { create: true }));
    }
    return { folder, name };
  }

  /** `path`: of a file, or of a folder with "/" at its end. It exists on the disk; throws if it does so under another spelling only. */
  private refuseOtherSpelling(path: string, asked: string, found: string): void {
    // Some browsers return the name that was asked for, so the names that were listed are compared too.
    const all = [...this.known.keys()], start = (one: string): string => one.slice(0, path.length);
    const isListed = (one: string): boolean => (path.endsWith("/") ? start(one) === path : one === path);
    const other = all.some(isListed) ? undefined : all.find((one) => (path.endsWith("/") ? start(one) : one).toLowerCase() === path.toLowerCase());
    if (found === asked && other === undefined) return;
    throw new FolderProblem(`${path} cannot be written: this disk does not distinguish it from ${other === undefined ? found : path.endsWith("/") ? start(other) : other}.`, "Give it a name that differs in more than capital letters.");
  }

  private async create(folder: FolderHandle, name: string, path: string, bytes: Uint8Array): Promise<boolean> {
    const handle = await folder.getFileHandle(name, { create: true }), { lastModified, size } = await handle.getFile();
    try {
      // Another program may have created it just now.
      return size === 0 && (await this.fill(handle, lastModified, 0, path, bytes));
    } catch (error) {
      // Without its text, the new file would look like an edit of another program.
      const file = await handle.getFile().catch(() => null);
      if (file?.size === 0 && bytes.length > 0) await folder.removeEntry(name).catch(() => undefined);
      throw error;
    }
  }

  /** Replaces the text of a file that has this time and size. */
  private async fill(handle: FileHandle, modified: number, size: number, path: string, bytes: Uint8Array): Promise<boolean> {
    const isAsRead = async (): Promise<boolean> => {
      const file = await handle.getFile();
      return file.lastModified === modified && file.size === size;
    };
    if (!(await isAsRead())) return false;
    const out = await handle.createWritable();
    try {
      await out.write(new Uint8Array(bytes));
      // close() replaces the file.
      if (!(await isAsRead())) {
        await out.abort();
        return false;
      }
    } catch (error) {
      await out.abort().catch(() => undefined);
      throw error;
    }
    await out.close();
    if (isShared(path)) this.known.set(path, { modified: (await handle.getFile()).lastModified, bytes });
    return true;
  }
}

/** What makes a folder and its copy equal. */
export interface Steps {
  /** Files of the disk that replace those of the place; null: it is removed there. */
  readonly toPlace: ReadonlyMap<string, Uint8Array | null>;
  readonly toDisk: Files;
  /** Files that were changed in both, with the place's versions: the disk's versions are in `toPlace`, and these get another name. */
  readonly both: Files;
}

/**
 * Compares the files of the disk and of the place with those that both had (`base`). Removes nothing from the disk. Files of the place
 * that the disk may not have, such as FILE.mine, are left alone, and those of `unreadable`.
 */
export function stepsFor(base: Files, disk: Files, place: Files, unreadable: ReadonlyMap<string, unknown> = new Map()): Steps {
  const toPlace = new Map<string, Uint8Array | null>(), toDisk = new Map<string, Uint8Array>(), both = new Map<string, Uint8Array>();
  for (const path of new Set([...base.keys(), ...disk.keys(), ...place.keys()])) {
    const was = base.get(path), there = disk.get(path), here = place.get(path);
    if (!isShared(path) || unreadable.has(path) || areEqual(there, here)) continue;
    if (here === undefined || areEqual(here, was)) toPlace.set(path, there ?? null);
    else if (there === undefined || areEqual(there, was)) toDisk.set(path, here);
    else {
      both.set(path, here);
      toPlace.set(path, there);
    }
  }
  return { toPlace, toDisk, both };
}
