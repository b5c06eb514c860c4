// SPDX-License-Identifier: BSD-2-Clause
import type { Vec3 } from "../../format/scene";
import { plus, times, unit } from "./mesh_data";
import { armDirection, Bone, HOLD, RIFLE, RifleBone, SIZE, SOLDIER_BONES } from "./skeletons";
import { by, Cloth, inverse, loop, SkinBuilder, SkinMesh, STILL, within, type By } from "./skin";

const FRONT: Vec3 = [0, 0, 1], UP: Vec3 = [0, 1, 0];
const DARK: Readonly<Partial<Record<Cloth, Cloth>>> = {
  [Cloth.Camouflage]: Cloth.DarkCamouflage, [Cloth.Webbing]: Cloth.DarkWebbing, [Cloth.Helmet]: Cloth.DarkHelmet,
};

/** The soldier: lofts for the body, and gear of rounded pieces over it. Coarse leaves out what nobody sees from afar. */
class Soldier {
  private readonly b: SkinBuilder;

  constructor(private readonly coarse: boolean, private readonly dark: boolean) {
    this.b = new SkinBuilder(coarse ? 0.3 : 0.62);
  }

  build(): SkinMesh {
    this.trunk();
    this.head();
    for (const side of [1, -1]) {
      this.arm(side);
      this.leg(side);
      this.boot(side);
    }
    this.hands();
    this.vest();
    this.belt();
    this.pack();
    return this.b.made;
  }

  private wear(cloth: Cloth, bone: By, light = 1): void {
    this.b.wear(this.dark ? (DARK[cloth] ?? cloth) : cloth, bone, light);
  }

  private trunk(): void {
    const { Hips, Spine, Chest, Neck, Head } = Bone;
    this.wear(Cloth.Camouflage, by(Hips));
    this.b.loft([
      loop([0, 0.8, -0.005], 0.12, 0.085, by(Hips), 0.1, 0.6), loop([0, 0.84, -0.01], 0.156, 0.108, by(Hips), 0.15, 0.8),
      loop([0, 0.9, -0.014], 0.168, 0.118, by(Hips), 0.2), loop([0, 0.96, -0.01], 0.16, 0.114, by(Hips), 0.2),
      loop([0, 1.02, -0.004], 0.15, 0.108, by(Hips, Spine, 0.4), 0.2), loop([0, 1.1, 0], 0.152, 0.108, by(Spine), 0.2),
      loop([0, 1.18, 0], 0.162, 0.114, by(Spine, Chest, 0.4), 0.2), loop([0, 1.28, -0.002], 0.172, 0.12, by(Chest), 0.2),
      loop([0, 1.35, -0.006], 0.172, 0.11, by(Chest), 0.2), loop([0, 1.395, -0.01], 0.14, 0.088, by(Chest), 0.1),
      loop([0, 1.425, -0.012], 0.09, 0.07, by(Chest), 0, 0.85), loop([0, 1.445, -0.012], 0.066, 0.064, by(Chest, Neck, 0.6), 0, 0.7)], 24, FRONT);
    this.wear(Cloth.Skin, by(Neck), 0.8);
    this.b.loft([loop([0, 1.41, -0.012], 0.056, 0.058, by(Neck)), loop([0, 1.5, -0.004], 0.053, 0.056, by(Neck)), loop([0, 1.55, 0.004], 0.054, 0.06, by(Neck, Head, 0.4))], 14, FRONT);
    this.wear(Cloth.Webbing, by(Neck, Chest, 0.5), 0.9);
    this.b.loft([loop([0, 1.425, -0.004], 0.082, 0.08, by(Chest)), loop([0, 1.455, 0.004], 0.079, 0.084, by(Neck, Chest, 0.5)), loop([0, 1.485, 0.002], 0.066, 0.07, by(Neck))], 16, FRONT);
  }

