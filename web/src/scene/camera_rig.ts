// SPDX-License-Identifier: BSD-2-Clause
import { PerspectiveCamera, Vector3 } from "three";
import type { Camera, Vec3 } from "../format/scene";
import { clamp, length, minus, rotate } from "./vectors";

export type CameraMode = "orbit" | "follow" | "map";

const LOWEST_RAD = 0.04, HIGHEST_RAD = Math.PI / 2 - 0.02, NEAREST_M = 1.2, FARTHEST_M = 400;
const MOST_CLOSE = 12;
/** Few who stand close together are shown with so much of the world around them. */
export const AMONG_OTHERS_M = 9;
/** Scripts place the camera for pictures of this width to height. */
const WINDOW_ASPECT = 16 / 9;
const TURN_PER_PX = 0.006, EASE_PER_S = 9;

interface View { target: [number, number, number]; heading: number; tilt: number; away: number }

/** Where the picture is taken from: around a point (orbit), around an agent that it goes with (follow), or from above (map). */
export class CameraRig {
  readonly camera = new PerspectiveCamera(45, 1, 0.1, 2000);
  mode: CameraMode = "orbit";
  private wanted: View = { target: [0, 1, 0], heading: 0.5, tilt: 0.5, away: 25 };
  private shown: View = { ...this.wanted, target: [...this.wanted.target] };
  private beforeMap: View | null = null;
  private moves = -1;
  private byHand = false;

  setSize(width: number, height: number): void {
    this.camera.aspect = width / Math.max(height, 1);
    this.camera.updateProjectionMatrix();
  }

  setMode(mode: CameraMode): void {
    if (mode === this.mode) return;
    if (mode === "map") {
      this.beforeMap = copy(this.wanted);
      this.wanted.heading = 0;
      this.wanted.tilt = HIGHEST_RAD;
      this.wanted.away = Math.max(this.wanted.away, 30);
    } else if (this.mode === "map" && this.beforeMap !== null) {
      this.wanted = { ...this.beforeMap, target: this.wanted.target };
      this.beforeMap = null;
    }
    this.mode = mode;
  }

  turn(dx: number, dy: number): void {
    this.byHand = true;
    if (this.mode === "map") return this.pan(dx, dy);
    this.wanted.heading -= dx * TURN_PER_PX;
    this.wanted.tilt = clamp(this.wanted.tilt + dy * TURN_PER_PX, LOWEST_RAD, HIGHEST_RAD);
  }

  /** Moves what is looked at along the ground, by pixels. */
  pan(dx: number, dy: number): void {
    this.byHand = true;
    if (this.mode === "follow") this.mode = "orbit";
    const perPixel = (this.wanted.away * Math.tan((this.camera.fov * Math.PI) / 360) * 2) / 600;
    const { heading } = this.wanted, sin = Math.sin(heading), cos = Math.cos(heading);
    this.wanted.target[0] += (-dx * cos - dy * sin) * perPixel;
    this.wanted.target[2] += (dx * sin - dy * cos) * perPixel;
  }

  zoom(factor: number): void {
    this.byHand = true;
    this.wanted.away = clamp(this.wanted.away * factor, NEAREST_M, FARTHEST_M);
  }

  /** So that all these places are in the picture. */
  frame(places: readonly Vec3[], ease = true, leastRadius = 3.5): void {
    if (places.length === 0) return;
    const low: [number, number, number] = [...places[0]!], high: [number, number, number] = [...places[0]!];
    for (const place of places) {
      for (let axis = 0; axis < 3; ++axis) {
        low[axis] = Math.min(low[axis]!, place[axis]!);
        high[axis] = Math.max(high[axis]!, place[axis]!);
      }
    }
    this.wanted.target = [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2];
    const radius = Math.max(leastRadius, length(minus(high, low)) / 2), half = (this.camera.fov * Math.PI) / 360;
    this.wanted.away = clamp((radius * 1.25) / Math.min(Math.tan(half), Math.tan(half) * this.camera.aspect), 8, FARTHEST_M);
    if (!ease) this.shown = copy(this.wanted);
  }

  /** Takes over where scripts want the camera, when they say so anew. True if it did. `isBoard`: what they show is shown whole. */
  obey(order: Camera, actors: readonly Vec3[] = [], isBoard = false): boolean {
    if (order.moves === this.moves) return false;
    const isFirst = this.moves < 0;
    this.moves = order.moves;
    if (!isFirst && this.byHand) return false;
    const ahead = rotate(order.turn, [0, 0, -1]), down = -ahead[1];
    const away = clamp(down > 0.03 ? order.place[1] / down : 30, 4, 120);
    this.wanted = {
      target: [order.place[0] + ahead[0] * away, order.place[1] + ahead[1] * away, order.place[2] + ahead[2] * away],
      heading: Math.atan2(-ahead[0], -ahead[2]), tilt: clamp(Math.asin(clamp(down, -1, 1)), LOWEST_RAD, HIGHEST_RAD), away,
    };
    if (order.fovDeg > 10 && order.fovDeg < 120) this.camera.fov = order.fovDeg;
    this.camera.updateProjectionMatrix();
    // Scripts think of a whole window; few actors are shown larger in the page's smaller picture.
    if (isFirst && isBoard) this.wanted.away *= Math.max(1, WINDOW_ASPECT / this.camera.aspect);
    else if (isFirst && actors.length > 0 && actors.length <= MOST_CLOSE) {
      const { away: far } = this.wanted;
      this.frame(actors, false, AMONG_OTHERS_M);
      if (this.wanted.away > far) this.wanted.away = far;
    }
    this.shown = copy(this.wanted);
    return true;
  }

  /** Another world: the next order counts. */
  forget(): void {
    this.moves = -1;
    this.byHand = false;
    this.mode = "orbit";
    this.beforeMap = null;
  }

  /** True while the camera still moves. */
  update(seconds: number, followed: Vec3 | null): boolean {
    if (this.mode === "follow" && followed !== null) {
      this.wanted.target = [followed[0], followed[1] + 0.4, followed[2]];
      this.wanted.away = Math.min(this.wanted.away, 30);
    }
    const share = 1 - Math.exp(-seconds * EASE_PER_S), { shown, wanted } = this;
    let turn = wanted.heading - shown.heading;
    turn -= 2 * Math.PI * Math.round(turn / (2 * Math.PI));
    shown.heading += turn * share;
    shown.tilt += (wanted.tilt - shown.tilt) * share;
    shown.away *= (wanted.away / shown.away) ** share;
    let rest = Math.abs(turn) + Math.abs(wanted.tilt - shown.tilt) + Math.abs(Math.log(wanted.away / shown.away));
    for (let axis = 0; axis < 3; ++axis) {
      const step = wanted.target[axis]! - shown.target[axis]!;
      shown.target[axis]! += step * share;
      rest += Math.abs(step) / shown.away;
    }
    const wide = Math.cos(shown.tilt) * shown.away;
    this.camera.position.set(shown.target[0] + wide * Math.sin(shown.heading), Math.max(0.25, shown.target[1] + Math.sin(shown.tilt) * shown.away), shown.target[2] + wide * Math.cos(shown.heading));
    this.camera.lookAt(new Vector3(...shown.target));
    this.camera.updateMatrixWorld();
    return rest > 1e-4;
  }

  get target(): Vec3 {
    return this.shown.target;
  }

  get away(): number {
    return this.shown.away;
  }
}

function copy(view: View): View {
  return { ...view, target: [...view.target] };
}
