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

/** Folders of the user's disk, with their copies in a place; null: this browser cannot open folders. */
export function foldersOf(place: LocalPlace): UserFolders | null {
  const picker = globalThis as unknown as Picker;
  if (picker.showDirectoryPicker === undefined) return null;
  const folders = new UserFolders({
    // Asked for by its name, so that it is called as a function of the window.
    pick: async () => (globalThis as unknown as Required<Picker>).showDirectoryPicker({ id: "soarbox", mode: "readwrite" }),
    store: new BrowsersFolders(),
    place: {
      read: async (world) => {
        const home = `/place/home/worlds/${world}`;
        return new Map((await place.files(home)).map(({ path, bytes }) => [path.slice(home.length + 1), bytes]));
      },
      write: async (path, bytes) => {
        const answer = await place.answer(bytes === null ? "DELETE" : "PUT", `files/worlds/${path}`, bytes ?? new Uint8Array());
        if (answer.ok) return;
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
