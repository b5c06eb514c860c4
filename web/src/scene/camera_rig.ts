// SPDX-License-Identifier: BSD-2-Clause
import { PerspectiveCamera, Vector3 } from "three";
import type { Camera, Vec3 } from "../format/scene";
import { CameraKeeper } from "./camera_keeper";
import { ALL_FREE, comfortable, eyeOf, framingView, isInside, middleOf, withPlaces, type Free, type FramedBody, type Lens, type View } from "./framing";
import { clamp, length, minus, rotate } from "./vectors";

export type CameraMode = "orbit" | "follow" | "map";

/** What the picture must show: agents, their places and the scenery around them; for a game, the board. */
export interface Shown { readonly bodies: readonly FramedBody[]; readonly places: readonly Vec3[]; readonly scenery: readonly FramedBody[]; readonly isBoard: boolean; readonly hasWalls: boolean }

const LOWEST_RAD = 0.04, HIGHEST_RAD = Math.PI / 2 - 0.02, NEAREST_M = 1.2, FARTHEST_M = 400, MAP_AWAY_M = 25;
/** Number of directions that are tried at the beginning. A later one must reduce the distance by this factor. */
const SIDES = 12, CLEARLY = 0.93;
/** A script's view is used if agents have at least this share of the picture's height. */
const SMALLEST_SHARE = 0.07;
const OTHER_SHAPE = 0.05;
const TURN_PER_PX = 0.006, EASE_PER_S = 9, PULL_PER_S = 2.6;

/**
 * Controls the camera. Its modes: around a point (orbit), around an agent that it follows (follow), or from above
 * (map).
 */
export class CameraRig {
  readonly camera = new PerspectiveCamera(45, 1, 0.1, 2000);
  mode: CameraMode = "orbit";
  /** The areas that cover the edges of the picture. */
  free: Free = ALL_FREE;
  private wanted: View = { target: [0, 1, 0], heading: 0.5, tilt: 0.5, away: 25 };
  private shown: View = copy(this.wanted);
  private beforeMap: View | null = null;
  private moves = -1;
  private byHand = false;
  private isKeeping = false;
  private readonly keeper = new CameraKeeper();
  /** The aspect ratio for which the current view was computed. */
  private framedAspect = 0;
  /** Speed of the camera while it keeps agents in view: of the target in m/s, and of the distance's logarithm. */
  private drift: [number, number, number, number] = [0, 0, 0, 0];

  setSize(width: number, height: number): void {
    this.camera.aspect = width / Math.max(height, 1);
    this.camera.updateProjectionMatrix();
  }

  /** Whether the camera keeps everybody in the picture by itself: until the user moves it. */
  get keeps(): boolean {
    return this.isKeeping && this.mode !== "follow";
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
    this.keeper.begin();
  }

  turn(dx: number, dy: number): void {
    if (this.mode === "map") return this.pan(dx, dy);
    this.take();
    this.wanted.heading -= dx * TURN_PER_PX;
    this.wanted.tilt = clamp(this.wanted.tilt + dy * TURN_PER_PX, LOWEST_RAD, HIGHEST_RAD);
  }

  /** Moves the target along the ground, by pixels. */
  pan(dx: number, dy: number): void {
    this.take();
    if (this.mode === "follow") this.mode = "orbit";
    const perPixel = (this.wanted.away * Math.tan((this.camera.fov * Math.PI) / 360) * 2) / 600;
    const { heading } = this.wanted, sin = Math.sin(heading), cos = Math.cos(heading);
    this.wanted.target[0] += (-dx * cos - dy * sin) * perPixel;
    this.wanted.target[2] += (dx * sin - dy * cos) * perPixel;
  }

  zoom(factor: number): void {
    this.take();
    this.wanted.away = clamp(this.wanted.away * factor, NEAREST_M, FARTHEST_M);
  }

  /** The user moves the camera: from now on it keeps its pose. */
  private take(): void {
    this.byHand = true;
    if (this.isKeeping) this.wanted = copy(this.shown);
    this.isKeeping = false;
  }

  private get lens(): Lens {
    return { slope: Math.tan((this.camera.fov * Math.PI) / 360), aspect: this.camera.aspect, free: this.free };
  }

  /** Moves the camera, without turning it, so that it shows all these bodies. It does not follow them. */
  frame(bodies: readonly FramedBody[]): void {
    if (bodies.length === 0) return;
    this.byHand = true;
    this.isKeeping = false;
    this.wanted = framingView(bodies, this.wanted.heading, this.wanted.tilt, this.lens);
  }

  /** Shows everybody, and keeps them in the picture until the user moves the camera. */
  frameAll(what: Shown): void {
    if (what.bodies.length === 0) return;
    if (this.mode === "follow") this.mode = "orbit";
    this.byHand = false;
    this.isKeeping = true;
    this.keeper.begin();
    this.framedAspect = this.camera.aspect;
    this.wanted = this.viewOf(what, this.wanted.heading);
  }

  /** The first picture of a world: the script's camera if it shows all agents well; otherwise the best view of them. */
  begin(order: Camera | null, what: Shown): void {
    if (order !== null) this.moveTo(order);
    this.byHand = false;
    this.isKeeping = true;
    this.keeper.begin();
    this.framedAspect = this.camera.aspect;
    if (what.isBoard) this.wanted = this.viewOf(what, this.wanted.heading);
    else if (order === null || what.hasWalls || !this.seesWell(what)) this.wanted = this.bestSide(what);
    this.arrive();
  }

