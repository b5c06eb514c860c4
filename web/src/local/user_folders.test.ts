// SPDX-License-Identifier: BSD-2-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import { Refused } from "../app/api";
import type { KeptFolder } from "./folder_store";
import { FolderReader, stepsFor, type FileHandle, type FolderHandle } from "./folder_sync";
import { UserFolders, worldName } from "./user_folders";

const bytesOf = (text: string): Uint8Array => new TextEncoder().encode(text);
const textOf = (bytes: Uint8Array | null | undefined): string => (bytes === null || bytes === undefined ? "(none)" : new TextDecoder().decode(bytes));
const named = (name: string): Error => Object.assign(new Error(`the browser says ${name}`), { name });

/** A disk with one folder; `fails`: the error of a path. */
class FakeDisk {
  readonly files = new Map<string, { text: string; modified: number }>();
  readonly fails = new Map<string, string>();
  permission: PermissionState = "granted";
  answer: PermissionState = "granted";
  asked = 0;
  reads = 0;
  isGone = false;
  private clock = 1;
  readonly root: FolderHandle;

  constructor(readonly name = "burrow", texts: Readonly<Record<string, string>> = {}) {
    for (const [path, text] of Object.entries(texts)) this.set(path, text);
    this.root = this.folder("", name);
  }
  set(path: string, text: string): void {
    this.files.set(path, { text, modified: this.clock++ });
  }
  private fail(path: string): void {
    const name = this.fails.get(path);
    if (name !== undefined) throw named(name);
  }
  private folder(prefix: string, name: string): FolderHandle {
    const disk = this;
    return {
      kind: "directory", name,
      async *values() {
        if (disk.isGone) throw named("NotFoundError");
        const inside = [...disk.files.keys()].filter((path) => path.startsWith(prefix)).map((path) => path.slice(prefix.length).split("/"));
        for (const one of new Set(inside.map((parts) => parts[0]!))) yield inside.some((parts) => parts[0] === one && parts.length > 1) ? disk.folder(`${prefix}${one}/`, one) : disk.file(prefix + one, one);
      },
      getFileHandle: async (one) => {
        disk.fail(prefix + one);
        return disk.file(prefix + one, one);
      },
      getDirectoryHandle: async (one) => disk.folder(`${prefix}${one}/`, one),
      isSameEntry: async (other) => other === disk.root,
      queryPermission: async () => disk.permission,
      requestPermission: async () => {
        disk.asked += 1;
        return (disk.permission = disk.answer);
      },
    };
  }
  private file(path: string, name: string): FileHandle {
    return {
      kind: "file", name,
      getFile: async () => {
        this.fail(path);
        const file = this.files.get(path);
        if (file === undefined) throw named("NotFoundError");
        return { size: bytesOf(file.text).length, lastModified: file.modified, arrayBuffer: async () => (this.reads++, bytesOf(file.text).buffer as ArrayBuffer) };
      },
      createWritable: async () => {
        let text = "";
        return { write: async (bytes) => void (text = textOf(bytes)), close: async () => this.set(path, text), abort: async () => undefined };
      },
    };
  }
}

const WORLD = { "scenario.toml": "seconds = 60\n", "rabbit.soar": "rest", "sounds/bell.soar": "ring", ".git": "hidden" };

