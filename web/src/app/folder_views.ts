// SPDX-License-Identifier: BSD-2-Clause
import { button, h, type Child, type View } from "../dom/view";
import type { UserFolders } from "../local/user_folders";

export interface FolderViewEvents {
  /** Lets the user choose a folder, and opens its world. */
  choose(): void;
  /** Connects the folder of a world, and opens the world. */
  open(world: string): void;
  forget(world: string): void;
}

/** The section of the start page with folders of the user's disk. */
export function folderSection(folders: UserFolders, events: FolderViewEvents): View {
  return h("section.kept", { key: "folders", attributes: { "aria-label": "Folders of your disk" } }, h("h2", null, "Folders of your disk"),
    h("p.quiet", null, "Open the folder of a world on this machine. What you save here is written to it, and what you save there with another editor runs here."),
    folders.all.length > 0 && h("ul.plain.folders", null, folders.all.map((one) => h("li.row", { key: one.name }, button(one.title, () => events.open(one.name), { attributes: { title: `Open the world in ${one.title}` } }, "button.link"),
      one.name !== one.title && h("span.quiet", null, one.name),
      button("Forget", () => events.forget(one.name), { attributes: { "aria-label": `Forget the folder ${one.title}`, title: "Removes the copy in this browser. The folder on the disk stays as it is." } }, "button.small")))),
    h("div.row", null, button("Open a folder of your disk", events.choose)));
}

/** The state of the open world's folder, for the bar at the top. */
export function folderPill(folders: UserFolders, world: string, connect: () => void): Child {
  const folder = folders.stateOf(world);
  if (folder === null) return null;
  const { title, state, problem } = folder;
  if (state === "connected") return h("span.pill.folder", { key: "folder", attributes: { title: `What you save is written to the folder ${title}` } }, h("span", null, `Folder ${title}`));
  return h(`span.pill.folder${state === "trouble" ? ".lost" : ""}`, { key: "folder", attributes: { role: "status", title: problem === null ? `The browser must be asked again before the page may change the folder ${title}` : `${problem.message} ${problem.hint}` } },
    h("span", null, state === "trouble" ? "Folder not written" : "Folder not connected"), button("Connect", connect, { attributes: { "aria-label": `Connect the folder ${title}` } }, "button.link"));
}
