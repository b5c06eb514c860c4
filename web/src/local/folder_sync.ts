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
/** End of the name of a file with the page's version, if the other program's version replaced it. */
export const MINE = ".mine";
/** An editor that saves may empty or remove a file for a moment. */
const SETTLED_AFTER_MS = 250;

const isUsed = (name: string): boolean => !name.startsWith(".") && !name.endsWith(MINE);
export const areEqual = (a: Uint8Array | undefined, b: Uint8Array | undefined): boolean => a === b || (a !== undefined && b !== undefined && a.length === b.length && a.every((byte, i) => byte === b[i]));

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

  constructor(private readonly folder: FolderHandle, private readonly wait: (ms: number) => Promise<void> = (ms) => new Promise((done) => setTimeout(done, ms))) {}

  async read(): Promise<Files> {
    const before = this.known;
    let files = await this.readOnce();
    const isUnsettled = [...before].some(([path, { bytes }]) => bytes.length > 0 && (files.get(path)?.length ?? 0) === 0);
    if (isUnsettled) {
      await this.wait(SETTLED_AFTER_MS);
      files = await this.readOnce();
    }
    return files;
  }

  private async readOnce(): Promise<Files> {
    const next = new Map<string, { modified: number; bytes: Uint8Array }>(), title = this.folder.name;
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
          if ((error as { name?: string }).name !== "NotFoundError") throw problemOf(error, path, title);
        }
      }
    };
    try {
      await visit(this.folder, "", 1);
    } catch (error) {
      throw problemOf(error, title, title);
    }
    this.known = next;
    return new Map([...next].map(([path, { bytes }]) => [path, bytes]));
  }

  /** Writes a file, and the folders above it. */
  async write(path: string, bytes: Uint8Array): Promise<void> {
    const parts = path.split("/"), name = parts.pop() ?? "";
    try {
      let folder = this.folder;
      for (const part of parts) folder = await folder.getDirectoryHandle(part, { create: true });
      const handle = await folder.getFileHandle(name, { create: true }), out = await handle.createWritable();
      try {
        await out.write(new Uint8Array(bytes));
      } catch (error) {
        await out.abort().catch(() => undefined);
        throw error;
      }
      await out.close();
      if (isUsed(name)) this.known.set(path, { modified: (await handle.getFile()).lastModified, bytes });
    } catch (error) {
      throw problemOf(error, path, this.folder.name);
    }
  }
}

/** What makes a folder and its copy equal. */
export interface Steps {
  /** Files of the disk that replace those of the place; null: it is removed there. */
  readonly toPlace: ReadonlyMap<string, Uint8Array | null>;
  readonly toDisk: Files;
  /** Files that were changed in both: the disk's version counts, and `toDisk` has the other one under another name. */
  readonly both: readonly string[];
}

/** Compares the files of the disk and of the place with those that both had (`base`). Removes nothing from the disk. */
export function stepsFor(base: Files, disk: Files, place: Files): Steps {
  const toPlace = new Map<string, Uint8Array | null>(), toDisk = new Map<string, Uint8Array>(), both: string[] = [];
  for (const path of new Set([...base.keys(), ...disk.keys(), ...place.keys()])) {
    const was = base.get(path), there = disk.get(path), here = place.get(path);
    if (areEqual(there, here)) continue;
    if (here === undefined || areEqual(here, was)) toPlace.set(path, there ?? null);
    else if (there === undefined || areEqual(there, was)) toDisk.set(path, here);
    else {
      both.push(path);
      toPlace.set(path, there);
      toDisk.set(path + MINE, here);
    }
  }
  return { toPlace, toDisk, both };
}
