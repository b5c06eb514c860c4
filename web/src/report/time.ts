// SPDX-License-Identifier: BSD-2-Clause

/** The moment that a run's report shows: all its pictures follow it. */
export interface Time {
  /** In seconds, like all times here. */
  readonly end: number;
  readonly now: number;
  readonly isPlaying: boolean;
  go(seconds: number): void;
  play(isOn: boolean): void;
  /** Registers a function that is called when the moment changes, or playing starts or ends. */
  on(call: () => void): void;
}

const STEP_S = 0.1;

/** A separate time, for runs without a 3D view. */
export class OwnTime implements Time {
  now = 0;
  private timer: ReturnType<typeof setInterval> | null = null;
  private readonly calls: (() => void)[] = [];

  constructor(readonly end: number) {}

  get isPlaying(): boolean {
    return this.timer !== null;
  }

  go(seconds: number): void {
    this.now = Math.min(this.end, Math.max(0, seconds));
    this.tell();
  }

  play(isOn: boolean): void {
    if (this.timer !== null) clearInterval(this.timer);
    this.timer = null;
    if (isOn) {
      if (this.now >= this.end) this.now = 0;
      this.timer = setInterval(() => {
        if (this.now + STEP_S >= this.end) this.play(false);
        this.go(this.now + STEP_S);
      }, STEP_S * 1000);
    }
    this.tell();
  }

  on(call: () => void): void {
    this.calls.push(call);
  }

  private tell(): void {
    for (const call of this.calls) call();
  }
}
