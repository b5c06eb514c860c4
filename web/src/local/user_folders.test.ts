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
  ignoresCase = false;
  /** Called before a file is filled, and before its new text replaces it. */
  beforeWrite: (path: string) => void = () => undefined;
  beforeClose: (path: string) => void = () => undefined;
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
      getFileHandle: async (one, options) => {
        disk.fail(prefix + one);
        const path = disk.spelt(prefix + one);
        if (!disk.files.has(path)) {
          if (options?.create !== true) throw named("NotFoundError");
          disk.set(path, "");
        }
        return disk.file(path, one);
      },
      getDirectoryHandle: async (one, options) => {
        const path = disk.spelt(`${prefix}${one}/`);
        if (options?.create !== true && ![...disk.files.keys()].some((name) => name.startsWith(path))) throw named("NotFoundError");
        return disk.folder(path, one);
      },
      removeEntry: async (one) => void disk.files.delete(prefix + one),
      isSameEntry: async (other) => other === disk.root,
      queryPermission: async () => disk.permission,
      requestPermission: async () => {
        disk.asked += 1;
        return (disk.permission = disk.answer);
      },
    };
  }
  /** The path of what exists, if the disk ignores case. */
  private spelt(path: string): string {
    const found = this.ignoresCase ? [...this.files.keys()].find((one) => one.toLowerCase().startsWith(path.toLowerCase())) : undefined;
    return found === undefined ? path : found.slice(0, path.length);
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
        const write = async (bytes: Uint8Array): Promise<void> => {
          text = textOf(bytes);
          const name = this.fails.get(`write ${path}`);
          if (name !== undefined) throw named(name);
          this.beforeClose(path);
        };
        this.beforeWrite(path);
        return { write, close: async () => this.set(path, text), abort: async () => undefined };
      },
    };
  }
}

const WORLD = { "scenario.toml": "seconds = 60\n", "rabbit.soar": "rest", "sounds/bell.soar": "ring", ".git": "hidden" };

function put(files: Map<string, string>, path: string, bytes: Uint8Array | null): void {
  if (bytes === null) files.delete(path);
  else files.set(path, textOf(bytes));
}
const below = (files: ReadonlyMap<string, string>, world: string): Map<string, Uint8Array> => new Map([...files].filter(([path]) => path.startsWith(`${world}/`)).map(([path, text]) => [path.slice(world.length + 1), bytesOf(text)]));

