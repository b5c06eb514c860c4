// SPDX-License-Identifier: BSD-2-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import { Applying } from "./applying";

const ERROR = [{ severity: "error" }];
const shown = (file: string, text: string, reload_count = 0, problems: { severity: string }[] = []) => ({ file, text, reload_count, problems });

test("an Apply is done once, when the run has reloaded that file", () => {
  const applying = new Applying();
  assert.equal(applying.isDone(shown("a.soar", "new", 1)), false, "nothing was sent");
  applying.begin(shown("a.soar", "old", 1), "new");
  assert.equal(applying.isDone(undefined), false);
  assert.equal(applying.isDone(shown("a.soar", "new", 1)), false);
  assert.equal(applying.isDone(shown("a.soar", "new", 2, [{ severity: "warning" }])), true);
  assert.equal(applying.isDone(shown("a.soar", "new", 3)), false, "it was reloaded from elsewhere");
});

test("another file that was reloaded more often is no Apply of this one", () => {
  const applying = new Applying();
  applying.begin(shown("a.soar", "old"), "new");
  assert.equal(applying.isDone(shown("b.soar", "other", 4)), false);
  assert.equal(applying.isDone(shown("a.soar", "new", 1)), false, "the answer was not seen");
});

test("an Apply with errors ends; errors of the text before it do not end it", () => {
  const applying = new Applying();
  applying.begin(shown("a.soar", "old", 0, ERROR), "new");
  assert.equal(applying.isDone(shown("a.soar", "old", 0, ERROR)), false);
  assert.equal(applying.isDone(shown("a.soar", "new", 0, ERROR)), false);
  assert.equal(applying.isDone(shown("a.soar", "newer", 1)), false, "the file was changed elsewhere");
});