  private head(): void {
    const head = by(Bone.Head);
    this.wear(Cloth.Skin, head);
    this.b.round([0, 1.595, 0.016], [0.074, 0.115, 0.092], 0.88, 20, -1, 1, (p) => {
      const down = Math.max(0, (1.6 - p[1]) / 0.115);
      return [p[0] * (1 - 0.26 * down * down), p[1], p[2] > 0 ? p[2] + 0.006 * down : p[2]];
    });
    if (!this.coarse) {
      this.b.round([0, 1.585, 0.112], [0.014, 0.024, 0.016], 0.9, 8);
      this.wear(Cloth.Skin, head, 0.72);
      this.b.round([0, 1.545, 0.104], [0.026, 0.006, 0.01], 0.9, 8);
    }
    this.wear(Cloth.Rubber, head);
    this.b.loft([loop([0, 1.597, 0.016], 0.08, 0.093, head, 0.15), loop([0, 1.605, 0.016], 0.084, 0.102, head, 0.2),
      loop([0, 1.64, 0.016], 0.085, 0.102, head, 0.2), loop([0, 1.648, 0.016], 0.081, 0.093, head, 0.15)], 20, FRONT);
    this.wear(Cloth.Glass, head);
    this.b.round([0, 1.622, 0.088], [0.066, 0.021, 0.036], 0.45, 16, -1, 1, (p) => [p[0], p[1], p[2] - 3.2 * p[0] * p[0]]);
    const shell = (p: Vec3): Vec3 => {
      const low = Math.max(0, (1.66 - p[1]) / 0.05);
      return p[2] < 0.03 ? [p[0], p[1] - 0.04 * low * Math.min(1, (0.03 - p[2]) / 0.06), p[2]] : p;
    };
    this.wear(Cloth.Helmet, head);
    this.b.round([0, 1.64, 0.002], [0.116, 0.126, 0.138], 0.92, 26, 0.04, 1, shell);
    this.wear(Cloth.Rubber, head);
    this.b.round([0, 1.64, 0.002], [0.118, 0.03, 0.14], 0.92, 26, -0.1, 0.28, shell);
    this.wear(Cloth.Team, head);
    this.b.round([0, 1.64, 0.002], [0.1185, 0.1285, 0.1405], 0.92, 26, 0.22, 0.36, shell);
    if (this.coarse) return;
    this.wear(Cloth.Rubber, head);
    this.b.round([0, 1.7, 0.128], [0.02, 0.024, 0.012], 0.4, 8);
    for (const side of [1, -1]) this.b.round([side * 0.088, 1.592, 0.006], [0.022, 0.037, 0.029], 0.6, 12);
  }

  private arm(side: number): void {
    const clavicle = side > 0 ? Bone.LeftClavicle : Bone.RightClavicle, upper = clavicle + 1, lower = clavicle + 2, chest = Bone.Chest;
    const way = armDirection(side), shoulder: Vec3 = [side * SIZE.shoulderSide, SIZE.shoulder, -0.01];
    const at = (along: number): Vec3 => plus(shoulder, times(way, along));
    const elbow = SIZE.upperArm, wrist = elbow + SIZE.forearm;
    this.wear(Cloth.Camouflage, by(upper));
    this.b.loft([
      loop(plus(at(-0.085), [-side * 0.03, -0.045, 0]), 0.05, 0.062, by(chest)), loop(plus(at(-0.055), [-side * 0.008, -0.026, 0]), 0.058, 0.068, by(chest, clavicle, 0.5)),
      loop(plus(at(-0.02), [0, -0.008, 0]), 0.063, 0.069, by(clavicle, upper, 0.5)), loop(at(0.035), 0.063, 0.067, by(upper)), loop(at(0.09), 0.061, 0.064, by(upper)),
      loop(at(0.17), 0.055, 0.058, by(upper), 0, 0.95), loop(at(elbow - 0.045), 0.051, 0.053, by(upper)), loop(at(elbow), 0.05, 0.051, by(upper, lower, 0.5)),
      loop(at(elbow + 0.045), 0.051, 0.053, by(lower)), loop(at(elbow + 0.1), 0.049, 0.051, by(lower)), loop(at(elbow + 0.17), 0.042, 0.043, by(lower)),
      loop(at(wrist - 0.025), 0.039, 0.04, by(lower)), loop(at(wrist - 0.012), 0.034, 0.035, by(lower), 0, 0.7)], 16, FRONT);
    this.wear(Cloth.Leather, by(lower));
    this.b.loft([loop(at(wrist - 0.035), 0.033, 0.034, by(lower)), loop(at(wrist - 0.01), 0.034, 0.034, by(lower)), loop(at(wrist + 0.02), 0.031, 0.03, by(clavicle + 3))], 12, FRONT);
    this.wear(Cloth.Team, by(upper));
    this.b.loft([loop(at(0.085), 0.0645, 0.0675, by(upper)), loop(at(0.135), 0.0605, 0.0635, by(upper))], 16, FRONT, false);
    if (this.coarse) return;
    this.wear(Cloth.Rubber, by(upper, lower, 0.5));
    this.b.round(plus(at(elbow), [0, 0, -0.04]), [0.034, 0.046, 0.022], 0.6, 12);
  }

