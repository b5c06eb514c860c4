// SPDX-License-Identifier: BSD-2-Clause

/** The level of detail of pictures. */
export interface Quality {
  /** Pixels of the picture for each pixel of the page, at most. */
  readonly ratio: number;
  readonly shadowSide: number;
  /** Shadows are updated in every n-th picture. */
  readonly shadowsEvery: number;
  /** The processor draws: cheaper light, coarser bodies, fewer pictures. */
  readonly isSlow: boolean;
  /** In seconds: pictures that take longer than `tooSlow` are too slow; if they take less than `hasRoom`, more detail is possible. */
  readonly tooSlow: number;
  readonly hasRoom: number;
}

/** Pause between two pictures if the processor draws, because it also has other work. */
export const SLOW_EVERY_MS = 60;
const card = { isSlow: false, shadowSide: 2048, shadowsEvery: 1, tooSlow: 0.055, hasRoom: 0.025 };
const processor = { isSlow: true, shadowSide: 1024, shadowsEvery: 3, tooSlow: 0.076, hasRoom: 0.07 };
/** Levels of detail, from the best to the cheapest. */
export const QUALITIES: readonly Quality[] = [
  { ...card, ratio: 2 }, { ...card, ratio: 1 },
  { ...processor, ratio: 1 }, { ...processor, ratio: 0.75 }, { ...processor, ratio: 0.6 }, { ...processor, ratio: 0.5, shadowSide: 512, shadowsEvery: 6 },
];
export const FIRST_OF_PROCESSOR = 3;

const FRAMES_TO_JUDGE = 20, FEW_FRAMES = 4, VERY_SLOW = 2;
/** Number of consecutive fast pictures before more detail is tried; it doubles after each failed try. */
const FIRST_PATIENCE = 100, MOST_PATIENCE = 3200, SOON = 3 * FRAMES_TO_JUDGE;

/** Chooses the detail by the time of pictures: less if they are slow, and more again if there is time. */
export class Governor {
  private times: number[] = [];
  private good = 0;
  private patience = FIRST_PATIENCE;
  private sinceRaised = Infinity;

  /** `isFixed`: the detail never changes. */
  constructor(private step = 0, private readonly isFixed = false) {}

  get quality(): Quality {
    return QUALITIES[this.step]!;
  }

  /** Reports the seconds between two pictures. Returns true if the detail has changed. */
  note(seconds: number): boolean {
    if (this.isFixed) return false;
    this.times.push(seconds);
    this.sinceRaised += 1;
    const { tooSlow, hasRoom } = this.quality, isVerySlow = this.times.length >= FEW_FRAMES && this.times.every((one) => one > VERY_SLOW * tooSlow);
    if (this.times.length < FRAMES_TO_JUDGE && !isVerySlow) return false;
    const median = [...this.times].sort((a, b) => a - b)[Math.floor(this.times.length / 2)]!, count = this.times.length;
    this.times = [];
    this.good = median < hasRoom ? this.good + count : 0;
    if (median > tooSlow) return this.lower(isVerySlow);
    if (this.good < this.patience) return false;
    this.good = 0;
    return this.raise();
  }

  private lower(isVerySlow: boolean): boolean {
    if (this.step === QUALITIES.length - 1) return false;
    if (this.sinceRaised < SOON) this.patience = Math.min(2 * this.patience, MOST_PATIENCE);
    const isCard = !this.quality.isSlow;
    this.step = isCard && isVerySlow ? FIRST_OF_PROCESSOR : this.step + 1;
    return true;
  }

  /** Never changes between the levels for a processor and for a card, because all materials would have to be created again. */
  private raise(): boolean {
    const better = QUALITIES[this.step - 1];
    if (better === undefined || better.isSlow !== this.quality.isSlow) return false;
    this.step -= 1;
    this.sinceRaised = 0;
    return true;
  }
}
