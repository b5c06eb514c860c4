// SPDX-License-Identifier: BSD-2-Clause
import type { Run } from "../run/run";

/** Moves a run to the moment in an address: back, or forward at full speed. Then pauses it. */
export class Reach {
  private tick: number | null = null;
  private isFast = false;
  /** Called when the moment is reached. */
  private then: (() => void) | null = null;

  constructor(private readonly run: Run) {
    run.on("flow", () => this.tryIt());
    run.on("contents", (names) => names.includes("moment") && this.tryIt());
  }

  start(seconds: number, then: (() => void) | null = null): void {
    const { hello } = this.run;
    if (hello === null || !hello.may_edit) return;
    this.tick = Math.round(seconds / hello.step_s);
    this.isFast = false;
    this.then = then;
    this.tryIt();
  }

  get isUnderWay(): boolean {
    return this.tick !== null;
  }

  /** Gives up, because the user has opened something else. */
  forget(): void {
    this.tick = this.then = null;
  }

  private tryIt(): void {
    const { run, tick } = this, time = run.contents.moment?.time;
    if (tick === null || time === undefined || run.hello === null) return;
    if (time.is_recording || Math.max(time.last_tick, run.flow.tick) >= tick) {
      const { then } = this;
      this.tick = this.then = null;
      if (then !== null && !run.flow.paused) run.ask("flow", { what: "pause" });
      if (this.isFast) run.ask("flow", { what: "normal-speed" });
      run.ask("seek", { tick: Math.min(tick, time.is_recording ? time.last_tick : tick) });
      then?.();
    } else if (!this.isFast) {
      this.isFast = true;
      run.ask("flow", { what: "unlimited" });
      if (run.flow.paused) run.ask("flow", { what: "go-on" });
    }
  }
}