  private hands(): void {
    const g = HOLD.grip, place = (bone: Bone, turn: typeof HOLD.leftHand, wrist: Vec3): void => {
      this.wear(Cloth.Leather, by(bone));
      this.b.place = within(SOLDIER_BONES[bone]!.inModel, inverse({ place: wrist, turn }));
    };
    place(Bone.RightHand, HOLD.rightHand, HOLD.rightWrist);
    this.b.round(plus(g, [-0.04, 0.012, 0.016]), [0.046, 0.04, 0.021], 0.62, 14);
    this.b.round(plus(g, [0.012, -0.004, 0.002]), [0.034, 0.042, 0.036], 0.7, 8);
    place(Bone.LeftHand, HOLD.leftHand, HOLD.leftWrist);
    const way = unit([0.62, 0.3, 0.72]), hand = by(Bone.LeftHand), on = (along: number): Vec3 => plus(HOLD.leftWrist, times(way, along));
    this.b.loft([loop(on(0), 0.03, 0.024, hand, 0.3), loop(on(0.03), 0.042, 0.022, hand, 0.4), loop(on(0.07), 0.045, 0.019, hand, 0.5), loop(on(0.095), 0.038, 0.015, hand, 0.5)], 14, [0, 0.95, 0.3]);
    if (!this.coarse) {
      for (let finger = 0; finger < 4; ++finger) {
        const start = plus(on(0.05), [0.023 * finger + 0.004, 0.01, 0.012]);
        this.b.tube([start, plus(start, [0.008, 0.006, 0.03]), plus(start, [0.006, 0.032, 0.046]), plus(start, [0.004, 0.054, 0.04])], 0.011, 6);
      }
    }
    this.b.place = STILL;
  }

  private leg(side: number): void {
    const thigh = side > 0 ? Bone.LeftThigh : Bone.RightThigh, shin = thigh + 1, hips = Bone.Hips, x = side * SIZE.hipSide, knee = SIZE.hipHeight - SIZE.thigh;
    this.wear(Cloth.Camouflage, by(thigh));
    this.b.loft([
      loop([x * 0.92, 0.935, -0.012], 0.074, 0.098, by(hips), 0.1), loop([x * 0.94, 0.875, -0.008], 0.085, 0.104, by(hips, thigh, 0.5), 0.1, 0.9),
      loop([x, 0.81, -0.002], 0.089, 0.1, by(thigh), 0, 0.9), loop([x, 0.7, 0.004], 0.083, 0.092, by(thigh)), loop([x, 0.6, 0.006], 0.073, 0.082, by(thigh)),
      loop([x, knee + 0.055, 0.006], 0.066, 0.072, by(thigh)), loop([x, knee, 0.004], 0.063, 0.069, by(thigh, shin, 0.5)), loop([x, knee - 0.055, -0.004], 0.062, 0.066, by(shin)),
      loop([x, 0.36, -0.014], 0.063, 0.07, by(shin)), loop([x, 0.28, -0.014], 0.059, 0.066, by(shin)), loop([x, 0.235, -0.01], 0.062, 0.069, by(shin)),
      loop([x, 0.215, -0.008], 0.052, 0.058, by(shin), 0, 0.6)], 18, FRONT);
    this.wear(Cloth.Rubber, by(thigh, shin, 0.4));
    this.b.round([x, knee - 0.005, 0.06], [0.048, 0.068, 0.026], 0.55, 14);
    if (this.coarse) return;
    this.wear(Cloth.Camouflage, by(thigh), 0.93);
    this.b.round([x + side * 0.08, 0.66, 0.004], [0.02, 0.075, 0.06], 0.35, 12);
    if (side > 0) return;
    this.wear(Cloth.Webbing, by(thigh));
    this.b.round([x - 0.092, 0.755, 0.012], [0.021, 0.078, 0.036], 0.4, 12);
  }

