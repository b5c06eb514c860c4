// SPDX-License-Identifier: BSD-2-Clause
import type { Vec3 } from "../format/scene";
import { comfortable, eyeOf, framingView, isInside, middleOf, withinReach, withPlaces, type FramedBody, type Lens, type View } from "./framing";
import { length, minus, plus, times } from "./vectors";

/** The camera moves if a body will leave this share of the picture within SOON_S seconds. */
const INSIDE = 0.93, SOON_S = 0.8;
/** In its new pose, the picture has room for the motion of bodies during this time. */
const ROOM_S = 1.6;
/** The picture is too wide if the camera could be nearer by this factor; after WIDE_FOR_S seconds it moves there. */
const TOO_WIDE = 0.6, WIDE_FOR_S = 2.5;
/** How long recent positions of agents are stored, and the interval between them. */
const RECENT_S = 3, RECENT_STEP_S = 0.25;

const later = (body: FramedBody, seconds: number): Vec3 => plus(body.place, times([body.velocity[0], 0, body.velocity[2]], seconds));

/** Determines where the camera must go so that all agents stay in the picture. Small movements of agents do not move the
 * camera. It never turns the camera. The window has the same rules (src/viewer/camera_keeper.h).
 */
export class CameraKeeper {
  private wideS = 0;

  begin(): void {
    this.wideS = 0;
  }

  /** `goal`: current or target pose of the camera. Returns the new goal; null: the current one is good. */
  follow(agents: readonly FramedBody[], places: readonly Vec3[], goal: View, lens: Lens, seconds: number, scenery: readonly FramedBody[] = [], isFixedTilt = false): View | null {
    if (agents.length === 0) return null;
    const tilt = isFixedTilt ? goal.tilt : comfortable(goal.tilt), kept = withinReach(agents, goal.heading, tilt, lens);
    const frame = (): View => {
      const withRoom = [...kept, ...kept.filter((one) => one.velocity[0] !== 0 || one.velocity[2] !== 0).map((one) => ({ ...one, place: later(one, ROOM_S) }))];
      return framingView(withPlaces(withRoom, places, goal.heading, tilt, lens, scenery), goal.heading, tilt, lens);
    };
    if (!kept.every((one) => isInside(one, one.place, goal, lens, INSIDE) && isInside(one, later(one, SOON_S), goal, lens, INSIDE))) {
      this.wideS = 0;
      return frame();
    }
    const near = frame(), middle = middleOf(kept);
    this.wideS = length(minus(eyeOf(near), middle)) < TOO_WIDE * length(minus(eyeOf(goal), middle)) ? this.wideS + seconds : 0;
    if (this.wideS < WIDE_FOR_S) return null;
    this.wideS = 0;
    return near;
  }
}

interface Span { low: Vec3; high: Vec3; ageS: number }

const lowest = (a: Vec3, b: Vec3): Vec3 => [Math.min(a[0], b[0]), Math.min(a[1], b[1]), Math.min(a[2], b[2])];
const highest = (a: Vec3, b: Vec3): Vec3 => [Math.max(a[0], b[0]), Math.max(a[1], b[1]), Math.max(a[2], b[2])];

/** Positions of agents in the last seconds of real time. In a world that runs fast, they predict future positions better than velocities. */
export class RecentGround {
  private spans: Span[] = [];

  note(agents: readonly FramedBody[], seconds: number): void {
    for (const span of this.spans) span.ageS += seconds;
    this.spans = this.spans.filter((span) => span.ageS <= RECENT_S);
    const first = agents[0];
    if (first === undefined) return;
    let last = this.spans.at(-1);
    if (last === undefined || last.ageS > RECENT_STEP_S) this.spans.push((last = { low: first.place, high: first.place, ageS: 0 }));
    for (const { place } of agents) last.low = lowest(last.low, place), last.high = highest(last.high, place);
  }

  forget(): void {
    this.spans = [];
  }

  /** The corners of the area, as bodies that must be in the picture. */
  corners(): FramedBody[] {
    if (this.spans.length === 0) return [];
    const low = this.spans.map((one) => one.low).reduce(lowest), high = this.spans.map((one) => one.high).reduce(highest);
    return [low[0], high[0]].flatMap((x) => [low[2], high[2]].map((z): FramedBody => ({ place: [x, low[1], z], velocity: [0, 0, 0], radius: 0.35, height: 1.75 })));
  }
}
