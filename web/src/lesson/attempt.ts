// SPDX-License-Identifier: BSD-2-Clause
import type { Check, Mission, Time } from "../run/contents";

/** The part of a browser's storage that is used; tests give their own. */
export interface Shelf {
  getItem(key: string): string | null;
  setItem(key: string, value: string): void;
}

const TRIED = "soarbox.tried.", RESTARTS = "soarbox.restarts", NO = "no";

/** The learner's changes to the rules of this run. The display of checks depends on them. */
export class Attempt {
  private what = "";
  /** Tick at which the rules of the running world changed; null: they have not changed since its beginning. */
  changedAt: number | null = null;

  constructor(private readonly shelf: Shelf) {}

  /** Called when a run begins or this page joins one. Returns whether the same world has begun again. */
  begin(what: string): boolean {
    const isSame = what === this.what;
    this.what = what;
    this.changedAt = null;
    return isSame;
  }

  get isLesson(): boolean {
    return this.what.startsWith("lesson:");
  }

  /** Whether the learner has changed anything in this lesson yet, or had it graded. Always true for other worlds. */
  get isTried(): boolean {
    return !this.isLesson || this.shelf.getItem(TRIED + this.what) !== null;
  }

  note(): void {
    if (this.isLesson && !this.isTried) this.shelf.setItem(TRIED + this.what, "yes");
  }

  /** Rules were changed at this tick of the run, without errors. */
  applied(tick: number): void {
    this.note();
    this.changedAt = tick;
  }

  /** Whether a lesson's run begins again with each Apply. */
  get restarts(): boolean {
    return this.shelf.getItem(RESTARTS) !== NO;
  }

  set restarts(isOn: boolean) {
    this.shelf.setItem(RESTARTS, isOn ? "yes" : NO);
  }
}

export type Standing = "passed" | "failed" | "open";

/** The state of a check at the moment that is shown. It is open if it was decided after that moment, in a discarded future, or
 * with rules that have been changed since. A check that failed is also open while the learner has not tried anything.
 */
export function standingOf(check: Check, time: Pick<Time, "shown_tick" | "is_live" | "branch_tick"> | undefined, attempt: Pick<Attempt, "changedAt" | "isTried">): Standing {
  if (check.state !== "true" && check.state !== "false") return "open";
  if (time !== undefined && !time.is_live && check.tick > time.shown_tick) return "open";
  if (time !== undefined && time.branch_tick !== null && check.tick > time.branch_tick) return "open";
  if (attempt.changedAt !== null && check.tick <= attempt.changedAt) return "open";
  if (check.state === "true") return "passed";
  return attempt.isTried ? "failed" : "open";
}

/** How many of the checks that count are passed at the moment that is shown. */
export function passedOf(mission: Mission, time: Time | undefined, attempt: Attempt): { passed: number; of: number } {
  const counted = mission.checks.filter((one) => !one.is_marker);
  return { passed: counted.filter((one) => standingOf(one, time, attempt) === "passed").length, of: counted.length };
}

/** The reason why some checks are not decided; "": all are. */
export function whyOpen(time: Time | undefined, attempt: Attempt): string {
  if (time !== undefined && time.branch_tick !== null && time.is_live) return "You went on from an earlier moment. Checks follow a run from its beginning.";
  if (attempt.changedAt !== null) return "The rules changed while the world ran. Checks follow a run from its beginning.";
  return "";
}
