// SPDX-License-Identifier: BSD-2-Clause
import { Api, Refused, takeToken, type PlaceInfo } from "./app/api";
import { parseAddress, unpackFiles } from "./app/address";
import { App } from "./app/app";
import { applyTheme, themeNow } from "./app/theme";
import { ClassTable } from "./class/class_table";
import { button, clear, h, patch } from "./dom/view";
import type { Port } from "./local/worker_source";

const PLACE_KEY = "soarbox.place";

/** The place of the address; at "/", the last one of this browser, or a new one. */
async function findPlace(api: Api): Promise<PlaceInfo> {
  const named = /^\/p\/([^/]+)\/?$/.exec(location.pathname)?.[1];
  if (named !== undefined) return api.json<PlaceInfo>(`/api/p/${encodeURIComponent(named)}`);
  const kept = localStorage.getItem(PLACE_KEY);
  if (kept !== null) {
    try {
      return await api.json<PlaceInfo>(`/api/p/${encodeURIComponent(kept)}`);
    } catch (error) {
      if (!(error instanceof Refused) || error.status !== 404) throw error;
    }
  }
  const made = await api.json<{ place: string }>("/api/places", { method: "POST" });
  return api.json<PlaceInfo>(`/api/p/${encodeURIComponent(made.place)}`);
}

/** The place of an embedded world. Each world of the embedding page has its own place, because a place has one run. */
async function embeddedPlace(api: Api, what: string): Promise<PlaceInfo> {
  const key = `${PLACE_KEY}.embedded.${what}`, kept = localStorage.getItem(key);
  if (kept !== null) {
    try {
      return await api.json<PlaceInfo>(`/api/p/${encodeURIComponent(kept)}`);
    } catch (error) {
      if (!(error instanceof Refused) || error.status !== 404) throw error;
    }
  }
  const { place } = await api.json<{ place: string }>("/api/places", { method: "POST" });
  localStorage.setItem(key, place);
  return api.json<PlaceInfo>(`/api/p/${encodeURIComponent(place)}`);
}

/**
 * Shows an error instead of the page. `canMove`: another page may work, such as another place at the root of the
 * server.
 */
function tell(root: HTMLElement, error: unknown, canMove = location.pathname !== "/", elsewhere = "/", itsName = "A new place"): void {
  const told = error as { message?: string; hint?: string };
  clear(root);
  patch(root, [h("main.start", null, h("section.welcome", { attributes: { role: "alert" } }, h("div", null, h("h1", null, "This page cannot be shown"), h("p", null, told.message ?? String(error)), told.hint !== undefined && told.hint !== "" && h("p.quiet", null, told.hint),
    h("div.row", null, button("Try again", () => location.reload(), {}, "button.primary"), canMove && button(itsName, () => location.assign(elsewhere))))))]);
}

/** The contents of an element of a single-file page: compressed data in base64. */
async function partOf(id: string): Promise<ArrayBuffer> {
  const bytes = Uint8Array.from(atob(document.getElementById(id)?.textContent ?? ""), (letter) => letter.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
}

/**
 * Starts a page without a server: its engine is a worker, and its place is in this browser. `engine`: the folder of
 * the engine; empty: the page contains it.
 */
async function beginLocal(root: HTMLElement, engine: string): Promise<void> {
  patch(root, [h("main.start", null, h("section.welcome", { attributes: { role: "status" } }, h("div", null, h("h1", null, "Soarbox"), h("p", null, "The engine is loaded …"))))]);
  try {
    const { LocalApi, LocalPlace } = await import("./local/worker_source"), { foldersOf } = await import("./local/browser_folders"), { takePlaceLock } = await import("./local/place_lock");
    const inPage = document.getElementById("soarbox-worker")?.textContent;
    const worker = inPage === undefined || inPage === null ? new URL("assets/worker.js", document.baseURI).href : URL.createObjectURL(new Blob([inPage], { type: "text/javascript" }));
    const files = engine === "" ? { wasm: await partOf("soarbox-wasm"), data: await partOf("soarbox-data") } : new URL(engine, document.baseURI).href;
    const { what, rules } = parseAddress(location.hash), brought = rules === "" ? null : await unpackFiles(rules);
    if (rules !== "" && brought === null) throw new Refused("The rules in this link are damaged: it may have been cut off.", "Ask for the link again.", 0);
    // An experiment has a place of its own.
    const isOnly = brought !== null || (await takePlaceLock());
    const place = new LocalPlace(() => new Worker(worker) as unknown as Port, files, true, brought === null ? undefined : { what, files: brought }, isOnly);
    const folders = brought === null ? foldersOf(place) : null, api = new LocalApi(place, folders);
    document.addEventListener("visibilitychange", () => {
      if (document.visibilityState === "hidden") place.keepNow();
      folders?.lookNow();
    });
    addEventListener("focus", () => folders?.lookNow());
    const info = await api.json<PlaceInfo>("/api/p/local");
    clear(root);
    new App(root, api, info, brought === null ? {} : { experiment: { packed: rules, names: Object.keys(brought) } });
    // From the second visit on, the site works without a network, unless the browser does not support this (without TLS).
    if (engine !== "") void navigator.serviceWorker?.register(new URL("offline.js", document.baseURI)).catch(() => undefined);
  } catch (error) {
    tell(root, error, location.hash !== "", location.href.replace(/#.*$/, ""), "Lessons and worlds");
  }
}

async function begin(): Promise<void> {
  applyTheme(themeNow());
  const root = document.getElementById("page");
  if (root === null) return;
  // The address of the engine, in a page without a server.
  const engine = document.querySelector<HTMLMetaElement>("meta[name=soarbox-engine]")?.content;
  if (engine !== undefined) return beginLocal(root, engine);
  const api = new Api(takeToken(location, history, sessionStorage));
  const classKey = /^\/class\/([^/]+)\/?$/.exec(location.pathname)?.[1];
  if (classKey !== undefined) {
    new ClassTable(root, api, decodeURIComponent(classKey));
    return;
  }
  const fields = new URLSearchParams(location.hash.slice(1)), watchKey = fields.get("watch") ?? "";
  const link = /^\/w\/([^/]+)\/?$/.exec(location.pathname)?.[1];
  try {
    if (location.pathname === "/embed") {
      const panels = (fields.get("panels") ?? "").split(",").filter((word) => word !== "");
      const info = await embeddedPlace(api, parseAddress(location.hash).what);
      root.replaceChildren();
      new App(root, api, info, { panels });
      return;
    }
    if (link !== undefined) {
      const info = await api.json<PlaceInfo>(`/api/w/${encodeURIComponent(link)}`);
      root.replaceChildren();
      new App(root, api, info, { link });
      return;
    }
    const info = await findPlace(api);
    if (watchKey === "") localStorage.setItem(PLACE_KEY, info.place);
    const path = `/p/${info.place}/`;
    if (location.pathname !== path) history.replaceState(null, "", path + location.search + location.hash);
    root.replaceChildren();
    new App(root, api, info, watchKey === "" ? {} : { key: watchKey });
  } catch (error) {
    tell(root, error);
  }
}

void begin();
