// SPDX-License-Identifier: BSD-2-Clause
// Checks properties of measures in generated scenes.
#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "kernel/imagery/imagery_scene.h"
#include "kernel/imagery/measures.h"
#include "kernel/imagery/scene_lines.h"

namespace soarbox::kernel::imagery {
namespace {

/// Nodes with shapes of all kinds; some are in groups.
class GeneratedScene {
 public:
  explicit GeneratedScene(unsigned seed) : random_(seed) {
    Node* const frame = scene_.Add(scene_.root(), {"frame", Shape::kGroup, {}, 0, {}});
    for (int n = 0; n < 8; ++n) {
      NodeSpec spec;
      spec.id = "n" + std::to_string(n);
      spec.pose.position = Point(4);
      spec.pose.rotation = Point(3);
      spec.shape = n % 3 == 0 ? Shape::kBall : Shape::kHull;
      spec.radius = 0.2 + Number(0.8);
      if (n % 3 != 0) {
        for (int corner = 0; corner < 4 + n; ++corner) spec.points.push_back(Point(1));
      }
      scene_.Add(*frame, std::move(spec));
    }
  }
  Scene& scene() { return scene_; }
  double Number(double limit) { return limit * (static_cast<double>(random_() % 2000001) / 1e6 - 1); }
  Vec3 Point(double limit) { return {Number(limit), Number(limit), Number(limit)}; }
  template <typename Visit>
  void ForEachPair(Visit visit) {
    const Node& frame = *scene_.Find("frame");
    for (const auto& a : frame.children()) {
      for (const auto& b : frame.children()) {
        if (a != b) visit(*a, *b);
      }
    }
  }