  /** Follows the scripts' camera when they move it again. */
  obey(order: Camera): void {
    if (order.moves === this.moves || this.byHand || this.mode !== "orbit") {
      this.moves = order.moves;
      return;
    }
    this.moveTo(order);
    this.isKeeping = false;
    this.arrive();
  }

  private moveTo(order: Camera): void {
    this.moves = order.moves;
    if (![...order.place, ...order.turn].every(Number.isFinite)) return;
    const ahead = rotate(order.turn, [0, 0, -1]), down = -ahead[1];
    const away = clamp(down > 0.03 ? order.place[1] / down : 30, 4, 120);
    this.wanted = {
      target: [order.place[0] + ahead[0] * away, order.place[1] + ahead[1] * away, order.place[2] + ahead[2] * away],
      heading: Math.atan2(-ahead[0], -ahead[2]), tilt: clamp(Math.asin(clamp(down, -1, 1)), LOWEST_RAD, HIGHEST_RAD), away,
    };
    if (order.fovDeg > 10 && order.fovDeg < 120) this.camera.fov = order.fovDeg;
    this.camera.updateProjectionMatrix();
  }

  private seesWell({ bodies, scenery }: Shown): boolean {
    const { lens, wanted } = this, eye = eyeOf(wanted);
    return [...bodies, ...scenery].every((one) => isInside(one, one.place, wanted, lens, 1)) && bodies.every((one) => one.height / (2 * lens.slope * length(minus(one.place, eye))) > SMALLEST_SHARE);
  }

  private viewOf({ bodies, places, scenery, isBoard, hasWalls }: Shown, heading: number, tilt = this.wanted.tilt): View {
    const steep = isBoard || this.mode === "map" ? tilt : comfortable(hasWalls ? Math.PI : tilt);
    return framingView(isBoard ? bodies : withPlaces(bodies, places, heading, steep, this.lens, hasWalls ? [] : scenery), heading, steep, this.lens);
  }

  private bestSide(what: Shown): View {
    if (what.bodies.length === 0) return this.wanted;
    const middle = middleOf(what.bodies), awayOf = (view: View): number => length(minus(eyeOf(view), middle));
    let best = this.viewOf(what, this.wanted.heading);
    for (let side = 0; side < SIDES; ++side) {
      const view = this.viewOf(what, (2 * Math.PI * side) / SIDES);
      if (awayOf(view) < CLEARLY * awayOf(best)) best = view;
    }
    return best;
  }

  /** Sets, before each update, what must stay in the picture. */
  keep(what: Shown, seconds: number): void {
    if (!this.keeps || what.bodies.length === 0) return;
    const { aspect } = this.camera;
    if (Math.abs(aspect / this.framedAspect - 1) > OTHER_SHAPE) {
      this.framedAspect = aspect;
      this.wanted = this.viewOf(what, this.wanted.heading);
      return;
    }
    const goal = this.keeper.follow(what.bodies, what.isBoard ? [] : what.places, this.wanted, this.lens, seconds, what.hasWalls ? [] : what.scenery, what.isBoard || this.mode === "map" || what.hasWalls);
    if (goal === null) return;
    this.wanted = goal;
    if (this.mode === "map") this.wanted.away = Math.max(goal.away, MAP_AWAY_M);
  }

  /** Ends the movement to the wanted pose at once. */
  private arrive(): void {
    this.shown = copy(this.wanted);
    this.drift = [0, 0, 0, 0];
  }

  /** Resets the camera for another world. */
  forget(): void {
    this.moves = -1;
    this.byHand = false;
    this.isKeeping = false;
    this.mode = "orbit";
    this.beforeMap = null;
    this.free = ALL_FREE;
    this.camera.fov = 45;
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
    let rest = Math.abs(turn) + Math.abs(wanted.tilt - shown.tilt);
    if (this.keeps) {
      rest += this.spring(seconds);
    } else {
      this.drift = [0, 0, 0, 0];
      shown.away *= (wanted.away / shown.away) ** share;
      rest += Math.abs(Math.log(wanted.away / shown.away));
      for (let axis = 0; axis < 3; ++axis) {
        const step = wanted.target[axis]! - shown.target[axis]!;
        shown.target[axis]! += step * share;
        rest += Math.abs(step) / shown.away;
      }
    }
    const wide = Math.cos(shown.tilt) * shown.away;
    this.camera.position.set(shown.target[0] + wide * Math.sin(shown.heading), Math.max(0.25, shown.target[1] + Math.sin(shown.tilt) * shown.away), shown.target[2] + wide * Math.cos(shown.heading));
    this.camera.lookAt(new Vector3(...shown.target));
    this.camera.updateMatrixWorld();
    return rest > 1e-4;
  }

  /** A critically damped spring, solved exactly, so that the result does not depend on the frame rate. */
  private spring(seconds: number): number {
    const { shown, wanted, drift } = this, fade = Math.exp(-PULL_PER_S * seconds);
    let rest = 0;
    const pull = (off: number, index: number): number => {
      const step = (drift[index]! + off * PULL_PER_S) * seconds;
      drift[index] = (drift[index]! - step * PULL_PER_S) * fade;
      return (off + step) * fade;
    };
    for (let axis = 0; axis < 3; ++axis) {
      const off = pull(shown.target[axis]! - wanted.target[axis]!, axis);
      shown.target[axis] = wanted.target[axis]! + off;
      rest += (Math.abs(off) + Math.abs(drift[axis]!)) / shown.away;
    }
    const off = pull(Math.log(shown.away / wanted.away), 3);
    shown.away = wanted.away * Math.exp(off);
    return rest + Math.abs(off) + Math.abs(drift[3]);
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