/** Folders with a fake disk and place. `tick` runs what was scheduled. */
function foldersWith(disk: FakeDisk, kept: KeptFolder[] = []) {
  const place = new Map<string, string>(), said: string[] = [], timers: { call: () => void; isOff: boolean }[] = [], refused = new Set<string>();
  const store = new Map(kept.map((one) => [one.name, one]));
  const folders = new UserFolders({
    pick: async () => disk.root,
    store: { all: async () => [...store.values()], put: async (one) => void store.set(one.name, one), remove: async (name) => void store.delete(name) },
    place: {
      read: async (world) => new Map([...place].filter(([path]) => path.startsWith(`${world}/`)).map(([path, text]) => [path.slice(world.length + 1), bytesOf(text)])),
      write: async (path, bytes) => {
        if (refused.has(path)) throw new Refused("there is no room for this file", "remove what you do not need", 400);
        if (bytes === null) place.delete(path);
        else place.set(path, textOf(bytes));
      },
    },
    later: (call) => {
      const timer = { call, isOff: false };
      timers.push(timer);
      return () => void (timer.isOff = true);
    },
    isVisible: () => true,
  });
  const settled = (): Promise<void> => new Promise((done) => setTimeout(done, 2));
  return {
    folders, place, said, store, refused,
    start: () => folders.start({ changed: () => undefined, say: (text, hint) => void said.push(`${text} ${hint}`.trim()) }),
    tick: async () => {
      for (const timer of timers.splice(0)) if (!timer.isOff) timer.call();
      await settled();
    },
  };
}

test("a folder is chosen, its files are copied, and saved edits are written to it", async () => {
  const disk = new FakeDisk("My burrow", WORLD), { folders, place, said, start, tick } = foldersWith(disk);
  await start();
  assert.equal(await folders.choose(["soar_flee"]), "My-burrow");
  assert.deepEqual([...place.keys()].sort(), ["My-burrow/rabbit.soar", "My-burrow/scenario.toml", "My-burrow/sounds/bell.soar"]);
  assert.deepEqual(folders.stateOf("My-burrow"), { title: "My burrow", state: "connected", problem: null });
  place.set("My-burrow/rabbit.soar", "flee");
  place.set("My-burrow/sounds/horn.soar", "blow");
  folders.placeChanged();
  await tick();
  assert.equal(disk.files.get("rabbit.soar")?.text, "flee");
  assert.equal(disk.files.get("sounds/horn.soar")?.text, "blow");
  // The same folder again is the same world.
  assert.equal(await folders.choose([]), "My-burrow");
  assert.deepEqual([folders.all.length, said], [1, []]);
});

test("changes of another program are read, and unchanged files are not read again", async () => {
  const disk = new FakeDisk("burrow", WORLD), { folders, place, said, start, tick } = foldersWith(disk);
  await start();
  await folders.choose([]);
  disk.reads = 0;
  disk.set("rabbit.soar", "pursue");
  disk.files.delete("sounds/bell.soar");
  await tick();
  await new Promise((done) => setTimeout(done, 400));  // A file that is gone is looked for twice.
  assert.equal(place.get("burrow/rabbit.soar"), "pursue");
  assert.equal(place.has("burrow/sounds/bell.soar"), false);
  assert.equal(disk.reads, 1);
  assert.deepEqual(said, ["Another program has changed rabbit.soar, sounds/bell.soar in burrow."]);
});

test("if both change a file, both texts are kept", async () => {
  const disk = new FakeDisk("burrow", WORLD), { folders, place, said, start, tick } = foldersWith(disk);
  await start();
  await folders.choose([]);
  disk.set("rabbit.soar", "theirs");
  place.set("burrow/rabbit.soar", "mine");
  await tick();
  assert.deepEqual([disk.files.get("rabbit.soar")?.text, disk.files.get("rabbit.soar.mine")?.text, place.get("burrow/rabbit.soar")], ["theirs", "mine", "theirs"]);
  assert.match(said.join(), /rabbit.soar was changed here and by another program.*Your text is in rabbit.soar.mine/);
  await tick();
  assert.equal(said.length, 1, "the copy is no file of the world");
});

