// SPDX-License-Identifier: BSD-2-Clause
import type { FolderHandle } from "./folder_sync";

/** A folder of the user's disk that this browser remembers. */
export interface KeptFolder {
  /** The name of its world in the place. */
  readonly name: string;
  readonly handle: FolderHandle;
}
export interface FolderStore {
  all(): Promise<KeptFolder[]>;
  put(folder: KeptFolder): Promise<void>;
  remove(name: string): Promise<void>;
}

const DATABASE = "soarbox-folders", TABLE = "folders";

/** Keeps folders in IndexedDB, which can store their handles. */
export class BrowsersFolders implements FolderStore {
  async all(): Promise<KeptFolder[]> {
    return (await this.ask("readonly", (table) => table.getAll())) as KeptFolder[];
  }
  async put(folder: KeptFolder): Promise<void> {
    await this.ask("readwrite", (table) => table.put(folder));
  }
  async remove(name: string): Promise<void> {
    await this.ask("readwrite", (table) => table.delete(name));
  }

  private async ask(mode: IDBTransactionMode, what: (table: IDBObjectStore) => IDBRequest): Promise<unknown> {
    const database = await new Promise<IDBDatabase>((done, failed) => {
      const opening = indexedDB.open(DATABASE, 1);
      opening.onupgradeneeded = () => opening.result.createObjectStore(TABLE, { keyPath: "name" });
      opening.onsuccess = () => done(opening.result);
      opening.onerror = () => failed(opening.error);
    });
    try {
      return await new Promise((done, failed) => {
        const request = what(database.transaction(TABLE, mode).objectStore(TABLE));
        request.onsuccess = () => done(request.result);
        request.onerror = () => failed(request.error);
      });
    } finally {
      database.close();
    }
  }
}
