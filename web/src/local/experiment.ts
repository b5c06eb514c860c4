// SPDX-License-Identifier: BSD-2-Clause
import type { ChangedFiles } from "../app/address";
import type { EngineModule } from "./engine";
import type { KeptFile } from "./messages";

type Files = EngineModule["FS"];

/** The folders of the user's files and of the program's files. */
const HOME = "/place/home", SHIPPED = "/soarbox";
/** The file that defines a lesson; it is not copied to the user. */
const LESSON_FILE = "lesson.toml";

export function filesBelow(FS: Files, folder: string): KeptFile[] {
  if (!FS.analyzePath(folder).exists) return [];
  return FS.readdir(folder).filter((name) => name !== "." && name !== "..").flatMap((name) => {
    const path = `${folder}/${name}`;
    return FS.isDir(FS.stat(path).mode) ? filesBelow(FS, path) : [{ path, bytes: FS.readFile(path) }];
  });
}

export function writeFiles(FS: Files, files: readonly KeptFile[]): void {
  for (const { path, bytes } of files) {
    FS.mkdirTree(path.slice(0, path.lastIndexOf("/")));
    FS.writeFile(path, bytes);
  }
}

/**
 * The folders of a lesson or world: `own` has the user's files, `shipped` the program's. It is empty if the user made
 * the world.
 */
function foldersOf(FS: Files, what: string): { own: string; shipped: string } | null {
  const at = what.indexOf(":"), kind = what.slice(0, at), name = what.slice(at + 1);
  if (!/^[\w-][\w.-]*$/.test(name)) return null;
  if (kind === "scenario") {
    const shipped = `${SHIPPED}/scenarios/${name}`;
    return { own: `${HOME}/worlds/${name}`, shipped: FS.analyzePath(shipped).exists ? shipped : "" };
  }
  const lessons = `${SHIPPED}/lessons`;
  if (kind !== "lesson" || !FS.analyzePath(lessons).exists) return null;
  const courses = [lessons, ...FS.readdir(lessons).filter((course) => !course.startsWith(".")).map((course) => `${lessons}/${course}`)];
  const found = courses.find((course) => FS.analyzePath(`${course}/${name}/${LESSON_FILE}`).exists);
  return found === undefined ? null : { own: `${HOME}/soarbox-lessons/${name}`, shipped: `${found}/${name}` };
}

/** The program's files of a lesson or world, by their names below its folder. */
function shippedFiles(FS: Files, what: string, shipped: string): KeptFile[] {
  if (shipped === "") return [];
  const all = filesBelow(FS, shipped).map(({ path, bytes }) => ({ path: path.slice(shipped.length + 1), bytes }));
  // Of a lesson, only these files are copied to the user; its solution, for example, is not.
  return what.startsWith("lesson:") ? all.filter(({ path }) => !path.includes("/") && path !== LESSON_FILE) : all;
}

export const areEqual = (a: Uint8Array, b: Uint8Array): boolean => a.length === b.length && a.every((byte, i) => byte === b[i]);

/** The files of a lesson or world that differ from the program's. */
export function changedFiles(FS: Files, what: string): ChangedFiles {
  const folders = foldersOf(FS, what), files: Record<string, string> = {}, leftOut: string[] = [];
  if (folders === null) return { folder: "", files, leftOut };
  const shipped = new Map(shippedFiles(FS, what, folders.shipped).map(({ path, bytes }) => [path, bytes]));
  for (const { path, bytes } of filesBelow(FS, folders.own)) {
    const name = path.slice(folders.own.length + 1), original = shipped.get(name);
    if (original !== undefined && areEqual(original, bytes)) continue;
    try {
      files[name] = new TextDecoder("utf-8", { fatal: true }).decode(bytes);
    } catch {
      leftOut.push(name);
    }
  }
  return { folder: `${folders.own}/`, files, leftOut };
}

/** Writes the files of an experiment into an empty place, before its lesson or world is opened. */
export function writeExperiment(FS: Files, what: string, files: Readonly<Record<string, string>>): void {
  const folders = foldersOf(FS, what);
  if (folders === null) return;
  // Copies all files of the world, because opening copies no files into an existing folder.
  writeFiles(FS, shippedFiles(FS, what, folders.shipped).map(({ path, bytes }) => ({ path: `${folders.own}/${path}`, bytes })));
  writeFiles(FS, Object.entries(files).map(([name, text]) => ({ path: `${folders.own}/${name}`, bytes: new TextEncoder().encode(text) })));
}
