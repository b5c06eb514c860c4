// SPDX-License-Identifier: BSD-2-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import { soarPieces, soarToken, startState, TextLine } from "./soar_tokens";

function tokens(text: string): string[] {
  const state = startState(), found: string[] = [];
  for (const one of text.split("\n")) {
    const line = new TextLine(one);
    while (!line.isDone) {
      const begin = line.place, kind = soarToken(line, state);
      assert.ok(line.place > begin, `nothing was read at ${begin} of ${one}`);
      if (kind !== null) found.push(`${kind} ${one.slice(begin, line.place)}`);
    }
  }
  return found;
}

test("a rule is read piece by piece", () => {
  assert.deepEqual(tokens("sp {a*rule # why\n   (state <s> ^io.input-link.agent <a> -^name |an b|)\n-->\n   (write |x| (crlf)) (<s> ^n 3.5 +)\n}"), [
    "keyword sp", "brace {", "def a*rule", "comment # why", "bracket (", "keyword state", "variable <s>", "attribute ^io.input-link.agent", "variable <a>", "attribute -^name", "string |an b|", "bracket )",
    "arrow -->", "bracket (", "function write", "string |x|", "bracket (", "function crlf", "bracket )", "bracket )", "bracket (", "variable <s>", "attribute ^n", "number 3.5", "operator +", "bracket )", "brace }",
  ]);
});

test("a rule ends with its brace, however many conditions have braces of their own", () => {
  const found = tokens("sp {x (state <s> ^n { > 1 <n> })\n-->\n(<s> ^m <n>) }\nlearn always");
  assert.equal(found.filter((one) => one.startsWith("brace")).length, 4);
  assert.equal(found.at(-1), "keyword learn");
});

test("quoted text goes over lines and keeps escaped bars", () => {
  assert.deepEqual(tokens("sp {x (write |a \\| b\nc|)").slice(3), ["bracket (", "function write", "string |a \\| b", "string c|", "bracket )"].slice(0));
});

test("any text is read to its end", () => {
  for (const text of ["sp {", "^^^ <<< |", "sp \"a", "}}}) -->", "\u{1f600} sp{ <\u{1f600}> }", "-", "+", "sp {a -{ (<s> ^x) } --> }"]) tokens(text);
});

test("the pieces of a text are the text", () => {
  const text = "sp {a*b\n   (state <s>)\n\n-->\n}\n";
  assert.equal(soarPieces(text).map((one) => one.text).join(""), text);
  assert.deepEqual(soarPieces(text)[2], { kind: "brace", text: "{" });
});
