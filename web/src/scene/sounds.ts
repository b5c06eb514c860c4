// SPDX-License-Identifier: BSD-2-Clause
import { Vector3, type PerspectiveCamera } from "three";
import type { Sound, Vec3 } from "../format/scene";
import type { Assets } from "./assets";

/** Up to this distance a sound has its full volume; twice as far away it has half of it. The same in the window. */
export const FULL_VOLUME_M = 5;

/**
 * The volumes of a sound on the left and on the right, each 0 to 1. `right` is the camera's direction to the right.
 */
export function heardAt(volume: number, place: Vec3 | null, ear: Vec3, right: Vec3): { left: number; right: number } {
  if (place === null) return { left: volume, right: volume };
  const way = [place[0] - ear[0], place[1] - ear[1], place[2] - ear[2]] as const, away = Math.hypot(...way);
  const loud = volume * Math.min(1, FULL_VOLUME_M / Math.max(away, 1e-3));
  const side = away < 1e-3 ? 0 : (way[0] * right[0] + way[1] * right[1] + way[2] * right[2]) / away;
  return { left: loud * Math.min(1, 1 - side), right: loud * Math.min(1, 1 + side) };
}

/** Plays each sound of a run once. Browsers allow sounds only after the user has clicked or pressed a key. */
export class Sounds {
  isOn = true;
  /** The number of sounds that were started; for tests. */
  played = 0;
  private context: AudioContext | null = null;
  private last: number | null = null;
  private readonly buffers = new Map<string, Promise<AudioBuffer>>();

  constructor(private readonly assets: Assets) {
    for (const kind of ["pointerdown", "keydown"] as const) addEventListener(kind, () => this.begin(), { once: true, capture: true });
  }

  private begin(): void {
    this.context ??= typeof AudioContext === "undefined" ? null : new AudioContext();
  }

  /** `isLive`: new sounds are played. Past moments are silent. */
  take(sounds: readonly Sound[], camera: PerspectiveCamera, isLive: boolean): void {
    const newest = sounds.at(-1)?.id ?? this.last ?? 0, before = this.last;
    // Sounds that began before the page was opened, and sounds after a jump back, are not played.
    this.last = newest;
    if (before === null || newest < before || !isLive || !this.isOn) return;
    for (const sound of sounds) if (sound.id > before) void this.play(sound, camera);
  }

  clear(): void {
    this.last = null;
    this.buffers.clear();
  }

  private async play(sound: Sound, camera: PerspectiveCamera): Promise<void> {
    const context = this.context, bytes = this.assets.bytes(sound.file);
    if (context === null || bytes === null) return;
    let decoded = this.buffers.get(sound.file);
    if (decoded === undefined) this.buffers.set(sound.file, (decoded = context.decodeAudioData(bytes.slice().buffer)));
    const { x, y, z } = camera.position, right = new Vector3(1, 0, 0).applyQuaternion(camera.quaternion);
    const heard = heardAt(sound.volume, sound.place, [x, y, z], [right.x, right.y, right.z]);
    const source = context.createBufferSource(), merger = context.createChannelMerger(2);
    try {
      source.buffer = await decoded;
    } catch {
      return;  // The world has checked the file, so only this browser cannot decode it.
    }
    for (const [channel, volume] of [heard.left, heard.right].entries()) {
      const gain = context.createGain();
      gain.gain.value = volume;
      source.connect(gain).connect(merger, 0, channel);
    }
    merger.connect(context.destination);
    source.start();
    this.played += 1;
  }
}
