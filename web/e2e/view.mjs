// SPDX-License-Identifier: BSD-2-Clause
// What src/dom/view.ts promises about the document, in a real browser, without a server.
import assert from "node:assert/strict";
import { fileURLToPath } from "node:url";
import { after, test } from "node:test";
import { build } from "esbuild";
import { closeBrowser, openBrowser } from "./browser.mjs";

after(closeBrowser);
const { outputFiles: [{ text: script }] } = await build({
  stdin: { contents: 'export * from "./view"', resolveDir: fileURLToPath(new URL("../src/dom", import.meta.url)), loader: "ts" },
  bundle: true, write: false, format: "iife", globalName: "view",
});

/** Calls `act(view, place)` in an empty page; `place` is an element there. */
async function inPage(act) {
  const context = await (await openBrowser({ draws: false })).newContext(), page = await context.newPage();
  await page.addScriptTag({ content: script });
  const found = await page.evaluate(`(${act})(view, document.body.appendChild(document.createElement("div")))`);
  await context.close();
  return found;
}

test("an element is mounted once, when it is in the page, and patched by each later patch", async () => {
  assert.deepEqual(await inPage(({ h, patch }, place) => {
    const calls = [];
    const draw = (word) => patch(place, [h("p", { mounted: (one) => calls.push(`mounted ${one.isConnected} ${one.textContent}`), patched: (one) => calls.push(`patched ${one.textContent}`) }, word)]);
    ["a", "b", "c"].forEach(draw);
    return calls;
  }), ["mounted true a", "patched b", "patched c"]);
});

test("a field keeps focus, caret and node when siblings appear before it", async () => {
  assert.deepEqual(await inPage(({ h, patch }, place) => {
    const draw = (isWarned, marks) => patch(place, [isWarned && h("p", null, "warning"), marks.map((mark) => h("i", { key: mark }, mark)), h("input", { key: "field", value: "typed", attributes: { type: "text" } })]);
    draw(false, ["a"]);
    const field = place.querySelector("input");
    field.focus();
    field.setSelectionRange(2, 3);
    draw(true, ["b", "a", "c"]);
    return [document.activeElement === field, place.querySelector("input") === field, field.selectionStart, field.selectionEnd, place.textContent];
  }), [true, true, 2, 3, "warningbac"]);
});

test("what others put into a foreign element stays, also a view of their own", async () => {
  assert.equal(await inPage(({ h, patch }, place) => {
    const draw = (word) => patch(place, [h("p", null, word), h("div", { foreign: true, mounted: (inside) => patch(inside, [h("b", null, "inside")]) })]);
    draw("before");
    place.querySelector("div").append("!");
    draw("after");
    return place.innerHTML;
  }), "<p>after</p><div><b>inside</b>!</div>");
});

test("attributes: false takes one away, in aria- ones it is a word; numbers and styles are set", async () => {
  assert.deepEqual(await inPage(({ h, patch }, place) => {
    const draw = (is) => patch(place, [h("button.a.b", { attributes: { disabled: is, "aria-expanded": is, tabindex: is ? 0 : undefined }, style: { "--share": is ? "1" : "2", "border-left-color": is ? "red" : "blue" } }), h("svg", { attributes: { viewBox: "0 0 1 1" } }, h("circle.dot", { attributes: { r: is ? 1 : 2 } }))]);
    const read = () => [...place.firstChild.attributes].map((one) => `${one.name}=${one.value}`).sort().concat(place.querySelector("circle").getAttribute("r"), place.lastChild.namespaceURI);
    draw(true);
    const first = read();
    draw(false);
    return [first, read()];
  }), [
    ["aria-expanded=true", "class=a b", "disabled=", "style=--share: 1; border-left-color: red;", "tabindex=0", "1", "http://www.w3.org/2000/svg"],
    ["aria-expanded=false", "class=a b", "style=--share: 2; border-left-color: blue;", "2", "http://www.w3.org/2000/svg"],
  ]);
});

test("texts are texts, and marks that turn the direction of writing are visible", async () => {
  assert.equal(await inPage(({ h, patch }, place) => {
    patch(place, [h("p", null, "<b>a</b>\u202eb", 0, false, null, "")]);
    return place.innerHTML;
  }), "<p>&lt;b&gt;a&lt;/b&gt;\ufffdb0</p>");
});

test("after clear, all nodes are new, whatever was in the element", async () => {
  assert.deepEqual(await inPage(({ h, patch, clear }, place) => {
    patch(place, [h("p", null, "a")]);
    const old = place.firstChild;
    place.append(document.createElement("hr"));
    clear(place);
    const left = place.childNodes.length;
    patch(place, [h("p", null, "b")]);
    return [left, place.innerHTML, place.firstChild === old];
  }), [0, "<p>b</p>", false]);
});
