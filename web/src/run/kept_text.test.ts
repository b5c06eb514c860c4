// SPDX-License-Identifier: BSD-2-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import { KeptText, type Store } from "./kept_text";

class Shelf implements Store {
  readonly all = new Map<string, string>();
  isFull = false;
  getItem(key: string): string | null {
    return this.all.get(key) ?? null;
  }
  setItem(key: string, value: string): void {
    if (this.isFull) throw new Error("full");
    this.all.set(key, value);
  }
  removeItem(key: string): void {
    this.all.delete(key);
  }
}

test("typed text survives a reload, and is removed when the server has it", () => {
  const shelf = new Shelf();
  new KeptText("p", shelf).keep("/place/a", "one", "");
  new KeptText("p", shelf).keep("/place/a", "one two", "one");
  assert.deepEqual(new KeptText("p", shelf).find("/place/a", ""), { text: "one two", isOlder: false });
  assert.equal(new KeptText("other", shelf).find("/place/a", ""), null);
  new KeptText("p", shelf).confirm("/place/a", "one");
  assert.equal(shelf.all.size, 1, "an older text is no answer to the newest");
  new KeptText("p", shelf).confirm("/place/a", "one two");
  assert.equal(shelf.all.size, 0);
});

test("a text that was changed elsewhere is distinguished from one that the server does not have", () => {
  const shelf = new Shelf(), kept = new KeptText("p", shelf);
  kept.keep("a", "mine", "before");
  assert.deepEqual(kept.find("a", "theirs"), { text: "mine", isOlder: true });
  assert.equal(kept.find("a", "mine"), null);
  assert.equal(shelf.all.size, 0);
});

test("a full, forbidden or damaged storage prevents nothing", () => {
  const shelf = new Shelf();
  shelf.isFull = true;
  new KeptText("p", shelf).keep("a", "x", "");
  new KeptText("p", null).keep("a", "x", "");
  shelf.all.set("soarbox.typed.p.a", "{");
  assert.equal(new KeptText("p", shelf).find("a", ""), null);
});
