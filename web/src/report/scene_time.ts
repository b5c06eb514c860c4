// SPDX-License-Identifier: BSD-2-Clause
import type { RecordedRun } from "../run/file_source";
import type { Run } from "../run/run";
import type { Time } from "./time";

/** The moment that a run shows in 3D. */
export class SceneTime implements Time {
  readonly end: number;

  constructor(private readonly run: Run, private readonly recorded: Pick<RecordedRun, "first_tick" | "last_tick" | "step_s">) {
    this.end = Math.max(recorded.last_tick * recorded.step_s, 0.1);
  }

  get now(): number {
    return this.run.flow.time_s;
  }

  get isPlaying(): boolean {
    return !this.run.flow.paused;
  }

  go(seconds: number): void {
    const tick = Math.round(seconds / this.recorded.step_s);
    this.run.ask("seek", { tick: Math.min(this.recorded.last_tick, Math.max(this.recorded.first_tick, tick)) });
  }

  play(isOn: boolean): void {
    if (isOn !== this.isPlaying) this.run.ask("flow", { what: isOn ? "go-on" : "pause" });
  }

  on(call: () => void): void {
    this.run.on("flow", call);
  }
}
