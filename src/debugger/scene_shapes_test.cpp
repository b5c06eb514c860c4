// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/scene_shapes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "debugger/fields.h"

namespace soarbox::debugger {
namespace {

using testing::ElementsAre;
using testing::Field;

/// Output of `svs facts`.
constexpr std::string_view kFacts = R"(version 7
S1 node "world" {"parent":"","shape":"group","at":[0,0,0],"turn":[0,0,0,1],"scale":[1,1,1],"tags":{}}
S1 node "wall" {"parent":"world","shape":"hull","at":[10,0,0],"turn":[0,0,0,1],"scale":[2,1,1],"points":[0,0,0,1,0,0,0,1,0,1,1,0,0,0,1,1,0,1,0,1,1,1,1,1],"tags":{"solid":"yes","visible":"no"}}
S1 node "cat" {"parent":"world","shape":"ball","at":[1,2,3],"turn":[0,0,0,1],"scale":[1,1,1],"radius":0.5,"tags":{"solid":"yes","visible":"yes"}}
S1 node "lair" {"parent":"world","shape":"hull","at":[4,0,0],"turn":[0,0.7071067811865476,0,0.7071067811865476],"scale":[1,1,1],"points":[0,0,1,0,0,3],"tags":{}}
S1 extract "X7" {"command":"extract","rule":"ask","filter":"distance","status":"success","count":1,"values":[{"record":"R5","value":"1.4","from":[{"name":"a","value":"cat","filter":"node"}],"nodes":["cat","wall"],"lines":[1,2,3,10,2,3,0]}]}
S3 node "world" {"parent":"","shape":"group","at":[0,0,0],"turn":[0,0,0,1],"scale":[1,1,1],"tags":{}}
S3 node "lair" {"parent":"world","shape":"hull","at":[4,0,0],"turn":[0,0,0,1],"scale":[1,1,1],"points":[0,0,0],"tags":{}}
S3 node "copy" {"parent":"world","shape":"hull","at":[5,0,0],"turn":[0,0,0,1],"scale":[1,1,1],"points":[0,0,0],"tags":{}}
)";

TEST(SceneShapes, OfWhatWasMadeUpNameTheFirstStateThatHasIt) {
  const std::vector<SceneShape> shapes = ShapesOf(ReadImagery(kFacts), {});
  EXPECT_THAT(shapes, ElementsAre(Field(&SceneShape::name, "lair"), Field(&SceneShape::name, "copy")));
  EXPECT_EQ(shapes[0].state, "S1");
  EXPECT_EQ(shapes[1].state, "S3");
  // A rotation by 90 degrees about y moves z to x.
  ASSERT_EQ(shapes[0].points.size(), 2u);
  EXPECT_EQ(shapes[0].edges.size(), 1u);
  EXPECT_NEAR(std::max(shapes[0].points[0][0], shapes[0].points[1][0]), 7, 1e-5);
  // A point is a cross.
  EXPECT_EQ(shapes[1].edges.size(), 3u);
}

TEST(SceneShapes, OfAStateAreAllThatItHasWithWhatTheyAreToTheAgent) {
  const std::vector<SceneShape> shapes = ShapesOf(ReadImagery(kFacts), "S1");
  ASSERT_EQ(shapes.size(), 3u);
  const auto named = [&](const char* name) { return *std::ranges::find(shapes, name, &SceneShape::name); };
  EXPECT_EQ(named("wall").kind, SceneShape::Kind::kRemembered);
  EXPECT_EQ(named("wall").edges.size(), 12u);
  double most = 0;
  for (const ScenePoint& point : named("wall").points) most = std::max(most, point[0]);
  EXPECT_NEAR(most, 12, 1e-5) << "its scale counts";
  EXPECT_EQ(named("cat").kind, SceneShape::Kind::kSensed);
  EXPECT_TRUE(named("cat").faces.empty());
  EXPECT_TRUE(ShapesOf(ReadImagery(kFacts), "S99").empty());
}

TEST(SceneShapes, AnAnswerHasItsValueAndLines) {
  const ImageryView view = ReadImagery(kFacts);
  const AnswerLines answer = LinesOf(view, "R5");
  EXPECT_EQ(answer.text, "1.4");
  ASSERT_EQ(answer.lines.size(), 1u);
  EXPECT_EQ(JsonOf(answer.lines[0]).dump(), R"({"from":[1.0,2.0,3.0],"to":[10.0,2.0,3.0],"is_crossed":false})");
  EXPECT_TRUE(LinesOf(view, "R6").lines.empty());
  EXPECT_TRUE(LinesOf(view, "").text.empty());
}

TEST(SceneShapes, AsJsonAreFlatLists) {
  const Json json = JsonOf(ShapesOf(ReadImagery(kFacts), {})[1]);
  EXPECT_EQ(json["kind"], "made-up");
  EXPECT_EQ(json["points"].size(), 18u);
  EXPECT_EQ(json["edges"].size(), 6u);
}

}  // namespace
}  // namespace soarbox::debugger
