// SPDX-License-Identifier: BSD-2-Clause
import type { Quat, Vec3 } from "../../format/scene";
import { cross, minus, plus, times, unit } from "./mesh_data";
import { conjugate, inverse, quatTimes, rotate, within, type Pose } from "./skin";

/** The soldier's bones, by index: as the world's. Models face +z with their left at +x. */
export enum Bone {
  Hips, Spine, Chest, Neck, Head, LeftClavicle, LeftArm, LeftForearm, LeftHand, RightClavicle, RightArm, RightForearm, RightHand,
  LeftThigh, LeftShin, LeftFoot, LeftToe, RightThigh, RightShin, RightFoot, RightToe,
}
export enum RifleBone { Body, Barrel, Muzzle, Magazine, Bolt, Stock }

export const SIZE = {
  hips: 0.925, hipHeight: 0.885, hipSide: 0.092, thigh: 0.405, ankle: 0.885 - 0.405 - 0.395, ball: 0.125,
  spine: 1.03, chest: 1.17, neck: 1.43, head: 1.515, shoulderSide: 0.175, shoulder: 1.375, upperArm: 0.27, forearm: 0.25,
} as const;
export const RIFLE = { bore: 0.075, muzzle: 0.64 } as const;

export interface BoneAt { parent: number; inModel: Pose; bind: Pose }

const ARM_OUT_RAD = 0.62;
export const armDirection = (side: number): Vec3 => [side * Math.sin(ARM_OUT_RAD), -Math.cos(ARM_OUT_RAD), 0];

function fromAxes(x: Vec3, y: Vec3, z: Vec3): Quat {
  const trace = x[0] + y[1] + z[2];
  const q: [number, number, number, number] = trace > 0
    ? [y[2] - z[1], z[0] - x[2], x[1] - y[0], 1 + trace]
    : x[0] > y[1] && x[0] > z[2] ? [1 + x[0] - y[1] - z[2], y[0] + x[1], z[0] + x[2], y[2] - z[1]]
      : y[1] > z[2] ? [y[0] + x[1], 1 + y[1] - x[0] - z[2], z[1] + y[2], z[0] - x[2]]
        : [z[0] + x[2], z[1] + y[2], 1 + z[2] - x[0] - y[1], x[1] - y[0]];
  const size = Math.hypot(...q);
  return [q[0] / size, q[1] / size, q[2] / size, q[3] / size];
}

/** The turn whose y axis is -direction and whose z axis leans towards the palm. */
function handFrame(direction: Vec3, palm: Vec3): Quat {
  const y = times(unit(direction), -1), x = unit(cross(y, palm));
  return fromAxes(x, y, cross(x, y));
}
const bindHand = (side: number): Quat => handFrame(armDirection(side), [-side, 0, 0]);

const turnAbout = (axis: number, degrees: number): Quat => {
  const half = (degrees * Math.PI) / 360, q: [number, number, number, number] = [0, 0, 0, Math.cos(half)];
  q[axis] = Math.sin(half);
  return q;
};

/** Where the wrists are and how the hands lie when they hold the rifle, in the rifle's space. */
export const HOLD = (() => {
  const attached = quatTimes(turnAbout(0, 98), turnAbout(1, 97)), rightHand = conjugate(attached);
  const rightWrist = times(rotate(rightHand, [0.04, 0.05, -0.01]), -1), grip = plus(rightWrist, [0.078, -0.022, -0.014]);
  const direction = unit([0.62, 0.3, 0.72]);
  const leftHand = quatTimes(handFrame(direction, [0, 0.95, 0.3]), conjugate(bindHand(1)));
  return { rightHand, rightWrist, leftHand, leftWrist: minus(plus(grip, [0.245, 0.012, 0]), times(direction, 0.085)), grip };
})();

function skeletonOf(bones: readonly { parent: number; place: Vec3; turn?: Quat }[]): BoneAt[] {
  const made: BoneAt[] = [];
  for (const { parent, place, turn } of bones) {
    const inModel: Pose = { place, turn: turn ?? [0, 0, 0, 1] };
    made.push({ parent, inModel, bind: parent < 0 ? inModel : within(inverse(made[parent]!.inModel), inModel) });
  }
  return made;
}

export const SOLDIER_BONES: readonly BoneAt[] = (() => {
  const bones: { parent: number; place: Vec3; turn?: Quat }[] = [
    { parent: -1, place: [0, SIZE.hips, 0] }, { parent: Bone.Hips, place: [0, SIZE.spine, -0.005] }, { parent: Bone.Spine, place: [0, SIZE.chest, -0.005] },
    { parent: Bone.Chest, place: [0, SIZE.neck, -0.012] }, { parent: Bone.Neck, place: [0, SIZE.head, 0.005], turn: turnAbout(1, 180) },
  ];
  for (const side of [1, -1]) {
    const shoulder: Vec3 = [side * SIZE.shoulderSide, SIZE.shoulder, -0.01], way = armDirection(side);
    const elbow = plus(shoulder, times(way, SIZE.upperArm)), wrist = plus(elbow, times(way, SIZE.forearm)), first = bones.length;
    const hand: Quat = side > 0 ? [0, 0, 0, 1] : quatTimes(quatTimes(bindHand(side), conjugate(handFrame([1, 0.08, 0], [0, 0, -1]))), HOLD.rightHand);
    bones.push({ parent: Bone.Chest, place: [side * 0.03, SIZE.shoulder + 0.015, 0.01] }, { parent: first, place: shoulder },
      { parent: first + 1, place: elbow }, { parent: first + 2, place: wrist, turn: hand });
  }
  for (const side of [1, -1]) {
    const x = side * SIZE.hipSide, first = bones.length;
    bones.push({ parent: Bone.Hips, place: [x, SIZE.hipHeight, 0] }, { parent: first, place: [x, SIZE.hipHeight - SIZE.thigh, 0] },
      { parent: first + 1, place: [x, SIZE.ankle, 0] }, { parent: first + 2, place: [x, 0.02, SIZE.ball] });
  }
  return skeletonOf(bones);
})();

export const RIFLE_BONES: readonly BoneAt[] = (() => {
  const at = (x: number, y: number): Vec3 => plus(HOLD.grip, [x, y, 0]);
  return skeletonOf([
    { parent: -1, place: at(0, 0) }, { parent: RifleBone.Body, place: at(0.3, RIFLE.bore) }, { parent: RifleBone.Barrel, place: at(RIFLE.muzzle, RIFLE.bore) },
    { parent: RifleBone.Body, place: at(0.125, 0.01) }, { parent: RifleBone.Body, place: at(0.04, RIFLE.bore) }, { parent: RifleBone.Body, place: at(-0.1, RIFLE.bore) },
  ]);
})();

export type BodyLook = "soldier" | "dark" | "rifle";
const LOOKS: Readonly<Record<string, BodyLook>> = {
  "models/futuristic_soldier/futuristic_soldier_anim.mesh": "soldier",
  "models/futuristic_soldier/futuristic_soldier_dark_anim.mesh": "dark",
  "models/futuristic_soldier/soldier_weapon.mesh": "rifle",
  "models/soarbox/soldier.mesh": "soldier",
  "models/soarbox/soldier_dark.mesh": "dark",
  "models/soarbox/rifle.mesh": "rifle",
};

/** Null if the mesh has no skeleton of ours. */
export function bodyLook(mesh: string): BodyLook | null {
  return Object.hasOwn(LOOKS, mesh) ? LOOKS[mesh]! : null;
}
