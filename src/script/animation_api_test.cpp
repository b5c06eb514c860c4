// SPDX-License-Identifier: BSD-2-Clause
#include "script/host_test_support.h"

// The table Animation as seen from scripts.

namespace soarbox::script {
namespace {

class AnimationApiTest : public HostTest {
 protected:
  AnimationApiTest() {
    Write("Quiet.lua", "");
    StartWith(R"(
      function Sandbox_Initialize(s)
        sandbox = s
        agent = Sandbox.CreateAgent(s, 'Quiet.lua')
        body = Core.CreateMesh(agent, 'models/futuristic_soldier/futuristic_soldier_anim.mesh')
        Core.SetPosition(body, Vector.new(0, -0.8, 0))
        gun = Core.CreateMesh(agent, 'models/futuristic_soldier/soldier_weapon.mesh')
        fire = Animation.GetAnimation(body, 'stand_fire_one_shot')
      end)");
  }
};

TEST_F(AnimationApiTest, AMovementStartsDisabledLoopingAtTimeZeroWithWeightOne) {
  EXPECT_EQ(Errors(), "");
  EXPECT_EQ(Run("print(Animation.GetName(fire), Animation.GetLength(fire) > 0, Animation.GetTime(fire), "
                "Animation.GetNormalizedTime(fire), Animation.GetWeight(fire), Animation.IsEnabled(fire), "
                "Animation.IsLooping(fire), type(fire))"),
            "stand_fire_one_shot\ttrue\t0\t0\t1\tfalse\ttrue\tuserdata");
  EXPECT_EQ(Run("print(fire == Animation.GetAnimation(body, 'stand_fire_one_shot'), "
                "fire == Animation.GetAnimation(body, 'stand_reload'))"),
            "true\tfalse");
}

TEST_F(AnimationApiTest, TimesWrapOrAreHeldAndNothingMovesByItself) {
  EXPECT_EQ(Run("Animation.SetTime(fire, 0.75) print(Animation.GetTime(fire), Animation.GetNormalizedTime(fire))"),
            "0.25\t0.5");
  Ticks(3);
  EXPECT_EQ(Run("print(Animation.GetTime(fire)) Animation.StepAnimation(fire, 125) print(Animation.GetTime(fire))"),
            "0.25|0.375");
  EXPECT_EQ(Run("Animation.SetTime(fire, -0.125) print(Animation.GetTime(fire)) Animation.SetLooping(fire, false) "
                "Animation.StepAnimation(fire, 9000) print(Animation.GetTime(fire), Animation.IsLooping(fire)) "
                "Animation.Reset(fire) print(Animation.GetTime(fire))"),
            "0.375|0.5\tfalse|0");
  EXPECT_EQ(Run("Animation.SetNormalizedTime(fire, 7) print(Animation.GetTime(fire)) Animation.SetWeight(fire, -2.5) "
                "Animation.SetEnabled(fire, 0) print(Animation.GetWeight(fire), Animation.IsEnabled(fire))"),
            "0.5|-2.5\ttrue");
}

TEST_F(AnimationApiTest, MistakesAreToldWithWhatWasMeant) {
  EXPECT_EQ(Run("print(pcall(Animation.GetAnimation, body, 'stand_fire_one_shoot'))"),
            "false\tbad argument #2 to 'Animation.GetAnimation' (there is no animation \"stand_fire_one_shoot\" here; "
            "did you mean "
            "\"stand_fire_one_shot\"?)");
  EXPECT_EQ(Run("print(pcall(Animation.GetAnimation, agent, 'stand_reload'))"),
            "false\tbad argument #1 to 'Animation.GetAnimation' (a mesh expected, got an agent; pass the mesh that "
            "is attached to it)");
  EXPECT_EQ(
      Run("local box = Core.CreateBox(sandbox, 1, 1, 1) print(pcall(Animation.GetAnimation, box, 'x'))"),
      "false\tbad argument #1 to 'Animation.GetAnimation' (this has no mesh with a skeleton, so it has no animations)");
  EXPECT_EQ(Run("print(pcall(Animation.GetLength, body))"),
            "false\tbad argument #1 to 'Animation.GetLength' (animation expected, got scene node)");
  EXPECT_EQ(Run("print(pcall(Animation.GetLength, nil))"),
            "false\tbad argument #1 to 'Animation.GetLength' (animation expected, got nil)");
  EXPECT_EQ(Run("print(pcall(Animation.GetAnimation, body))"),
            "false\t\"Animation.GetAnimation\" expected 2 arguments, encountered 1");
  recorder_.warnings.clear();
  EXPECT_EQ(Run("print(type(Animation.GetBonePosition(body, 'b_Head') or nil))"), "nil");
  ASSERT_EQ(recorder_.warnings.size(), 1u);
  EXPECT_EQ(recorder_.warnings[0].message,
            "there is no bone \"b_Head\"; did you mean \"b_Head1\"?: the call is ignored");
  EXPECT_EQ(Run("Animation.SetTime(fire, 0 / 0) Animation.StepAnimation(fire, 1 / 0) Animation.SetWeight(fire, 0 / 0) "
                "print(Animation.GetTime(fire), Animation.GetWeight(fire))"),
            "0\t1");
  EXPECT_EQ(Run("Animation.SetTime(fire) print(Animation.GetTime(fire))"), "0");
  EXPECT_EQ(Run("print(pcall(Animation.SetLocomotion, body, true, 'moonwalk'))"),
            "false\tbad argument #3 to 'Animation.SetLocomotion' (a style is ready, aim, crouch or unarmed)");
}

TEST_F(AnimationApiTest, BonesAreFoundInTheBodyAndInWhatItCarries) {
  EXPECT_EQ(Run("local n = Animation.GetBoneNames(body) print(n[0], #Animation.GetBoneNames(sandbox))"), "b_Hips\t0");
  EXPECT_EQ(Run("agent:SetPosition(Vector.new(3, 0.8, 4)) Animation.SetEnabled(Animation.GetAnimation(body, "
                "'stand_idle_aim'), true) local p = Animation.GetBonePosition(body, 'b_Head1') "
                "print(p.y > 1.4 and p.y < 1.6, math.abs(p.x - 3) < 0.3, math.abs(p.z - 4) < 0.3)"),
            "true\ttrue\ttrue");
  EXPECT_EQ(
      Run("Animation.AttachToBone(body, 'b_RightHand', gun, Vector.new(0.04, 0.05, -0.01), Vector.new(98, 97, 0)) "
          "local p = Animation.GetBonePosition(body, 'b_muzzle') local r = Animation.GetBoneRotation(body, "
          "'b_muzzle') local forward = Vector.Rotate(Vector.new(1, 0, 0), r) "
          "print(forward.z > 0.95, p.z > 4.6, p.y > 1.2 and p.y < 1.5)"),
      "true\ttrue\ttrue");
  // After a half turn, the rifle points in the opposite direction.
  EXPECT_EQ(Run("agent:SetForward(Vector.new(0, 0, -1)) local p = Animation.GetBonePosition(body, 'b_muzzle') "
                "print(p.z < 3.4)"),
            "true");
  recorder_.warnings.clear();
  Run("Animation.AttachToBone(body, 'b_RightHand', agent)");
  ASSERT_EQ(recorder_.warnings.size(), 1u);
  EXPECT_EQ(recorder_.warnings[0].message, "argument 3 is not a scene node but AgentType: the call is ignored");
  EXPECT_EQ(Run("Core.Remove(body) print(pcall(Animation.GetTime, fire))"),
            "false\tbad argument #1 to 'Animation.GetTime' (the mesh of this animation was removed)");
}

TEST_F(AnimationApiTest, ABodyWalksByItselfWhenAskedTo) {
  Run("Sandbox.CreatePlane(sandbox, 100, 100) agent:SetPosition(Vector.new(0, 0.8, 0)) "
      "Animation.SetLocomotion(body, true) Animation.SetDisplaySkeleton(body, true)");
  const auto foot_height = [this] { return Run("print(Animation.GetBonePosition(body, 'b_LeftFoot').y > 0.12)"); };
  Ticks(10);
  EXPECT_EQ(foot_height(), "false");
  int lifted = 0;
  for (int i = 0; i < 40; ++i) {
    Run("agent:SetVelocity(Vector.new(0, 0, 3))");
    Tick();
    lifted += foot_height() == "true" ? 1 : 0;
  }
  EXPECT_GT(lifted, 10);
  EXPECT_LT(lifted, 35);
}

/// A model from a file, with the animation "bend".
class ModelAnimationTest : public HostTest {
 protected:
  ModelAnimationTest() {
    std::filesystem::copy_file(std::filesystem::path(SOARBOX_SOURCE_DIR) / "tests/fuzz/models_corpus/arm.gltf",
                               folder_ / "arm.gltf");
    StartWith(R"(
      function Sandbox_Initialize(s)
        arm = Core.CreateMesh(s, 'arm.gltf')
        object = Sandbox.CreateObject(s, 'arm.gltf')
      end)");
  }
};

TEST_F(ModelAnimationTest, AModelHasTheBonesAndAnimationsOfItsFile) {
  EXPECT_EQ(Errors(), "");
  EXPECT_EQ(Run("print(table.concat(Animation.GetAnimationNames(arm), ' '), Animation.GetBoneNames(arm)[1])"),
            "bend\telbow");
  EXPECT_EQ(Run("local a = Animation.Play(object, 'bend') print(Animation.GetName(a), Animation.GetLength(a))"),
            "bend\t1");
}

TEST_F(ModelAnimationTest, TheWorldAdvancesWhatIsPlayed) {
  Run("bend = Animation.Play(arm, 'bend', false, 2, 0)");
  Ticks(6);
  EXPECT_EQ(Run("print(string.format('%.2f', Animation.GetTime(bend)), Animation.IsLooping(bend))"), "0.40\tfalse");
  Ticks(30);
  EXPECT_EQ(Run("print(Animation.GetTime(bend), Animation.IsEnabled(bend)) Animation.Stop(arm, 0) "
                "print(Animation.IsEnabled(bend))"),
            "1\ttrue|false");
  EXPECT_EQ(Run("Animation.Play(arm, 'bend')"), "");
  Ticks(3);
  EXPECT_EQ(Run("local w = Animation.GetWeight(bend) print(w > 0.4 and w < 0.6)"), "true");
}

TEST_F(ModelAnimationTest, ArgumentsAfterAnOmittedOneCount) {
  Run("bend = Animation.Play(arm, 'bend', nil, 2, 0)");
  Ticks(6);
  EXPECT_EQ(Run("print(string.format('%.2f', Animation.GetTime(bend)))"), "0.40");
}

TEST_F(ModelAnimationTest, AnUnknownNameIsAnErrorThatListsTheKnownOnes) {
  EXPECT_EQ(Run("print(pcall(Animation.Play, arm, 'bent'))"),
            "false\tbad argument #2 to 'Animation.Play' (there is no animation \"bent\" here; did you mean \"bend\"? "
            "There are bend)");
  EXPECT_EQ(Run("print(pcall(Animation.Play, arm, 'dance'))"),
            "false\tbad argument #2 to 'Animation.Play' (there is no animation \"dance\" here; there are bend)");
  recorder_.warnings.clear();
  Run("Animation.Play(arm, 'bend', true, 1000)");
  ASSERT_EQ(recorder_.warnings.size(), 1u);
  EXPECT_NE(recorder_.warnings[0].message.find("the speed, is 1000: 100 is used"), std::string::npos);
}

}  // namespace
}  // namespace soarbox::script
