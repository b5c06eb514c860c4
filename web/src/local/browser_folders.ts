// SPDX-License-Identifier: BSD-2-Clause
import { Refused } from "../app/api";
import { BrowsersFolders } from "./folder_store";
import type { FolderHandle } from "./folder_sync";
import { UserFolders } from "./user_folders";
import type { LocalPlace } from "./worker_source";

/** What browsers have that can open folders. The types of TypeScript lack it. */
interface Picker {
  showDirectoryPicker?: (options: { id: string; mode: "readwrite" }) => Promise<FolderHandle>;
}

/** The folder of the place with the base of a world: without folders in it, so that a file never has the name of an old folder. */
const baseFolder = (world: string): string => `/place/state/folders/${world}`;
const encodeName = (path: string): string => path.replaceAll("%", "%25").replaceAll("/", "%2F");
const decodeName = (name: string): string => name.replaceAll("%2F", "/").replaceAll("%25", "%");

/** Folders of the user's disk, with their copies in a place; null: this browser cannot open folders. */
export function foldersOf(place: LocalPlace): UserFolders | null {
  const picker = globalThis as unknown as Picker;
  if (picker.showDirectoryPicker === undefined) return null;
  /** The place's startCount when it was read. */
  let start = 0;
  const folders = new UserFolders({
    isOnly: place.isOnly,
    ask: (question) => confirm(question),
    // Asked for by its name, so that it is called as a function of the window.
    pick: async () => (globalThis as unknown as Required<Picker>).showDirectoryPicker({ id: "soarbox", mode: "readwrite" }),
    store: new BrowsersFolders(),
    place: {
      read: async (world) => {
        const home = `/place/home/worlds/${world}`, state = baseFolder(world);
        const [files, base] = await Promise.all([place.files(home), place.files(state)]);
        start = place.startCount;
        return { files: new Map(files.map(({ path, bytes }) => [path.slice(home.length + 1), bytes])), base: new Map(base.map(({ path, bytes }) => [decodeName(path.slice(state.length + 1)), bytes])) };
      },
      writeBase: async (world, changes) => {
        const pathOf = (path: string): string => `${baseFolder(world)}/${encodeName(path)}`;
        const files = [...changes].flatMap(([path, bytes]) => (bytes === null ? [] : [{ path: pathOf(path), bytes }]));
        return place.write(files, [...changes].filter(([, bytes]) => bytes === null).map(([path]) => pathOf(path)), start);
      },
      store: async () => place.store(),
      write: async (path, bytes, was) => {
        const answer = await place.replace(`worlds/${path}`, bytes, was);
        if (answer.ok) return true;
        if (answer.status === 409) return false;
        const told = (await answer.json()) as { error?: string; hint?: string };
        throw new Refused(told.error ?? `The answer was ${answer.status}.`, told.hint ?? "", answer.status);
      },
    },
    later: (call, ms) => {
      const timer = setTimeout(call, ms);
      return () => clearTimeout(timer);
    },
    isVisible: () => document.visibilityState === "visible",
  });
  place.mayHaveChanged = () => folders.placeChanged();
  return folders;
}