  private boot(side: number): void {
    const shin = side > 0 ? Bone.LeftShin : Bone.RightShin, foot = shin + 1, toe = shin + 2, x = side * SIZE.hipSide, out = x + side * 0.006, ankle = SIZE.ankle;
    this.wear(Cloth.Leather, by(foot));
    this.b.loft([loop([x, 0.245, -0.01], 0.052, 0.058, by(shin)), loop([x, 0.2, -0.008], 0.051, 0.056, by(shin)), loop([x, ankle + 0.045, -0.004], 0.047, 0.055, by(shin, foot, 0.6)),
      loop([x, ankle, 0], 0.045, 0.06, by(foot)), loop([x, 0.05, 0.01], 0.046, 0.072, by(foot)), loop([x, 0.022, 0.014], 0.046, 0.076, by(foot))], 16, FRONT);
    this.b.loft([loop([x, 0.058, 0.02], 0.044, 0.048, by(foot), 0.2), loop([out, 0.054, 0.07], 0.048, 0.042, by(foot), 0.2),
      loop([out, 0.048, SIZE.ball - 0.005], 0.05, 0.036, by(foot, toe, 0.5), 0.25), loop([out, 0.046, 0.165], 0.048, 0.034, by(toe), 0.2),
      loop([out, 0.044, 0.195], 0.04, 0.03, by(toe)), loop([out, 0.042, 0.208], 0.026, 0.02, by(toe))], 16, UP);
    this.wear(Cloth.Rubber, by(foot));
    this.b.loft([loop([x, 0.015, 0.005], 0.042, 0.015, by(foot), 0.6), loop([out, 0.013, 0.07], 0.048, 0.013, by(foot), 0.6),
      loop([out, 0.012, SIZE.ball], 0.052, 0.012, by(foot, toe, 0.5), 0.6), loop([out, 0.012, 0.18], 0.047, 0.012, by(toe), 0.5), loop([out, 0.013, 0.212], 0.03, 0.01, by(toe), 0.2)], 12, UP);
  }

  private vest(): void {
    const chest = by(Bone.Chest), spine = by(Bone.Spine);
    this.wear(Cloth.Webbing, chest);
    this.b.loft([loop([0, 1.075, 0.002], 0.158, 0.118, spine, 0.35, 0.75), loop([0, 1.085, 0.003], 0.169, 0.13, spine, 0.4), loop([0, 1.17, 0.004], 0.177, 0.136, by(Bone.Spine, Bone.Chest, 0.4), 0.45),
      loop([0, 1.27, 0.003], 0.18, 0.139, chest, 0.45), loop([0, 1.325, 0.002], 0.164, 0.134, chest, 0.5), loop([0, 1.365, 0], 0.132, 0.122, chest, 0.5), loop([0, 1.385, -0.002], 0.118, 0.105, chest, 0.4, 0.8)], 24, FRONT);
    this.b.round([0, 1.275, 0.128], [0.118, 0.105, 0.022], 0.35, 14);
    for (const side of [1, -1])
      this.b.round([side * 0.1, 1.4, -0.004], [0.036, 0.022, 0.108], 0.55, 12, -1, 1, (p) => [p[0], p[1] - 2.6 * (p[2] + 0.004) ** 2, p[2]]);
    for (const place of [-1, 0, 1]) {
      this.wear(Cloth.Webbing, spine, 0.94);
      this.b.round([place * 0.088, 1.13, 0.152 - 0.012 * Math.abs(place)], [0.038, 0.066, 0.026], 0.32, 12);
    }
    if (this.coarse) return;
    this.wear(Cloth.Webbing, chest, 0.9);
    this.b.round([0.092, 1.3, 0.155], [0.03, 0.048, 0.02], 0.35, 10);
    this.b.round([-0.086, 1.285, 0.156], [0.036, 0.03, 0.02], 0.35, 10);
    this.wear(Cloth.Team, chest);
    this.b.round([-0.086, 1.345, 0.141], [0.032, 0.017, 0.012], 0.3, 8);
    this.wear(Cloth.Rubber, chest);
    this.b.tube([[0.112, 1.33, 0.15], [0.12, 1.42, 0.12], [0.128, 1.51, 0.085]], 0.004, 5);
  }

  private belt(): void {
    const hips = by(Bone.Hips);
    this.wear(Cloth.Leather, hips);
    this.b.loft([loop([0, 0.962, -0.01], 0.166, 0.12, hips, 0.2), loop([0, 0.968, -0.01], 0.171, 0.125, hips, 0.2), loop([0, 1.005, -0.006], 0.167, 0.122, hips, 0.2), loop([0, 1.011, -0.006], 0.161, 0.116, hips, 0.2)], 22, FRONT);
    this.wear(Cloth.Webbing, hips, 0.92);
    for (const side of [1, -1]) this.b.round([side * 0.158, 0.955, -0.02], [0.03, 0.058, 0.05], 0.38, 12);
    if (this.coarse) return;
    for (const side of [1, -1]) this.b.round([side * 0.085, 0.955, -0.132], [0.046, 0.06, 0.032], 0.4, 12);
  }

