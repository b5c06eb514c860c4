// SPDX-License-Identifier: BSD-2-Clause
import type { EditPanel as Editor } from "../editor/edit_panel";

/** A recorded run is not edited: on its page this stands in the place of the editor (build.mjs), which is a third of all that it would hold. */
export class EditPanel implements Pick<Editor, keyof Editor> {
  readonly word = "edit";
  readonly title = "Rules' text";
  readonly about = "Change rules and reload them while the world runs.";
  readonly uses = ["edit", "moment", "mission"] as const;
  readonly isUnsaved = false;
  readonly text = null;
  readonly where = null;
  badge(): string {
    return "";
  }
  view(): null {
    return null;
  }
  take(): void {}
  flush(): void {}
  focus(): void {}
  async offer(): Promise<void> {}
  showFile(): void {}
  apply(): void {}
}
