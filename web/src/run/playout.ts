// SPDX-License-Identifier: BSD-2-Clause
import type { Scene } from "../format/scene";

const MOST_KEPT = 12, JUMP_S = 1.5, CATCH_UP_PER_S = 5;

export interface Between { before: Scene; after: Scene; share: number }

/** Plays the moments of a run with a small delay, so that there is one before and one after the moment that is
 * drawn. The clock runs at the rate at which moments arrive, and adapts gradually if they come early or late.
 */
export class Playout {
  private scenes: Scene[] = [];
  private shown = 0;
  private rate = 1;
  private lastArrival = 0;
  private spacing = 1 / 15;

  /** `now`: seconds of a clock that only grows. */
  add(scene: Scene, now: number): void {
    const last = this.scenes.at(-1);
    if (last !== undefined && (scene.time < last.time || scene.time > last.time + JUMP_S)) {
      this.scenes = [];
    } else if (last !== undefined && scene.time === last.time) {
      this.scenes[this.scenes.length - 1] = scene;
      return;
    }
    if (this.scenes.length === 0) {
      this.scenes = [scene];
      this.shown = scene.time;
      this.lastArrival = now;
      return;
    }
    const wall = now - this.lastArrival, world = scene.time - last!.time;
    this.lastArrival = now;
    if (wall > 0.002 && wall < 1) this.rate += 0.2 * (Math.min(world / wall, 64) - this.rate);
    this.spacing += 0.2 * (world - this.spacing);
    this.scenes.push(scene);
    if (this.scenes.length > MOST_KEPT) this.scenes.shift();
  }

  clear(): void {
    this.scenes = [];
  }

  /** Advances by some seconds of real time. While paused, it stops at the newest moment. Null: there is none. */
  advance(seconds: number, paused: boolean): Between | null {
    const newest = this.scenes.at(-1);
    if (newest === undefined) return null;
    const target = newest.time - (paused ? 0 : 1.2 * this.spacing);
    this.shown += paused ? 0 : seconds * this.rate;
    this.shown += (target - this.shown) * Math.min(1, seconds * CATCH_UP_PER_S);
    if (paused && Math.abs(target - this.shown) < 0.002) this.shown = target;
    this.shown = Math.min(Math.max(this.shown, this.scenes[0]!.time), newest.time);
    const index = this.scenes.findIndex((scene) => scene.time >= this.shown);
    const after = this.scenes[Math.max(index, 0)]!, before = this.scenes[Math.max(index - 1, 0)]!;
    const span = after.time - before.time;
    return { before, after, share: span > 0 ? Math.min(Math.max((this.shown - before.time) / span, 0), 1) : 1 };
  }

  /** Simulated seconds per second of real time. */
  get pace(): number {
    return this.rate;
  }

  get time(): number {
    return this.shown;
  }
}
