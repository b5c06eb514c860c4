// SPDX-License-Identifier: BSD-2-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "world/animation/animator.h"
#include "world/animation/body_bones.h"
#include "world/animation/soldier_skeleton.h"
#include "world/world.h"

namespace soarbox::world {
namespace {

constexpr const char* kSoldier = "models/futuristic_soldier/futuristic_soldier_anim.mesh";
constexpr const char* kWeapon = "models/futuristic_soldier/soldier_weapon.mesh";

std::size_t Clip(const Rig& rig, const char* name) {
  const int clip = rig.FindClip(name);
  EXPECT_GE(clip, 0) << name;
  return static_cast<std::size_t>(clip);
}

std::vector<BonePose> BonesOf(const Animator& animator) {
  return BodyBones(animator.NowPose());
}

TEST(SoldierRig, HasWhatTheSandboxsScriptsName) {
  for (const char* name : {"stand_idle_aim", "stand_run_forward_aim", "stand_run_backward_aim", "stand_fire_one_shot",
                           "stand_reload", "stand_melee_1_with_weapon", "stand_dead_2", "stand_dead_headshot",
                           "stand_jump_up", "stand_jump_land", "stand_smg_transform", "stand_sniper_transform",
                           "crouch_idle_aim", "crouch_forward_aim", "crouch_fire_one_shot"})
    EXPECT_GE(SoldierRig().FindClip(name), 0) << name;
  for (const char* name : {"sniper_idle", "sniper_reload", "sniper_transform", "smg_idle", "smg_transform"})
    EXPECT_GE(RifleRig().FindClip(name), 0) << name;
  EXPECT_GE(SoldierRig().skeleton.Find("b_RightHand"), 0);
  EXPECT_GE(SoldierRig().skeleton.Find("b_Head1"), 0);
  EXPECT_GE(RifleRig().skeleton.Find("b_muzzle"), 0);
}

TEST(SoldierRig, EveryMovementHasALengthAndPosesThatHoldTogether) {
  for (const Rig* rig : {&SoldierRig(), &RifleRig()}) {
    for (std::size_t c = 0; c < rig->clips.size(); ++c) {
      const soarbox::world::Clip& clip = rig->clips[c];
      ASSERT_GT(clip.length_s(), 0.1f) << clip.name();
      Animator animator(*rig);
      animator.SetEnabled(c, true);
      animator.SetLooping(c, false);
      for (float t = 0; t <= clip.length_s(); t += 0.05f) {
        animator.SetTime(c, t);
        for (const BonePose& bone : BonesOf(animator)) {
          ASSERT_TRUE(IsFinite(bone.position) && IsFinite(bone.orientation)) << clip.name();
          ASSERT_GT(bone.position.y, rig == &SoldierRig() ? -0.05f : -0.5f) << clip.name() << " at " << t;
          ASSERT_LT(Length(bone.position), 2.2f) << clip.name();
        }
      }
    }
  }
}

TEST(SoldierRig, CyclesEndWhereTheyStart) {
  for (const soarbox::world::Clip& clip : SoldierRig().clips) {
    if (!clip.is_cycle()) continue;
    for (std::size_t bone = 0; bone < kSoldierBones; ++bone)
      EXPECT_EQ(clip.At(bone, 0), clip.At(bone, clip.length_s())) << clip.name();
  }
}

TEST(SoldierRig, BothHandsHoldTheRifleInAllGaits) {
  for (const char* name : {"stand_idle_aim", "stand_walk_forward", "stand_run_forward_aim", "stand_sprint_forward",
                           "crouch_idle_aim", "crouch_forward_aim", "stand_fire_one_shot"}) {
    Animator animator(SoldierRig());
    const std::size_t clip = Clip(SoldierRig(), name);
    animator.SetEnabled(clip, true);
    for (float t = 0; t < SoldierRig().clips[clip].length_s(); t += 0.04f) {
      animator.SetTime(clip, t);
      const BonePose rifle = BonesOf(animator)[kRightHand] *
                             BonePose{RifleHold::kAttachOffset, FromRotationVector(RifleHold::kAttachRotation_deg)};
      const Vec3 wanted = rifle.Apply(HoldOfRifle().left_wrist);
      EXPECT_LT(Distance(BonesOf(animator)[kLeftHand].position, wanted), 0.04f) << name << " at " << t;
    }
  }
}

TEST(Animator, WrapsOrHoldsTheTimeAsLoopingSays) {
  Animator animator(SoldierRig());
  const std::size_t clip = Clip(SoldierRig(), "stand_fire_one_shot");
  EXPECT_FALSE(animator.state(clip).enabled);
  EXPECT_TRUE(animator.state(clip).looping);
  EXPECT_EQ(animator.state(clip).weight, 1.0f);
  animator.SetTime(clip, 0.6f);
  EXPECT_NEAR(animator.state(clip).time_s, 0.1f, 1e-5f);
  animator.SetTime(clip, -0.1f);
  EXPECT_NEAR(animator.state(clip).time_s, 0.4f, 1e-5f);
  animator.SetLooping(clip, false);
  animator.SetTime(clip, animator.state(clip).time_s + 9);
  EXPECT_EQ(animator.state(clip).time_s, 0.5f);
  animator.SetTime(clip, -3);
  EXPECT_EQ(animator.state(clip).time_s, 0.0f);
}

TEST(Animator, MixesByWeightAndFillsUpWithTheBindPose) {
  Animator animator(SoldierRig());
  const std::size_t stand = Clip(SoldierRig(), "stand_idle_aim"), crouch = Clip(SoldierRig(), "crouch_idle_aim");
  const float bind = BonesOf(animator)[kHips].position.y;
  animator.SetEnabled(stand, true);
  const float standing = BonesOf(animator)[kHips].position.y;
  animator.SetEnabled(stand, false);
  animator.SetEnabled(crouch, true);
  const float crouching = BonesOf(animator)[kHips].position.y;
  EXPECT_LT(crouching, standing - 0.2f);
  animator.SetEnabled(stand, true);  // Weights 1 and 1 give half of each.
  const std::vector<BonePose> bones = BonesOf(animator);
  EXPECT_NEAR(bones[kHips].position.y, (standing + crouching) / 2, 1e-3f);
  for (std::size_t i = 0; i < bones.size(); ++i) EXPECT_EQ(animator.NowPose().WorkOut(i), bones[i]);
  animator.SetEnabled(stand, false);
  animator.SetWeight(crouch, 0.25f);
  EXPECT_NEAR(BonesOf(animator)[kHips].position.y, 0.25f * crouching + 0.75f * bind, 1e-3f);
  animator.SetWeight(crouch, -1);
  EXPECT_EQ(BonesOf(animator)[kHips].position.y, bind);
}

/// A model of a bone and its child. "rise" moves the child up by 1 m within 1 s, "stretch" doubles the bone at 1 s.
const Rig& ModelRig() {
  static const Rig* const kept = [] {
    Rig rig;
    rig.model = "model.glb#00000000000000aa";
    rig.skeleton.AddToParent("bone", -1, {{0, 1, 0}, {}, {2, 2, 2}});
    rig.skeleton.AddToParent("child", 0, {{1, 0, 0}, {}, {1, 1, 1}});
    std::vector<BoneMovement> rise, stretch;
    for (const Skeleton::Bone& bone : rig.skeleton.bones()) {
      rise.push_back({bone.bind, {}, {}, {}});
      stretch.push_back({bone.bind, {}, {}, {}});
    }
    rise[1].position = {{0, 1}, {{1, 0, 0}, {1, 1, 0}}, false};
    stretch[0].scale = {{0, 1}, {{2, 2, 2}, {4, 2, 2}}, true};
    rig.clips.emplace_back(soarbox::world::Clip::Settings{.name = "rise", .length_s = 1}, rise);
    rig.clips.emplace_back(soarbox::world::Clip::Settings{.name = "stretch", .length_s = 1}, stretch);
    KeepRig(rig);
    return FindRig(rig.model);
  }();
  return *kept;
}

TEST(ModelRigs, ScalesOfBonesMoveTheirChildren) {
  Animator animator(ModelRig());
  EXPECT_EQ(BonesOf(animator)[1].position, (Vec3{2, 1, 0}));
  EXPECT_EQ(BonesOf(animator)[1].scale, (Vec3{2, 2, 2}));
  animator.SetEnabled(0, true);
  animator.SetTime(0, 0.5f);
  EXPECT_EQ(BonesOf(animator)[1].position, (Vec3{2, 2, 0}));
  animator.SetEnabled(0, false);
  animator.SetEnabled(1, true);
  animator.SetLooping(1, false);
  animator.SetTime(1, 0.99f);
  EXPECT_EQ(BonesOf(animator)[1].position, (Vec3{2, 1, 0}));
  animator.SetTime(1, 1);
  EXPECT_EQ(BonesOf(animator)[1].position, (Vec3{4, 1, 0}));
  EXPECT_EQ(RigOfMesh(ModelRig().model), &ModelRig());
  EXPECT_EQ(RigOfMesh("model.glb#00000000000000ab"), nullptr);
  EXPECT_EQ(RigOfMesh(kSoldier), &SoldierRig());
}

TEST(Animator, PlaysLoopsAndKeepsTheLastPoseWithoutThem) {
  Animator animator(ModelRig());
  animator.Play(0, true, 2, 0);
  for (int i = 0; i < 3; ++i) animator.Advance(nullptr, 0.25f);
  EXPECT_FLOAT_EQ(animator.state(0).time_s, 0.5f);
  animator.Play(0, false, 2, 0);  // It plays already, so it continues.
  EXPECT_FLOAT_EQ(animator.state(0).time_s, 0.5f);
  for (int i = 0; i < 3; ++i) animator.Advance(nullptr, 0.25f);
  EXPECT_FLOAT_EQ(animator.state(0).time_s, 1);
  // Nothing changes any more, so nothing is drawn or recorded again.
  const std::uint64_t changes = animator.changes();
  animator.Advance(nullptr, 0.25f);
  EXPECT_EQ(animator.changes(), changes);
  EXPECT_TRUE(animator.state(0).enabled);
  animator.Play(0, false, 1, 0);  // It has ended, so it begins again.
  EXPECT_EQ(animator.state(0).time_s, 0);
  animator.Play(1, true, -1, 0);
  EXPECT_FALSE(animator.state(0).enabled);
  EXPECT_EQ(animator.state(1).time_s, 1);
  animator.Advance(nullptr, 0.25f);
  EXPECT_FLOAT_EQ(animator.state(1).time_s, 0.75f);
}

TEST(Animator, FadesOutWhateverTheWeightAndLeavesNoHalfFade) {
  Animator animator(ModelRig());
  animator.Play(0, true, 1, 0);
  animator.SetWeight(0, 2);
  animator.Play({}, true, 1, 0.25f);
  for (int i = 0; i < 5; ++i) animator.Advance(nullptr, 0.125f);
  EXPECT_FALSE(animator.state(0).enabled);
  EXPECT_EQ(animator.state(0).weight, 1);
  animator.Play(1, true, 1, 0.5f);
  animator.Advance(nullptr, 0.125f);
  animator.SetEnabled(1, false);
  EXPECT_EQ(animator.state(1).weight, 1);
}

TEST(Animator, BlendsFromOneAnimationToTheNextAndToTheBindPose) {
  Animator animator(ModelRig());
  animator.Play(0, true, 1, 0.5f);
  EXPECT_EQ(animator.state(0).weight, 0);
  animator.Advance(nullptr, 0.25f);
  EXPECT_FLOAT_EQ(animator.state(0).weight, 0.5f);
  animator.Advance(nullptr, 0.25f);
  animator.Play(1, true, 1, 0.5f);
  animator.Advance(nullptr, 0.125f);
  EXPECT_FLOAT_EQ(animator.state(0).weight, 0.75f);
  EXPECT_FLOAT_EQ(animator.state(1).weight, 0.25f);
  for (int i = 0; i < 3; ++i) animator.Advance(nullptr, 0.125f);
  EXPECT_FALSE(animator.state(0).enabled);
  EXPECT_EQ(animator.state(1).weight, 1);
  animator.Play({}, true, 1, 0.25f);
  animator.Advance(nullptr, 0.125f);
  EXPECT_FLOAT_EQ(animator.state(1).weight, 0.5f);
  animator.Advance(nullptr, 0.125f);
  EXPECT_FALSE(animator.state(1).enabled);
  EXPECT_TRUE(animator.NowPose().parts.empty());
  // Animations that scripts step themselves are not changed.
  animator.SetEnabled(0, true);
  animator.Play(1, true, 1, 0);
  animator.Play({}, true, 1, 0);
  animator.Advance(nullptr, 1);
  EXPECT_TRUE(animator.state(0).enabled);
  EXPECT_EQ(animator.state(0).time_s, 0);
}

TEST(SceneAnimation, TheWorldAdvancesAnimationsAndHashesThem) {
  const auto hash_after = [](int ticks, float speed) {
    World world;
    world.catalog().AddMesh(ModelRig().model, {});
    const NodeId mesh = world.scene().CreateMesh(NodeId::kRoot, ModelRig().model);
    const NodeId hat = world.scene().CreateBox(NodeId::kRoot, 1, 1, 1);
    EXPECT_TRUE(world.scene().AttachToBone(mesh, 1, hat, {}, {}));
    world.scene().AnimatorOf(mesh)->Play(0, true, speed, 0);
    for (int i = 0; i < ticks; ++i) world.Step();
    EXPECT_EQ(world.scene().WorldPosition(hat).y > 1.5f, speed > 0);
    return world.Hash();
  };
  EXPECT_EQ(hash_after(15, 1), hash_after(15, 1));
  EXPECT_NE(hash_after(15, 1), hash_after(15, 0));
  EXPECT_NE(hash_after(15, 1), hash_after(16, 1));
}

/// An agent that walks at a constant speed, with an automatically animated body.
class Walker {
 public:
  explicit Walker(float speed_mps, LocomotionStyle style = LocomotionStyle::kReady) : speed_(speed_mps) {
    world_.CreatePlane(400, 400);
    id_ = world_.CreateAgent({});
    body_ = world_.scene().CreateMesh(world_.NodeOf(id_), kSoldier);
    world_.scene().SetPosition(body_, {0, -0.8f, 0});
    world_.scene().AnimatorOf(body_)->SetLocomotion(true, style);
    world_.FindAgent(id_)->SetPosition({0, 0.8f, 0});
  }
  void Tick() {
    world_.BeginTick();
    world_.FindAgent(id_)->SetVelocity({0, 0, speed_});
    world_.SyncAgent(id_);
    world_.Step();
  }
  /// Position of a bone in the world as it is drawn.
  Vec3 Drawn(int bone) const {
    for (const DrawableSnapshot& drawable : world_.Snapshot().drawables) {
      if (drawable.bones.empty()) continue;
      return drawable.position + Rotate(drawable.orientation, drawable.bones[static_cast<std::size_t>(bone)].position);
    }
    return {};
  }
  World& world() { return world_; }
  EntityId id() const { return id_; }
  NodeId body() const { return body_; }

