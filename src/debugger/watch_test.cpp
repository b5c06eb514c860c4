// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/watch.h"

#include <gmock/gmock.h>

#include "debugger/mind_fixture.h"
#include "debugger/run_trace.h"

namespace soarbox::debugger {
namespace {

using ::testing::HasSubstr;
using Watches = MindFixture;

constexpr const char* kRules = R"(
sp {hero*elaborate (state <s> ^superstate nil ^io.input-link.self.health <h>) --> (<s> ^vigour <h> ^pet cat dog)}
sp {hero*propose*rest (state <s> ^superstate nil ^vigour <v>) --> (<s> ^operator <o> +) (<o> ^name rest)}
)";

TEST_F(Watches, FollowPathsFromTheTopStateFromIdentifiersAndFromRoles) {
  Start(kRules);
  Tick();
  const auto mind = Mind();
  EXPECT_EQ(LookAtWatch(*mind, "io.input-link.self.health").text, "100");
  EXPECT_EQ(LookAtWatch(*mind, "s1.vigour").text, "100");
  EXPECT_EQ(LookAtWatch(*mind, "<ts>.^vigour").text, "100");
  EXPECT_EQ(LookAtWatch(*mind, "<o>.name").text, "rest");
  EXPECT_EQ(LookAtWatch(*mind, "<ts>").text, "S1");
  EXPECT_THAT(LookAtWatch(*mind, "pet").text, ::testing::AnyOf("cat, dog", "dog, cat"));
  EXPECT_EQ(LookAtWatch(*mind, "no.such.thing").text, "") << "what is not there may come yet";
  EXPECT_FALSE(LookAtWatch(*mind, "no.such.thing").is_error);
}

TEST_F(Watches, PrintWhatCommandsPrintAndCarryNoneOut) {
  Start(kRules);
  Tick();
  const auto mind = Mind();
  EXPECT_THAT(LookAtWatch(*mind, "print s1").text, HasSubstr("^vigour 100"));
  EXPECT_THAT(LookAtWatch(*mind, "print s1 -d 4").text, HasSubstr("^health 100"));
  EXPECT_THAT(LookAtWatch(*mind, "p hero*elaborate").text, HasSubstr("sp {hero*elaborate"));
  EXPECT_THAT(LookAtWatch(*mind, "preferences").text, HasSubstr("rest"));
  EXPECT_THAT(LookAtWatch(*mind, "stack").text, HasSubstr("S1"));
  EXPECT_FALSE(LookAtWatch(*mind, "matches hero*elaborate").is_error);
}

TEST_F(Watches, SayWhatTheyMayBe) {
  Start(kRules);
  Tick();
  const auto mind = Mind();
  EXPECT_THAT(LookAtWatch(*mind, "print hero*elaborat").text, HasSubstr("did you mean hero*elaborate?"));
  EXPECT_TRUE(LookAtWatch(*mind, "matches nothing").is_error);
  EXPECT_THAT(WatchFault("excise hero*elaborate"), HasSubstr("cannot be watched"));
  EXPECT_THAT(WatchFault("print"), HasSubstr("needs"));
  EXPECT_NE(WatchFault("  "), "");
  EXPECT_EQ(WatchFault("io.input-link"), "");
}

TEST(TraceFilter, AsksForLinesAboutARuleAnOperatorOrAnAttributeWhateverElseIsShown) {
  const auto line = [](TraceKind kind, const char* text) {
    TraceLine made;
    made.kind = kind;
    made.agent = "hero";
    made.text = text;
    return made;
  };
  const TraceLine fired = line(TraceKind::kRule, "fired hero*walk"), chose = line(TraceKind::kDecision, "O: O3 (walk)"),
                  element = line(TraceKind::kElement, "+ 12: S1 ^color red"),
                  percept = line(TraceKind::kPercept, "self.color blue");
  TraceFilter filter;
  filter.most = TraceKind::kDecision;
  filter.text = "rule:walk";
  EXPECT_TRUE(filter.Lets(fired));
  EXPECT_FALSE(filter.Lets(chose));
  filter.text = "op:walk";
  EXPECT_FALSE(filter.Lets(fired));
  EXPECT_TRUE(filter.Lets(chose));
  filter.text = "^color";
  EXPECT_TRUE(filter.Lets(element));
  EXPECT_TRUE(filter.Lets(percept));
  EXPECT_FALSE(filter.Lets(fired));
  filter.text = "rule:walk ^color";
  EXPECT_TRUE(filter.Lets(fired) && filter.Lets(element)) << "of several one must hold";
  filter.text = "^color red";
  EXPECT_TRUE(filter.Lets(element));
  EXPECT_FALSE(filter.Lets(percept)) << "other words must stand there as well";
  filter.text = "walk";
  EXPECT_FALSE(filter.Lets(fired)) << "rules are not shown";
  EXPECT_TRUE(filter.Lets(chose));
}

}  // namespace
}  // namespace soarbox::debugger