 private:
  std::mt19937 random_;
  Scene scene_{"S1"};
};

TEST(Geometry, DistancesAreTheSameBothWaysAndNoLongerThanBetweenAnyPoints) {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    GeneratedScene generated(seed);
    generated.ForEachPair([](const Node& a, const Node& b) {
      const double distance = HullDistance(a, b);
      EXPECT_NEAR(distance, HullDistance(b, a), 1e-9);
      EXPECT_GE(distance, a.Bounds().Gap(b.Bounds()) - 1e-9);
      if (a.shape() != Shape::kHull || b.shape() != Shape::kHull) return;
      for (const Vec3& from : a.WorldPoints()) {
        for (const Vec3& to : b.WorldPoints()) EXPECT_LE(distance, Distance(from, to) + 1e-9);
      }
    });
  }
}

/// Whether a point is on or in the shape of a node, except for rounding errors.
bool Touches(const Node& node, const Vec3& point) {
  Scene scene("S2");
  const Node* const spot = scene.Add(scene.root(), {"spot", Shape::kHull, {{}}, 0, {point, {}, {1, 1, 1}}});
  return HullDistance(node, *spot) < 1e-6;
}

TEST(Geometry, TheShortestLineIsAsLongAsTheDistance) {
  for (unsigned seed = 1; seed <= 100; ++seed) {
    GeneratedScene generated(seed);
    generated.ForEachPair([&](const Node& a, const Node& b) {
      const double distance = HullDistance(a, b);
      if (distance <= 0) return;
      const SightLine line = ShortestLine(a, b);
      EXPECT_NEAR(Distance(line.from, line.to), distance, 1e-6 * (1 + distance)) << "seed " << seed;
      EXPECT_TRUE(Touches(a, line.from) && Touches(b, line.to)) << "seed " << seed;
    });
  }
}

TEST(Geometry, MovingAndTurningEverythingChangesNoDistance) {
  for (unsigned seed = 1; seed <= 100; ++seed) {
    GeneratedScene generated(seed);
    std::vector<double> before, after;
    generated.ForEachPair([&](const Node& a, const Node& b) { before.push_back(HullDistance(a, b)); });
    Pose pose;
    pose.position = generated.Point(50);
    pose.rotation = generated.Point(3);
    generated.scene().Move(*generated.scene().Find("frame"), pose);
    generated.ForEachPair([&](const Node& a, const Node& b) { after.push_back(HullDistance(a, b)); });
    for (std::size_t n = 0; n < before.size(); ++n) EXPECT_NEAR(before[n], after[n], 1e-7) << "seed " << seed;
  }
}

TEST(Geometry, ScalingEverythingScalesDistances) {
  for (unsigned seed = 1; seed <= 50; ++seed) {
    GeneratedScene generated(seed);
    std::vector<double> before, after;
    generated.ForEachPair([&](const Node& a, const Node& b) { before.push_back(HullDistance(a, b)); });
    Pose pose;
    pose.scale = {3, 3, 3};
    generated.scene().Move(*generated.scene().Find("frame"), pose);
    generated.ForEachPair([&](const Node& a, const Node& b) { after.push_back(HullDistance(a, b)); });
    for (std::size_t n = 0; n < before.size(); ++n) EXPECT_NEAR(3 * before[n], after[n], 1e-7) << "seed " << seed;
  }
}

TEST(Geometry, ABallThatIsScaledUnevenlyIsAnEllipsoid) {
  Scene scene("S1");
  ASSERT_FALSE(ApplyLine(scene, "add egg world b 1 s 2 1 1"));
  ASSERT_FALSE(ApplyLine(scene, "add left world v 5 0 0"));
  ASSERT_FALSE(ApplyLine(scene, "add above world v 0 5 0"));
  EXPECT_NEAR(HullDistance(*scene.Find("egg"), *scene.Find("left")), 3, 1e-6);
  EXPECT_NEAR(HullDistance(*scene.Find("egg"), *scene.Find("above")), 4, 1e-6);
}

TEST(Geometry, WhatTouchesHasNoDistance) {
  Scene scene("S1");
  const std::string cube = " v 0 0 0 1 0 0 0 1 0 0 0 1 1 1 0 1 0 1 0 1 1 1 1 1 ";
  ASSERT_FALSE(ApplyLine(scene, "add a world" + cube));
  for (const char* place : {"p 1 0 0", "p 1 1 0", "p 1 1 1", "p 0.5 0.5 0.5", "p 0 0 0", "p 1 0.3 0.2"}) {
    ASSERT_FALSE(ApplyLine(scene, "add b world" + cube + place));
    EXPECT_EQ(HullDistance(*scene.Find("a"), *scene.Find("b")), 0) << place;
    EXPECT_TRUE(HullsTouch(*scene.Find("a"), *scene.Find("b"))) << place;
    scene.Remove(*scene.Find("b"));
  }
  ASSERT_FALSE(ApplyLine(scene, "add b world" + cube + "p 1.001 0 0"));
  EXPECT_NEAR(HullDistance(*scene.Find("a"), *scene.Find("b")), 0.001, 1e-12);
}

TEST(Geometry, PartsOfATransformGiveItBack) {
  for (unsigned seed = 1; seed <= 50; ++seed) {
    GeneratedScene generated(seed);
    Pose pose;
    pose.position = generated.Point(10);
    pose.rotation = generated.Point(3);
    pose.scale = {2, 0.5, 3};
    const Transform::Parts parts = Transform(pose).Decompose();
    EXPECT_NEAR(Distance(parts.position, pose.position), 0, 1e-12);
    EXPECT_NEAR(Distance(parts.scale, pose.scale), 0, 1e-9);
    double square = 0;
    for (const double part : parts.rotation) square += part * part;
    EXPECT_NEAR(square, 1, 1e-9);
  }
}

TEST(Geometry, PlainRandomGivesTheFirstNumbersOfTheCLibrary) {
  PlainRandom random;
  for (const double expected : {1804289383.0, 846930886.0, 1681692777.0, 1714636915.0}) {
    EXPECT_EQ(random.Next(), expected / 2147483647.0);
  }
}

TEST(Scene, ALineThatIsRefusedTellsWhereAndWhy) {
  Scene scene("S1");
  const auto refused = [&](std::string_view line) {
    const auto error = ApplyLine(scene, line);
    return error ? error->ToString() : std::string("accepted");
  };
  EXPECT_EQ(refused("add x nobody b 1"), "\"add x nobody b 1\", word 3: there is no node nobody: add it first");
  EXPECT_EQ(refused("add x world b"), "\"add x world b\", word 5: expected a radius: a number follows b");
  EXPECT_EQ(refused("delete world"),
            "\"delete world\", word 2: world cannot be deleted: delete the nodes in it, or type svs STATE.scene.clear");
  EXPECT_EQ(refused("hello"), "\"hello\": expected add, change, delete or tag as the first word");
  EXPECT_EQ(refused("add x world p 1 nan 1"),
            "\"add x world p 1 nan 1\", word 6: expected a number: three follow p, r and s");
  EXPECT_EQ(scene.size(), 1u);
}

TEST(Scene, GroupsDoNotNestWithoutEnd) {
  Scene scene("S1");
  std::string parent = "world";
  int depth = 0;
  for (; depth < 1000; ++depth) {
    const std::string id = "g" + std::to_string(depth);
    if (ApplyLine(scene, "add " + id + " " + parent)) break;
    parent = id;
  }
  EXPECT_EQ(depth, Node::kDeepest);
  EXPECT_FALSE(ApplyLine(scene, "delete g0"));
  EXPECT_EQ(scene.size(), 1u);
}

}  // namespace
}  // namespace soarbox::kernel::imagery
