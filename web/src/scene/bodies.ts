// SPDX-License-Identifier: BSD-2-Clause
import { Bone, BufferAttribute, Group, Matrix4, Quaternion, Skeleton, SkinnedMesh, Sphere, Vector3, type BufferGeometry } from "three";
import { Shape, type Drawable } from "../format/scene";
import { lookOf, teamColor, type Look, type Rgb } from "./looks";
import { geometryOf, type Materials } from "./materials";
import { bodyLook, RIFLE_BONES, SOLDIER_BONES, type BodyLook, type BoneAt } from "./meshes/skeletons";
import type { SkinMesh } from "./meshes/skin";
import { bodyMesh } from "./meshes/soldier";
import type { Between } from "../run/playout";

const FINE_UNTIL_M = 14, MOST_FINE = 24;

interface Body { mesh: SkinnedMesh; bones: Bone[]; look: BodyLook; fine: boolean; team: string; seen: number }

/** Bodies with bones: soldiers and their rifles. */
export class Bodies {
  readonly group = new Group();
  private readonly bodies = new Map<number, Body>();
  private readonly skins = new Map<string, { skin: SkinMesh; geometry: BufferGeometry }>();
  private readonly colored = new Map<string, BufferGeometry>();
  private round = 0;

  constructor(private readonly materials: Materials) {}

  show({ before, after, share }: Between, camera: Vector3, isSlow: boolean): void {
    this.round += 1;
    let fineLeft = isSlow ? 0 : MOST_FINE;
    for (const [id, drawable] of after.drawables) {
      if (drawable.shape !== Shape.Mesh) continue;
      let look = bodyLook(drawable.mesh);
      if (look === null) continue;
      // A soldier may change its uniform by the name of its material.
      if (look !== "rifle" && drawable.material === "SF_Soldier_Body") look = "soldier";
      if (look !== "rifle" && drawable.material === "SF_Soldier_Body_Dark") look = "dark";
      const away = camera.distanceTo(new Vector3(...drawable.place)), fine = away < FINE_UNTIL_M && fineLeft > 0;
      if (fine) fineLeft -= 1;
      const team = drawable.ofAgent ? (after.agents.get(drawable.owner)?.team ?? "") : "";
      const body = this.bodyFor(id, look, fine, team);
      body.seen = this.round;
      body.mesh.visible = drawable.visible;
      this.pose(body, drawable, before.drawables.get(id), share);
    }
    for (const [id, body] of this.bodies) {
      if (body.seen === this.round) continue;
      this.remove(body);
      this.bodies.delete(id);
    }
  }

  private pose(body: Body, now: Drawable, old: Drawable | undefined, share: number): void {
    const blend = old !== undefined && share < 1 ? old : now, t = blend === now ? 1 : share;
    body.mesh.position.set(...blend.place).lerp(new Vector3(...now.place), t);
    body.mesh.quaternion.set(...blend.turn).slerp(new Quaternion(...now.turn), t);
    body.mesh.scale.set(...now.scale);
    const bones = body.bones, other = new Quaternion(), place = new Vector3();
    for (let i = 0; i < bones.length; ++i) {
      const to = now.bones[i], from = blend.bones[i] ?? to;
      if (to === undefined || from === undefined) continue;
      bones[i]!.position.set(...from.place).lerp(place.set(...to.place), t);
      bones[i]!.quaternion.set(...from.turn).slerp(other.set(...to.turn), t);
    }
  }

  private bodyFor(id: number, look: BodyLook, fine: boolean, team: string): Body {
    const known = this.bodies.get(id);
    if (known !== undefined && known.look === look && known.team === team) {
      if (known.fine !== fine) {
        known.mesh.geometry = this.geometryFor(look, fine, team);
        known.fine = fine;
      }
      return known;
    }
    if (known !== undefined) this.remove(known);
    const skeleton = look === "rifle" ? RIFLE_BONES : SOLDIER_BONES;
    const mesh = new SkinnedMesh(this.geometryFor(look, fine, team), this.materials.of("Soarbox/Soldier", CLOTH_LOOK));
    const bones = skeleton.map(() => new Bone());
    skeleton.forEach((at: BoneAt, i) => {
      const bone = bones[i]!;
      bone.position.set(...at.bind.place);
      bone.quaternion.set(...at.bind.turn);
      (at.parent < 0 ? mesh : bones[at.parent]!).add(bone);
    });
    const inverses = skeleton.map((at) => new Matrix4().compose(new Vector3(...at.inModel.place), new Quaternion(...at.inModel.turn), new Vector3(1, 1, 1)).invert());
    mesh.bind(new Skeleton(bones, inverses), new Matrix4());
    mesh.boundingSphere = new Sphere(new Vector3(0, look === "rifle" ? 0 : 0.9, 0), 1.6);
    mesh.castShadow = true;
    mesh.receiveShadow = true;
    this.group.add(mesh);
    const body: Body = { mesh, bones, look, fine, team, seen: this.round };
    this.bodies.set(id, body);
    return body;
  }

  private geometryFor(look: BodyLook, fine: boolean, team: string): BufferGeometry {
    const name = `${look}${fine}`, key = `${name}|${team}`;
    const known = this.colored.get(key);
    if (known !== undefined) return known;
    let shared = this.skins.get(name);
    if (shared === undefined) {
      const skin = bodyMesh(look, !fine), geometry = geometryOf(skin.mesh, CLOTH_LOOK);
      geometry.setAttribute("skinIndex", new BufferAttribute(Uint16Array.from(skin.bones), 4));
      geometry.setAttribute("skinWeight", new BufferAttribute(Float32Array.from(skin.shares), 4));
      this.skins.set(name, (shared = { skin, geometry }));
    }
    const made = geometryOf(shared.skin.mesh, { ...CLOTH_LOOK, trim: teamColor(team) }, shared.geometry);
    this.colored.set(key, made);
    return made;
  }

  private remove(body: Body): void {
    this.group.remove(body.mesh);
    body.mesh.skeleton.dispose();
  }

  clear(): void {
    for (const body of this.bodies.values()) this.remove(body);
    this.bodies.clear();
  }
}

const CLOTH: Rgb = [1, 1, 1];
const CLOTH_LOOK: Look = { ...lookOf("White"), base: CLOTH, paint: "cloth", gloss: 0.02 };