 private:
  World world_;
  float speed_;
  EntityId id_{};
  NodeId body_{};
};

TEST(Locomotion, FeetThatStandDoNotSlide) {
  for (const float speed : {1.3f, 3.2f}) {
    Walker walker(speed);
    for (int i = 0; i < 60; ++i) walker.Tick();
    // The lower foot is on the ground. While the same foot is on the ground and flat, it must not move.
    float slid = 0, walked = 0;
    Vec3 left = walker.Drawn(kLeftToe), right = walker.Drawn(kRightToe);
    for (int i = 0; i < 90; ++i) {
      walker.Tick();
      const Vec3 next_left = walker.Drawn(kLeftToe), next_right = walker.Drawn(kRightToe);
      if (left.y < 0.027f && next_left.y < 0.027f) slid += std::abs(next_left.z - left.z);
      if (right.y < 0.027f && next_right.y < 0.027f) slid += std::abs(next_right.z - right.z);
      walked += speed / 30;
      left = next_left;
      right = next_right;
    }
    EXPECT_LT(slid, 0.06f * walked) << "at " << speed << " m/s";
  }
}

TEST(Locomotion, WhoHasNoRifleLetsHisArmsHang) {
  Walker walker(0, LocomotionStyle::kUnarmed);
  for (int i = 0; i < 10; ++i) walker.Tick();
  for (const int hand : {kLeftHand, kRightHand}) {
    EXPECT_LT(walker.Drawn(hand).y, 1.0f);
    EXPECT_LT(std::abs(walker.Drawn(hand).z), 0.2f);
  }
  // When walking, hands swing in opposite directions.
  Walker on_his_way(1.3f, LocomotionStyle::kUnarmed);
  float most = 0;
  for (int i = 0; i < 60; ++i) {
    on_his_way.Tick();
    const float apart = on_his_way.Drawn(kLeftHand).z - on_his_way.Drawn(kRightHand).z;
    const float feet = on_his_way.Drawn(kLeftFoot).z - on_his_way.Drawn(kRightFoot).z;
    most = std::max(most, std::abs(apart));
    if (i > 20 && std::abs(feet) > 0.3f) {
      EXPECT_LT(apart * feet, 0) << i;
    }
  }
  EXPECT_GT(most, 0.2f);
}

TEST(Locomotion, GoesOverToAnotherStyleWithoutAJump) {
  Walker walker(0);
  for (int i = 0; i < 10; ++i) walker.Tick();
  for (const LocomotionStyle style :
       {LocomotionStyle::kCrouch, LocomotionStyle::kAim, LocomotionStyle::kUnarmed, LocomotionStyle::kReady}) {
    walker.world().scene().AnimatorOf(walker.body())->SetLocomotion(true, style);
    for (int i = 0; i < 15; ++i) {
      const Vec3 hand = walker.Drawn(kRightHand), head = walker.Drawn(kHead);
      walker.Tick();
      EXPECT_LT(Distance(hand, walker.Drawn(kRightHand)), 0.12f);
      EXPECT_LT(Distance(head, walker.Drawn(kHead)), 0.12f);
    }
  }
  EXPECT_GT(walker.Drawn(kHead).y, 1.4f);
}

TEST(Locomotion, FallsWhenItsAgentDies) {
  Walker walker(0);
  for (int i = 0; i < 10; ++i) walker.Tick();
  EXPECT_GT(walker.Drawn(kHead).y, 1.4f);
  walker.world().FindAgent(walker.id())->SetHealth(0);
  for (int i = 0; i < 90; ++i) walker.Tick();
  EXPECT_LT(walker.Drawn(kHead).y, 0.4f);
}

TEST(SceneAnimation, BonesOfAnAttachedRifleAreFoundThroughTheSoldier) {
  World world;
  const NodeId soldier = world.scene().CreateMesh(NodeId::kRoot, kSoldier);
  const NodeId weapon = world.scene().CreateMesh(NodeId::kRoot, kWeapon);
  Animator& animator = *world.scene().AnimatorOf(soldier);
  animator.SetEnabled(Clip(animator.rig(), "stand_idle_aim"), true);
  EXPECT_FALSE(world.scene().BoneInWorld(soldier, "b_muzzle"));
  ASSERT_TRUE(world.scene().AttachToBone(soldier, kRightHand, weapon, RifleHold::kAttachOffset,
                                         FromRotationVector(RifleHold::kAttachRotation_deg)));
  world.scene().SetPosition(soldier, {10, 0, 0});
  const auto muzzle = world.scene().BoneInWorld(soldier, "b_muzzle");
  ASSERT_TRUE(muzzle);
  // It points along the soldier's front, at shoulder height.
  EXPECT_GT(Rotate(muzzle->orientation, {1, 0, 0}).z, 0.95f);
  EXPECT_GT(Rotate(muzzle->orientation, {0, 1, 0}).y, 0.9f);
  EXPECT_NEAR(muzzle->position.x, 10, 0.25f);
  EXPECT_NEAR(muzzle->position.y, 1.35f, 0.12f);
  EXPECT_GT(muzzle->position.z, 0.7f);
  // The head looks along -z of its bone.
  const auto head = world.scene().BoneInWorld(soldier, "b_Head1");
  ASSERT_TRUE(head);
  EXPECT_GT(Rotate(head->orientation, {0, 0, -1}).z, 0.9f);
  EXPECT_FALSE(world.scene().AttachToBone(weapon, 0, soldier, {}, {})) << "a soldier cannot hang on what it carries";
  world.scene().Remove(soldier);
  EXPECT_FALSE(world.scene().Contains(weapon));
  EXPECT_TRUE(world.scene().animated().empty());
}

TEST(SceneAnimation, AChainOfThousandsOfRiflesHurtsNobody) {
  World world;
  NodeId last = world.scene().CreateMesh(NodeId::kRoot, kSoldier);
  const NodeId first = last;
  for (int i = 0; i < 3000; ++i) {
    const NodeId next = world.scene().CreateMesh(NodeId::kRoot, kWeapon);
    const bool hangs = world.scene().AttachToBone(last, 0, next, {}, {});
    ASSERT_EQ(hangs, i < Scene::kDeepest - 1);
    if (hangs) last = next;
    if (!hangs) world.scene().Remove(next);
  }
  EXPECT_TRUE(world.scene().BoneInWorld(first, "b_muzzle"));
  EXPECT_FALSE(world.scene().BoneInWorld(first, "b_none"));
  EXPECT_TRUE(world.scene().Remove(first));
  EXPECT_FALSE(world.scene().Contains(last));
  EXPECT_TRUE(world.scene().animated().empty());
}

TEST(SceneAnimation, IsPartOfTheHashAndOfTheSnapshot) {
  World a, b;
  for (World* world : {&a, &b}) world->scene().CreateMesh(NodeId::kRoot, kSoldier);
  EXPECT_EQ(a.Hash(), b.Hash());
  b.scene().AnimatorOf(b.scene().animated()[0])->SetTime(3, 0.1f);
  EXPECT_NE(a.Hash(), b.Hash());
  ASSERT_EQ(a.Snapshot().drawables.size(), 1u);
  EXPECT_EQ(a.Snapshot().drawables[0].bones.size(), static_cast<std::size_t>(kSoldierBones));
}

TEST(SceneAnimation, WhatIsDrawnStandsWhereItsBodyIs) {
  Walker walker(7);
  for (int i = 0; i < 20; ++i) walker.Tick();
  const SceneSnapshot snapshot = walker.world().Snapshot();
  for (const DrawableSnapshot& drawable : snapshot.drawables) {
    if (!drawable.belongs_to_agent) continue;
    EXPECT_EQ(drawable.position.z, snapshot.agents[0].position.z);
  }
  const EntityId ball = walker.world().CreateBox(1, 1, 1);
  walker.world().FindObject(ball)->SetPosition({5, 5, 5});
  walker.world().FindObject(ball)->SetVelocity({9, 0, 0});
  walker.Tick();
  EXPECT_EQ(walker.world().Snapshot().drawables.back().position, walker.world().FindObject(ball)->Position());
}

}  // namespace
}  // namespace soarbox::world
