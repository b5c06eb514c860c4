// SPDX-License-Identifier: BSD-2-Clause
// The service worker of a site without a server: after the first visit, the site works without a network. A newer version of the
// site is loaded next to the current one, and replaces it as soon as no tab shows the old one.

/** All files of the site, and a version identifier; both come from build_site.mjs. */
declare const SOARBOX_FILES: readonly string[];
declare const SOARBOX_VERSION: string;

interface Life extends Event { waitUntil(done: Promise<unknown>): void }
interface Fetch extends Life { request: Request; respondWith(response: Promise<Response>): void }
const scope = self as unknown as {
  registration: { scope: string };
  addEventListener(type: "install" | "activate", call: (event: Life) => void): void;
  addEventListener(type: "fetch", call: (event: Fetch) => void): void;
};

// An origin may have several sites, below different paths.
const OURS = `soarbox ${scope.registration.scope} `, CACHE = OURS + SOARBOX_VERSION;

scope.addEventListener("install", (event) => event.waitUntil(caches.open(CACHE).then((cache) => cache.addAll(SOARBOX_FILES))));
scope.addEventListener("activate", (event) => event.waitUntil(caches.keys().then((names) => Promise.all(names.filter((name) => name.startsWith(OURS) && name !== CACHE).map((name) => caches.delete(name))))));
scope.addEventListener("fetch", (event) => {
  if (event.request.method !== "GET" || !event.request.url.startsWith(scope.registration.scope)) return;
  event.respondWith(caches.open(CACHE).then((cache) => cache.match(event.request, { ignoreSearch: true })).then((kept) => kept ?? fetch(event.request)));
});