  private pack(): void {
    const chest = by(Bone.Chest);
    this.wear(Cloth.Webbing, chest);
    this.b.round([0, 1.225, -0.2], [0.14, 0.17, 0.078], 0.4, 18, -1, 1, (p) => [p[0], p[1], p[2] < -0.2 ? p[2] - 0.14 * Math.max(0, 1.3 - p[1]) : p[2]]);
    this.wear(Cloth.Webbing, chest, 0.86);
    this.b.round([0, 1.372, -0.2], [0.147, 0.034, 0.086], 0.42, 18);
    this.b.round([0, 1.17, -0.285], [0.1, 0.08, 0.034], 0.4, 14);
    this.wear(Cloth.Camouflage, chest, 0.9);
    this.b.tube([[-0.165, 1.03, -0.185], [0.165, 1.03, -0.185]], 0.056, 14);
    this.wear(Cloth.Team, chest);
    this.b.round([0, 1.325, -0.279], [0.05, 0.028, 0.006], 0.3, 8);
  }
}

/** The rifle, along +x. */
function rifle(coarse: boolean): SkinMesh {
  const b = new SkinBuilder(coarse ? 0.4 : 0.7);
  b.place = { place: HOLD.grip, turn: [0, 0, 0, 1] };
  const rod = (rings: readonly (readonly [number, number])[], y: number, segments: number, square = 0, tall = 1): void =>
    b.loft(rings.map(([x, radius]) => loop([x, y, 0], radius, radius * tall, b.bone, square)), segments, UP);
  const body = by(RifleBone.Body), stock = by(RifleBone.Stock), barrel = by(RifleBone.Barrel);
  b.wear(Cloth.Metal, body);
  b.round([0.055, 0.062, 0], [0.135, 0.036, 0.021], 0.28, 14);
  b.round([0.055, 0.098, 0], [0.125, 0.014, 0.016], 0.28, 12);
  b.wear(Cloth.Rubber, body);
  b.round([-0.002, -0.006, 0], [0.021, 0.056, 0.016], 0.4, 12, -1, 1, (p) => [p[0] + 0.28 * p[1], p[1], p[2]]);
  b.wear(Cloth.Metal, by(RifleBone.Magazine), 0.85);
  b.round([0.132, -0.04, 0], [0.03, 0.088, 0.0125], 0.3, 12, -1, 1, (p) => [p[0] + 1.6 * Math.max(0, 0.03 - p[1]) ** 2, p[1], p[2]]);
  b.wear(Cloth.Metal, body);
  rod([[-0.16, 0.014], [-0.07, 0.016]], 0.07, 10);
  b.wear(Cloth.Rubber, stock);
  b.round([-0.195, 0.055, 0], [0.07, 0.04, 0.017], 0.3, 14, -1, 1, (p) => [p[0], p[1] < 0.055 ? p[1] - 0.35 * Math.max(0, -0.15 - p[0]) : p[1], p[2]]);
  b.wear(Cloth.Rubber, body);
  rod([[0.185, 0.026], [0.19, 0.03], [0.365, 0.028], [0.372, 0.023]], 0.072, 12, 0.45, 1.08);
  b.wear(Cloth.Metal, barrel);
  rod([[0.3, 0.0125], [0.56, 0.0105]], RIFLE.bore, 10);
  b.wear(Cloth.Rubber, barrel);
  rod([[0.555, 0.012], [0.56, 0.0185], [RIFLE.muzzle - 0.004, 0.0185], [RIFLE.muzzle, 0.014]], RIFLE.bore, 12);
  if (coarse) return b.made;
  b.wear(Cloth.Metal, body);
  for (const x of [0.02, 0.11]) b.round([x, 0.118, 0], [0.011, 0.016, 0.013], 0.35, 8);
  b.wear(Cloth.Rubber, body);
  rod([[-0.045, 0.017], [-0.04, 0.021], [0.005, 0.02], [0.015, 0.0155], [0.115, 0.0155], [0.13, 0.022], [0.175, 0.024], [0.178, 0.02]], 0.142, 14);
  b.wear(Cloth.Glass, body);
  b.round([0.176, 0.142, 0], [0.004, 0.02, 0.02], 0.8, 12);
  return b.made;
}

export function bodyMesh(look: "soldier" | "dark" | "rifle", coarse: boolean): SkinMesh {
  return look === "rifle" ? rifle(coarse) : new Soldier(coarse, look === "dark").build();
}