test("after a reload the browser is asked again, only on a button; edits from before are written", async () => {
  const disk = new FakeDisk("burrow", WORLD), before = foldersWith(disk);
  await before.start();
  await before.folders.choose([]);
  disk.permission = "prompt";
  disk.answer = "denied";
  const { folders, place, said, start } = foldersWith(disk, [...before.store.values()]);
  for (const [path, text] of before.place) place.set(path, text);
  place.set("burrow/rabbit.soar", "saved before the page was closed");
  disk.set("scenario.toml", "seconds = 90\n");
  await start();
  folders.show("burrow");
  await new Promise((done) => setTimeout(done, 2));
  assert.deepEqual([folders.stateOf("burrow")?.state, disk.asked, said], ["off", 0, []]);
  assert.equal(await folders.connect("burrow", true), false);
  assert.equal(folders.stateOf("burrow")?.state, "trouble");
  assert.match(said.join(), /does not let this page read and change burrow.*Connect/);
  disk.answer = "granted";
  assert.equal(await folders.connect("burrow", true), true);
  assert.equal(disk.files.get("rabbit.soar")?.text, "saved before the page was closed");
  assert.equal(place.get("burrow/scenario.toml"), "seconds = 90\n");
});

test("problems name the file and what to do, once, and end when they are solved", async () => {
  const disk = new FakeDisk("burrow", WORLD), { folders, place, said, refused, start, tick } = foldersWith(disk);
  await start();
  await folders.choose([]);
  const expect = async (pattern: RegExp): Promise<void> => {
    folders.lookNow();
    await tick();
    await tick();
    assert.match(said.join("\n"), pattern);
    assert.equal(said.length, 1, said.join("\n"));
    assert.equal(folders.stateOf("burrow")?.state, "trouble");
    said.length = 0;
  };
  disk.fails.set("horn?.soar", "TypeError");
  place.set("burrow/horn?.soar", "blow");
  place.set("burrow/rabbit.soar", "flee");
  await expect(/horn\?\.soar cannot be used: the disk refuses this name.*another name/);
  assert.equal(disk.files.get("rabbit.soar")?.text, "flee", "other files are written");
  place.delete("burrow/horn?.soar");
  folders.lookNow();
  await tick();
  assert.equal(folders.stateOf("burrow")?.state, "connected");
  disk.fails.set("rabbit.soar", "NotAllowedError");
  await expect(/does not let this page read and change rabbit\.soar/);
  disk.fails.clear();
  refused.add("burrow/new.soar");
  disk.set("new.soar", "x");
  await expect(/new\.soar cannot be used here: there is no room.*remove what/);
  disk.files.delete("new.soar");
  disk.isGone = true;
  await expect(/burrow is no longer where it was.*Download my folder/);
  assert.equal(place.get("burrow/rabbit.soar"), "flee", "the copy is kept");
});

test("folders that are no world, or too large, are refused", async () => {
  const none = foldersWith(new FakeDisk("papers", { "letter.txt": "Dear" }));
  await none.start();
  assert.equal(await none.folders.choose([]), null);
  assert.match(none.said.join(), /papers is not the folder of a world.*scenario\.toml/);
  const large = new FakeDisk("films", { "scenario.toml": "", "film.mp4": "x".repeat((4 << 20) + 1) }), { folders, said, start } = foldersWith(large);
  await start();
  assert.equal(await folders.choose([]), null);
  assert.match(said.join(), /films is too large: a world has at most 256 files and 4 MB, and film\.mp4 is beyond that/);
  assert.deepEqual(folders.all, []);
});

test("an editor that empties a file while it saves does not empty the copy", async () => {
  const disk = new FakeDisk("burrow", WORLD), reader = new FolderReader(disk.root, async () => disk.set("rabbit.soar", "complete"));
  await reader.read();
  disk.set("rabbit.soar", "");
  assert.equal(textOf((await reader.read()).get("rabbit.soar")), "complete");
});

test("nothing is removed from the disk, and names of worlds are plain and free", () => {
  const base = new Map([["a", bytesOf("1")]]);
  assert.deepEqual([...stepsFor(base, base, new Map()).toPlace.keys()], ["a"]);
  assert.deepEqual([...stepsFor(base, new Map(), new Map([["a", bytesOf("2")]])).toDisk.keys()], ["a"]);
  assert.equal(worldName("Größe & Co", new Set()), "Gro-e-Co");
  assert.equal(worldName("thesis", new Set(["thesis", "thesis-2"])), "thesis-3");
  assert.equal(worldName("..", new Set()), "folder");
});
