// SPDX-License-Identifier: BSD-2-Clause

/** What the run says about the file that is shown. */
interface ShownFile {
  readonly file: string;
  readonly text: string;
  readonly reload_count?: number;
  readonly problems: readonly { readonly severity: string }[];
}

/** Rules that were sent to be applied, until the run has answered. */
export class Applying {
  private sent: { file: string; text: string; reloads: number } | null = null;

  /** The text was sent for the file that is shown. `reload_count`: how often the run had reloaded this file before. */
  begin(shown: ShownFile, text: string): void {
    this.sent = { file: shown.file, text, reloads: shown.reload_count ?? 0 };
  }

  /** Whether the run has just reloaded the file. Nothing is awaited any more if it has, if the text has errors, or if another file is shown. */
  isDone(shown: ShownFile | undefined): boolean {
    if (this.sent === null || shown === undefined) return false;
    const { file, text, reloads } = this.sent, isHere = shown.file === file, isReloaded = isHere && (shown.reload_count ?? 0) !== reloads;
    const hasErrors = shown.text === text && shown.problems.some((one) => one.severity === "error");
    if (!isHere || isReloaded || hasErrors) this.sent = null;
    return isReloaded;
  }
}