/** Folders with a fake disk and place. `tick` runs what was scheduled. */
function foldersWith(disk: FakeDisk, kept: KeptFolder[] = [], isOnly = true) {
  const place = new Map<string, string>(), base = new Map<string, string>(), questions: string[] = [], counts = { writes: 0, stores: 0 }, will = { answer: false, storeError: "", beforePlace: () => undefined as void }, said: string[] = [], timers: { call: () => void; isOff: boolean }[] = [], refused = new Set<string>();
  const store = new Map(kept.map((one) => [one.name, one]));
  const folders = new UserFolders({
    pick: async () => disk.root,
    store: { all: async () => [...store.values()], put: async (one) => void store.set(one.name, one), remove: async (name) => void store.delete(name) },
    place: {
      read: async (world) => ({ files: below(place, world), base: below(base, world) }),
      writeBase: async (world, changes) => {
        for (const [path, bytes] of changes) put(base, `${world}/${path}`, bytes);
      },
      store: async () => {
        counts.stores += 1;
        if (will.storeError !== "") throw new Refused(will.storeError, "", 507);
      },
      write: async (path, bytes, was) => {
        counts.writes += 1;
        will.beforePlace();
        if (place.get(path) !== (was === null ? undefined : textOf(was))) return false;
        if (refused.has(path)) throw new Refused("there is no room for this file", "remove what you do not need", 400);
        put(place, path, bytes);
        return true;
      },
    },
    isOnly,
    ask: (question) => (questions.push(question), will.answer),
    later: (call) => {
      const timer = { call, isOff: false };
      timers.push(timer);
      return () => void (timer.isOff = true);
    },
    isVisible: () => true,
  });
  const settled = (): Promise<void> => new Promise((done) => setTimeout(done, 2));
  return {
    folders, place, base, said, store, refused, questions, counts, will,
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
  const { folders, place, base, said, start } = foldersWith(disk, [...before.store.values()]);
  for (const [path, text] of before.place) place.set(path, text);
  for (const [path, text] of before.base) base.set(path, text);
  place.set("burrow/rabbit.soar", "saved before the page was closed");
  disk.set("scenario.toml", "seconds = 90\n");
  await start();
  folders.show("burrow");
  await new Promise((done) => setTimeout(done, 2));
  assert.deepEqual([folders.stateOf("burrow")?.state, disk.asked, said], ["off", 0, []]);
  assert.equal(await folders.connect("burrow", true), true, "the world can be opened from its copy");
  assert.equal(folders.stateOf("burrow")?.state, "trouble");
  folders.show("burrow");
  await new Promise((done) => setTimeout(done, 2));
  assert.equal(folders.stateOf("burrow")?.state, "trouble", "opening the world does not hide the problem");
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

test("a crash before the place was stored does not bring an old text back to the disk", async () => {
  const disk = new FakeDisk("burrow", WORLD), before = foldersWith(disk);
  await before.start();
  await before.folders.choose([]);
  const stores = before.counts.stores, stored = { place: [...before.place], base: [...before.base] };
  before.place.set("burrow/rabbit.soar", "new");
  before.folders.placeChanged();
  await before.tick();
  assert.deepEqual([disk.files.get("rabbit.soar")?.text, before.counts.stores], ["new", stores + 1], "it is stored at once");
  await before.tick();
  assert.equal(before.counts.stores, stores + 1, "nothing has changed");
  // The browser crashes: the place and its base are those that were stored.
  const after = foldersWith(disk, [...before.store.values()]);
  for (const [path, text] of stored.place) after.place.set(path, text);
  for (const [path, text] of stored.base) after.base.set(path, text);
  await after.start();
  await after.folders.connect("burrow", true);
  assert.deepEqual([disk.files.get("rabbit.soar")?.text, after.place.get("burrow/rabbit.soar"), after.said], ["new", "new", []]);
});

test("that the browser cannot store the copy is shown until it can", async () => {
  const disk = new FakeDisk("burrow", WORLD), { folders, place, said, will, start, tick } = foldersWith(disk);
  await start();
  await folders.choose([]);
  will.storeError = "no room";
  place.set("burrow/rabbit.soar", "new");
  for (let i = 0; i < 3; ++i) await tick();
  assert.deepEqual([said, folders.stateOf("burrow")?.state, disk.files.get("rabbit.soar")?.text], [["no room"], "trouble", "new"]);
  will.storeError = "";
  place.set("burrow/rabbit.soar", "newer");
  await tick();
  assert.equal(folders.stateOf("burrow")?.state, "connected");
});

test("a second tab connects no folder, and says what to do", async () => {
  const disk = new FakeDisk("burrow", WORLD), before = foldersWith(disk);
  await before.start();
  await before.folders.choose([]);
  const { folders, place, said, counts, store, start, tick } = foldersWith(disk, [...before.store.values()], false);
  for (const [path, text] of before.place) place.set(path, text);
  await start();
  assert.equal(await folders.connect("burrow", true), true);
  place.set("burrow/rabbit.soar", "here");
  folders.placeChanged();
  await tick();
  assert.equal(await folders.choose([]), null);
  await folders.forget("burrow");
  assert.deepEqual([disk.files.get("rabbit.soar")?.text, counts.writes, store.size, folders.stateOf("burrow")?.state], ["rest", 0, 1, "trouble"]);
  for (const one of said) assert.match(one, /Another tab shows your files already.*close it, and reload this one/);
});

test("a refused file is tried again only when it changes, or with Connect", async () => {
  const disk = new FakeDisk("burrow", WORLD), { folders, place, said, refused, counts, start, tick } = foldersWith(disk);
  refused.add("burrow/rabbit.soar");
  await start();
  assert.equal(await folders.choose([]), "burrow", "the world is opened without the file");
  const { writes } = counts;
  for (let i = 0; i < 3; ++i) await tick();
  assert.deepEqual([counts.writes, said.length, folders.stateOf("burrow")?.state], [writes, 1, "trouble"]);
  disk.set("rabbit.soar", "other");
  await tick();
  assert.equal(counts.writes, writes + 1);
  refused.clear();
  await folders.connect("burrow", true);
  assert.deepEqual([place.get("burrow/rabbit.soar"), folders.stateOf("burrow")?.state], ["other", "connected"]);
});

test("a file that cannot be read is left alone, and the others are kept equal", async () => {
  const disk = new FakeDisk("burrow", WORLD), { folders, place, base, start, tick } = foldersWith(disk);
  await start();
  await folders.choose([]);
  disk.fails.set("rabbit.soar", "NotReadableError");
  disk.set("scenario.toml", "seconds = 90\n");
  await tick();
  await new Promise((done) => setTimeout(done, 400));
  assert.deepEqual([place.get("burrow/scenario.toml"), place.get("burrow/rabbit.soar"), base.get("burrow/rabbit.soar")], ["seconds = 90\n", "rest", "rest"]);
  assert.match(folders.stateOf("burrow")?.problem?.message ?? "", /rabbit\.soar cannot be read/);
});

test("the user's version of a file gets a free name, and is not written again", async () => {
  const disk = new FakeDisk("burrow", { ...WORLD, "rabbit.soar.mine": "earlier" }), { folders, place, said, start, tick } = foldersWith(disk);
  await start();
  await folders.choose([]);
  disk.set("rabbit.soar", "theirs");
  place.set("burrow/rabbit.soar", "mine");
  place.set("burrow/hare.soar.mine", "own");
  await tick();
  assert.deepEqual(["", ".mine", ".mine-2", ".mine-3"].map((end) => disk.files.get(`rabbit.soar${end}`)?.text), ["theirs", "earlier", "mine", undefined]);
  assert.match(said.join(), /Your text is in rabbit\.soar\.mine-2/);
  // The same text is not written twice.
  disk.set("rabbit.soar", "theirs again");
  place.set("burrow/rabbit.soar", "earlier");
  const { modified } = disk.files.get("rabbit.soar.mine")!;
  await tick();
  assert.deepEqual([disk.files.has("rabbit.soar.mine-3"), disk.files.get("rabbit.soar.mine")?.modified, disk.files.has("hare.soar.mine")], [false, modified, false]);
});

test("Forget asks if the disk lacks edits, and names their files", async () => {
  const disk = new FakeDisk("burrow", WORLD), { folders, place, base, store, questions, will, start } = foldersWith(disk);
  await start();
  await folders.choose([]);
  disk.fails.set("rabbit.soar", "NoModificationAllowedError");
  place.set("burrow/rabbit.soar", "unwritten");
  place.set("burrow/scenario.toml", "seconds = 90\n");
  await folders.forget("burrow");
  assert.match(questions.join(), /burrow on the disk lacks what you changed here in rabbit\.soar\. Forget/);
  assert.deepEqual([disk.files.get("scenario.toml")?.text, place.get("burrow/rabbit.soar"), store.size], ["seconds = 90\n", "unwritten", 1]);
  will.answer = true;
  await folders.forget("burrow");
  assert.deepEqual([place.size, base.size, store.size, folders.all], [0, 0, 0, []]);
});

test("a file that another program writes at the same moment is left for the next look", async () => {
  for (const moment of ["beforeWrite", "beforeClose"] as const) {
    const disk = new FakeDisk("burrow", WORLD), { folders, place, start, tick } = foldersWith(disk);
    await start();
    await folders.choose([]);
    place.set("burrow/rabbit.soar", "mine");
    disk[moment] = (path) => {
      disk[moment] = () => undefined;
      disk.set(path, "theirs");
    };
    await tick();
    assert.equal(disk.files.get("rabbit.soar")?.text, "theirs", moment);
    await tick();
    assert.deepEqual([disk.files.get("rabbit.soar.mine")?.text, place.get("burrow/rabbit.soar")], ["mine", "theirs"], moment);
  }
  const disk = new FakeDisk("burrow", WORLD), reader = new FolderReader(disk.root);
  await reader.read();
  disk.set("rabbit.soar", "theirs");
  disk.set("new.soar", "theirs");
  disk.files.delete("scenario.toml");
  for (const path of ["rabbit.soar", "new.soar", "scenario.toml"]) assert.equal(await reader.write(path, bytesOf("mine")), false, path);
  assert.deepEqual([disk.files.get("rabbit.soar")?.text, disk.files.get("new.soar")?.text, disk.files.has("scenario.toml")], ["theirs", "theirs", false]);
});

test("an edit that is saved while another program's text is read is kept", async () => {
  const disk = new FakeDisk("burrow", WORLD), { folders, place, will, start, tick } = foldersWith(disk);
  await start();
  await folders.choose([]);
  disk.set("rabbit.soar", "theirs");
  will.beforePlace = () => {
    will.beforePlace = () => undefined;
    place.set("burrow/rabbit.soar", "mine");
  };
  await tick();
  assert.equal(place.get("burrow/rabbit.soar"), "mine");
  await tick();
  assert.deepEqual([place.get("burrow/rabbit.soar"), disk.files.get("rabbit.soar.mine")?.text], ["theirs", "mine"]);
});

test("a new file that cannot be filled is removed, so that it does not replace the text in the place", async () => {
  const disk = new FakeDisk("burrow", WORLD), { folders, place, start, tick } = foldersWith(disk);
  await start();
  await folders.choose([]);
  place.set("burrow/new.soar", "text");
  disk.fails.set("write new.soar", "QuotaExceededError");
  for (let i = 0; i < 2; ++i) await tick();
  assert.deepEqual([disk.files.has("new.soar"), place.get("burrow/new.soar")], [false, "text"]);
});

test("a disk that ignores case refuses another spelling of a file or folder", async () => {
  const disk = new FakeDisk("burrow", WORLD), { folders, place, said, start, tick } = foldersWith(disk);
  disk.ignoresCase = true;
  await start();
  await folders.choose([]);
  place.set("burrow/Rabbit.soar", "other");
  place.set("burrow/Sounds/horn.soar", "blow");
  await tick();
  assert.deepEqual([...disk.files].map(([path, { text }]) => `${path} ${text.trim()}`), [...Object.entries(WORLD)].map(([path, text]) => `${path} ${text.trim()}`));
  assert.match(said.join(), /Rabbit\.soar cannot be written: this disk does not distinguish it from rabbit\.soar/);
  place.delete("burrow/Rabbit.soar");
  await tick();
  assert.match(said.join(), /Sounds\/ cannot be written: this disk does not distinguish it from sounds\//);
});

test("what is equal already is the base too", async () => {
  const disk = new FakeDisk("burrow", WORLD), { folders, place, base, said, start, tick } = foldersWith(disk);
  await start();
  await folders.choose([]);
  disk.set("rabbit.soar", "same");
  place.set("burrow/rabbit.soar", "same");
  await tick();
  assert.equal(base.get("burrow/rabbit.soar"), "same");
  disk.set("rabbit.soar", "rest");
  await tick();
  assert.deepEqual([place.get("burrow/rabbit.soar"), disk.files.get("rabbit.soar")?.text, said.length], ["rest", "rest", 1]);
});

test("opening another world writes what waits first", async () => {
  for (const next of ["soar_flee", ""]) {
    const disk = new FakeDisk("burrow", WORLD), { folders, place, start } = foldersWith(disk);
    await start();
    await folders.choose([]);
    place.set("burrow/rabbit.soar", "saved");
    folders.placeChanged();
    folders.show(next);
    await new Promise((done) => setTimeout(done, 5));
    assert.deepEqual([disk.files.get("rabbit.soar")?.text, folders.stateOf("burrow")?.state], ["saved", "off"]);
  }
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
