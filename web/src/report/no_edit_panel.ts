// SPDX-License-Identifier: BSD-2-Clause
import type { EditPanel as Editor } from "../editor/edit_panel";
import { infoOf } from "../panels/panel";

/** Replaces the editor in pages of recorded runs (build.mjs). The editor would be a third of such a page. */
export class EditPanel implements Pick<Editor, keyof Editor> {
  readonly word = "edit";
  readonly title = infoOf("edit").title;
  readonly about = infoOf("edit").about;
  readonly uses = ["edit", "moment", "mission"] as const;
  readonly isUnsaved = false;
  readonly restarts = false;
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
