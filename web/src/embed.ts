// SPDX-License-Identifier: BSD-2-Clause
// For pages of other sites (docs/serve.md#in-a-page-of-your-own): <soarbox-world src="https://server/#world=soar_evade">
// becomes a live world when it is clicked. This script does not import other modules.

const PANELS = ["agents", "mind", "why", "memory", "rules", "links", "timeline", "trace", "messages", "output", "edit", "mission", "console", "watch", "plots"];

/** The address of the frame; null: `src` names no lesson or world. `server`: origin of the script, for a `src` that begins with #. */
export function frameAddress(src: string, panels: string, server: string): string | null {
  let url: URL;
  try {
    url = new URL(src, server);
  } catch {
    return null;
  }
  const fields = new URLSearchParams(url.hash.slice(1));
  if ((url.protocol !== "http:" && url.protocol !== "https:") || !["world", "lesson"].some((name) => (fields.get(name) ?? "") !== "")) return null;
  const shown = panels.split(/[\s,]+/).filter((word) => PANELS.includes(word));
  if (shown.length > 0) fields.set("panels", shown.join());
  return `${url.origin}/embed#${fields.toString()}`;
}

if (typeof customElements !== "undefined") {
  const server = document.currentScript instanceof HTMLScriptElement ? document.currentScript.src : location.href;
  customElements.define("soarbox-world", class extends HTMLElement {
    connectedCallback(): void {
      if (this.shadowRoot !== null) return;
      const shadow = this.attachShadow({ mode: "open" }), address = frameAddress(this.getAttribute("src") ?? "", this.getAttribute("panels") ?? "", server);
      const style = document.createElement("style"), button = document.createElement("button");
      style.textContent = ":host{display:block;height:30rem;border:1px solid #9aa7b5;border-radius:8px;overflow:hidden;background:#14324c}button,iframe{width:100%;height:100%;border:0;display:block}button{background:none;color:#fff;font:600 1.05rem system-ui,sans-serif;cursor:pointer}button:focus-visible{outline:3px solid #f5b53d;outline-offset:-6px}";
      button.type = "button";
      const name = new URLSearchParams((address ?? "").replace(/^[^#]*#/, ""));
      button.textContent = address === null ? "This world cannot be shown: its src names no world or lesson of a Soarbox server." : `▶ ${this.getAttribute("label") ?? `Start ${name.get("world") ?? name.get("lesson") ?? ""}`}`;
      button.disabled = address === null;
      button.addEventListener("click", () => {
        const frame = document.createElement("iframe");
        frame.src = address ?? "";
        frame.title = `A live world: ${name.get("world") ?? name.get("lesson") ?? ""}`;
        frame.allow = "fullscreen; clipboard-write";
        button.replaceWith(frame);
        frame.focus();
      });
      shadow.append(style, button);
    }
  });
}
