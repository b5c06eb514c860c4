// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/imagery/imagery.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/agent.h"
#include "kernel/decide/goal_stack.h"
#include "kernel/learn/learn_settings.h"

namespace soarbox::kernel {
namespace {

class ImageryTest : public testing::Test {
 protected:
  ImageryTest() {
    agent_.mutable_settings().wait_snc = true;
    agent_.imagery().Enable();
  }

  void Load(std::string_view rule) { ASSERT_TRUE(agent_.LoadProduction(rule).loaded) << rule; }
  void Ask(const std::string& filter) {
    Load("ask (state <s> ^superstate nil ^svs.command <c>) --> (<c> ^extract <x>) " + filter);
  }
  void Cycle(int count = 1) {
    for (int n = 0; n < count; ++n) agent_.Step(RunUnit::kDecision);
    EXPECT_EQ(agent_.CheckInvariants(), "");
  }
  void Send(std::string_view lines) { EXPECT_TRUE(agent_.imagery().Send(lines)); }

  Symbol At(Symbol id, std::string_view path) {
    while (!path.empty() && id.IsIdentifier()) {
      const std::size_t dot = std::min(path.find('.'), path.size());
      id = agent_.memory().ValueOf(id, agent_.mutable_symbols().String(path.substr(0, dot)));
      path.remove_prefix(std::min(dot + 1, path.size()));
    }
    return id;
  }
  std::string Text(Symbol symbol) { return symbol ? ToString(agent_.symbols(), symbol, false) : "nothing"; }
  /// The value at a path below the top state.
  std::string Top(std::string_view path) { return Text(At(agent_.goals().top().id, path)); }
  std::string Extract(std::string_view path) { return Top("svs.command.extract." + std::string(path)); }
  std::size_t Records() {
    const Symbol result = At(agent_.goals().top().id, "svs.command.extract.result");
    return result.IsIdentifier() ? agent_.memory().WmesOf(result).size() : 0;
  }

  Agent agent_{"dreamer"};
};

TEST_F(ImageryTest, AnswersFollowTheScene) {
  Ask("(<x> ^type distance ^a <a> ^b <b> ^distance_type hull) (<a> ^type node ^id a) (<b> ^type node ^id b)");
  Send("add a world b 1\nadd b world b 1 p 5 0 0");
  Cycle(2);
  EXPECT_EQ(Extract("result.record.value"), "3.000000");
  Send("change b p 3 0 0");
  Cycle();
  EXPECT_EQ(Extract("result.record.value"), "1.000000");
  Send("delete b");
  Cycle();
  EXPECT_EQ(Extract("status"), "success");
  EXPECT_EQ(Records(), 0u);
}

TEST_F(ImageryTest, NodesThatComeMeetAllOthers) {
  Ask("(<x> ^type distance ^a <a> ^b <b>) (<a> ^type all_nodes) (<b> ^type all_nodes)");
  Send("add a world b 1\nadd b world b 1 p 5 0 0");
  Cycle(2);
  EXPECT_EQ(Records(), 4u);
  Send("add c world b 1 p 9 0 0");
  Cycle();
  EXPECT_EQ(Records(), 9u);
}

TEST_F(ImageryTest, FiltersThatAreAlikeAreOne) {
  const auto room = [&] { return agent_.imagery().MemoryBytes(); };
  const std::string filter =
      "(<x> ^type distance ^a <a> ^b <b>) (<a> ^type node ^id node-1) (<b> ^type tag_select ^a <all> ^tag_name t "
      "^tag_value yes) (<all> ^type all_nodes)";
  std::string lines;
  for (int n = 0; n < 300; ++n) {
    const std::string name = "node-" + std::to_string(n);
    lines += "add " + name + " world b 1 p " + std::to_string(n) + " 0 0\ntag add " + name + " t yes\n";
  }
  Send(lines);
  Cycle();
  const std::size_t scene = room();
  const auto ask = [&](const std::string& name) {
    Load(name + " (state <s> ^superstate nil ^svs.command <c>) --> (<c> ^extract <x>) (<x> ^about " + name + ") " +
         filter);
  };
  ask("first");
  Cycle(2);
  const std::size_t first = room();
  EXPECT_GT(first, scene);
  // A later extract shares only the list of nodes, because the first one may have started with nodes that no longer
  // exist.
  ask("second");
  Cycle(2);
  const std::size_t alone = room() - first;
  ask("third");
  ask("fourth");
  ask("fifth");
  Cycle(2);
  EXPECT_LT(room() - first - alone, 2 * alone);
  // Each extract has its own records and statuses, which follow the scene.
  Send("change node-7 p 8 0 0\ntag delete node-8 t\ndelete node-9");
  Cycle();
  std::size_t extracts = 0;
  for (const WmeId element : agent_.memory().WmesOf(At(agent_.goals().top().id, "svs.command"))) {
    const Symbol extract = agent_.memory().wme(element).value;
    if (!extract.IsIdentifier()) continue;
    ++extracts;
    EXPECT_EQ(Text(At(extract, "status")), "success");
    EXPECT_EQ(Text(At(extract, "b.a.status")), "success");
    std::size_t records = 0;
    for (const WmeId record : agent_.memory().WmesOf(At(extract, "result"))) {
      ++records;
      const Symbol id = agent_.memory().wme(record).value;
      if (Text(At(id, "params.b")) == "node-7") {
        EXPECT_EQ(Text(At(id, "value")), "7.000000");
      }
    }
    EXPECT_EQ(records, 298u);
  }
  EXPECT_EQ(extracts, 5u);
}

TEST_F(ImageryTest, OneNodeListForTwoParametersKeepsItsPairs) {
  // Both parameters are the same computation: a removed value must be removed from every pair once.
  Ask("(<x> ^type distance ^a <all> ^b <all>) (<all> ^type all_nodes)");
  Send("add a world b 1\nadd b world b 1 p 5 0 0\nadd c world b 1 p 9 0 0");
  Cycle(2);
  EXPECT_EQ(Records(), 9u);
  Send("delete b\nadd d world b 1 p 1 1 1\nchange a p 1 0 0");
  Cycle();
  EXPECT_EQ(Records(), 9u);
  Send("delete a\ndelete c\ndelete d");
  Cycle();
  EXPECT_EQ(Records(), 0u);
}

TEST_F(ImageryTest, WhatCannotBeComputedIsComputedAgainWhenItCan) {
  Ask("(<x> ^type distance ^a <a> ^b <b>) (<a> ^type node ^id a) (<b> ^type remove_node ^id b ^a <all>) "
      "(<all> ^type all_nodes)");
  Send("add a world b 1\nadd c world b 1 p 2 0 0");
  Cycle(2);
  EXPECT_EQ(Extract("status"), "Errors in input");
  EXPECT_EQ(Extract("b.status"), "The given node doesn't exist");
  EXPECT_EQ(Records(), 0u);
  Send("add b world b 1 p 3 0 0");
  Cycle();
  EXPECT_EQ(Extract("status"), "success");
  EXPECT_EQ(Records(), 2u);
  Send("delete b\nchange c p 4 0 0");
  Cycle();
  EXPECT_EQ(Extract("b.status"), "The given node doesn't exist");
  EXPECT_EQ(Records(), 0u);
}

TEST_F(ImageryTest, OcclusionFollowsTheEyeAndTheTarget) {
  Ask("(<x> ^type occlusion ^a <a> ^b <b> ^eye <e>) (<a> ^type node ^id spot) (<b> ^type node ^id wall)"
      " (<e> ^type node ^id eye)");
  Send("add eye world v 0 0 0\nadd spot world v 0 0 0 p 10 0 0");
  Send("add wall world v -0.1 -1 -1 0.1 -1 -1 -0.1 1 -1 0.1 1 -1 -0.1 -1 1 0.1 -1 1 -0.1 1 1 0.1 1 1 p 5 0 0");
  Cycle(2);
  EXPECT_EQ(Extract("result.record.value"), "1.000000");
  Send("change eye p 0 8 0");
  Cycle();
  EXPECT_EQ(Extract("result.record.value"), "0.000000");
  Send("change spot p 10 -8 0");
  Cycle();
  EXPECT_EQ(Extract("result.record.value"), "1.000000");
}

TEST_F(ImageryTest, TagsOfSingleNodesAreHeardOf) {
  Ask("(<x> ^type tag_select ^a <a> ^tag_name colour ^tag_value red) (<a> ^type node ^id a)");
  Send("add a world b 1");
  Cycle(2);
  EXPECT_EQ(Records(), 0u);
  Send("tag add a colour red");
  Cycle();
  EXPECT_EQ(Extract("result.record.value"), "a");
}

TEST_F(ImageryTest, ChangesAtOnceMakeExtractsLookAgain) {
  Ask("(<x> ^type node_position ^a <a>) (<a> ^type node ^id a)");
  Send("add a world b 1");
  Cycle(2);
  imagery::StateScene* const state = agent_.imagery().FindState("S1");
  ASSERT_NE(state, nullptr);
  EXPECT_FALSE(agent_.imagery().Apply(*state, "change a p 4 0 0"));
  Cycle();
  EXPECT_EQ(Extract("result.record.value.x"), "4.000000");
  agent_.imagery().Clear(*state);
  Cycle();
  EXPECT_EQ(Records(), 0u);
}

TEST_F(ImageryTest, WhatCannotBeDoneIsToldAndNothingElseHappens) {
  Send("delete world\nadd a\nhello\nadd a world b nan\nadd b world b 1");
  Cycle();
  EXPECT_EQ(agent_.imagery().TakeRefused(),
            "\"delete world\", word 2: world cannot be deleted: delete the nodes in it, or type svs STATE.scene.clear\n"
            "\"add a\", word 3: expected the id of the parent: world, or another group\n"
            "\"hello\": expected add, change, delete or tag as the first word\n"
            "\"add a world b nan\", word 5: expected a radius: a number follows b\n");
  EXPECT_EQ(agent_.imagery().TakeRefused(), "");
  EXPECT_EQ(agent_.imagery().Query("list-all-objs"), "objs 2 world b\n");
  Load("burn (state <s> ^superstate nil ^svs.command <c>) --> (<c> ^delete_node.id world)");
  Cycle(2);
  EXPECT_EQ(Top("svs.command.delete_node.status"), "the world cannot be deleted");
}

class Problems : public Observer {
 public:
  void OnSceneProblem(const Agent& agent, WmeId command, std::string_view problem, std::string_view hint) override {
    const Symbol attribute = agent.memory().wme(command).attribute;
    told.push_back(ToString(agent.symbols(), attribute, false) + ": " + std::string(problem) + "; " +
                   std::string(hint));
  }
  std::vector<std::string> told;
};

TEST_F(ImageryTest, WhatRulesAskInVainIsReportedOnce) {
  Problems problems;
  agent_.AddObserver(problems, Mask(Event::kPrint));
  Ask("(<x> ^type closest ^a <a> ^b <b>) (<a> ^type node ^id bal) (<b> ^type all_nodes)");
  Load(
      "move (state <s> ^superstate nil ^svs.command <c>) --> (<c> ^set_transform <x> ^extract_once <y>) "
      "(<x> ^id boll) (<y> ^type closets)");
  Send("add ball world b 1");
  Cycle(3);
  Send("change ball p 1 0 0");
  Cycle(3);
  std::sort(problems.told.begin(), problems.told.end());
  const std::vector<std::string> expected = {
      "extract: filter node can never find anything: there is no node bal: did you mean ball?; to find a "
      "node that appears later, use tag_select over all_nodes, or give the command once the node exists",
      "extract_once: incorrect filter syntax: there is no filter closets; did you mean closest?",
      "set_transform: Couldn't find node boll; there is no node boll: did you mean ball?"};
  EXPECT_EQ(problems.told, expected);
  agent_.RemoveObserver(problems);
}

TEST_F(ImageryTest, TheVersionGrowsWithWhatIsImaginedAndOnlyThen) {
  Ask("(<x> ^type distance ^a <a> ^b <b>) (<a> ^type node ^id a) (<b> ^type node ^id b)");
  Send("add a world b 1\nadd b world b 1 p 5 0 0");
  Cycle(3);
  const std::uint64_t before = agent_.imagery().version();
  Cycle(3);
  EXPECT_EQ(agent_.imagery().version(), before);
  Send("change b p 3 0 0");
  Cycle();
  EXPECT_GT(agent_.imagery().version(), before);
}

TEST_F(ImageryTest, FiltersThatContainThemselvesAreNone) {
  Ask("(<x> ^type distance ^a <a> ^b <x>) (<a> ^type node ^id a)");
  Cycle(2);
  EXPECT_EQ(Extract("status"), "incorrect filter syntax");
}

TEST_F(ImageryTest, TooManyCombinationsAreRefused) {
  std::string lines;
  for (int n = 0; n < 200; ++n) lines += "add n" + std::to_string(n) + " world b 1\n";
  Send(lines);
  Ask("(<x> ^type distance ^a <a> ^b <a> ^c <a>) (<a> ^type all_nodes)");
  Cycle(2);
  EXPECT_EQ(Extract("status"), "too many combinations of values (2000000 at most)");
}

TEST_F(ImageryTest, HullsWithoutPointsHarmNothing) {
  Ask("(<x> ^type intersect ^a <a> ^b <b> ^intersect_type hull) (<a> ^type all_nodes) (<b> ^type all_nodes)");
  Send("add none world v\nadd other world v p 1 1 1\nadd ball world b 1");
  Cycle(2);
  EXPECT_EQ(Records(), 9u);
}

TEST_F(ImageryTest, SubstatesImagineForThemselves) {
  Send("add ball world b 1 p 5 0 0");
  Cycle();
  Load("propose (state <s> ^superstate nil) --> (<s> ^operator.name think)");
  Load(
      "imagine (state <s> ^superstate <t> ^svs.command <c>) (<t> ^superstate nil) --> "
      "(<c> ^set_transform <m> ^extract <x>) (<m> ^id ball ^position <p>) (<p> ^x 1 ^y 2 ^z 3) "
      "(<x> ^type node_position ^a <a>) (<a> ^type node ^id ball)");
  Cycle(5);
  ASSERT_EQ(agent_.goals().depth(), 2u);
  const Symbol below = agent_.goals().at(2).id;
  EXPECT_EQ(Text(At(below, "svs.command.extract.result.record.value.x")), "1.000000");
  EXPECT_EQ(agent_.imagery().Query("obj-info ball"), "o ball p 5 0 0 r 0 0 0 s 1 1 1 t 0\n");
  EXPECT_EQ(agent_.imagery().states().size(), 2u);
  EXPECT_FALSE(agent_.imagery().Disable());
  EXPECT_FALSE(agent_.imagery().DisableInSubstates());
}

TEST_F(ImageryTest, AStateGoesWithTheAnswerThatItRestsOn) {
  // An o-supported element of the substate depends on a result in the top state's scene.
  Ask("(<x> ^type intersect ^a <a> ^b <b> ^intersect_type hull) (<a> ^type node ^id a) (<b> ^type node ^id b)");
  Send("add a world b 1\nadd b world b 1 p 1 0 0");
  Load("propose (state <s> ^superstate nil ^svs.command.extract.result.record) --> (<s> ^operator.name think)");
  Load("below (state <s> ^superstate <t>) (<t> ^superstate nil ^operator.name think) --> (<s> ^operator.name note)");
  Load(
      "note (state <s> ^operator.name note ^superstate <t>) (<t> ^svs.command.extract.result.record.value true) --> "
      "(<s> ^touching yes)");
  Cycle(6);
  ASSERT_GE(agent_.goals().depth(), 2u);
  const std::string first = Text(agent_.goals().at(2).id);
  Send("change b p 9 0 0");
  Cycle(4);
  ASSERT_GE(agent_.goals().depth(), 2u);
  EXPECT_NE(Text(agent_.goals().at(2).id), first);
}

TEST_F(ImageryTest, DisablingAfterARunLeavesEverythingAsItIs) {
  Send("add a world b 1");
  Cycle();
  EXPECT_TRUE(agent_.imagery().Disable());
  EXPECT_FALSE(agent_.imagery().Send("add b world b 1"));
  Cycle(2);
  EXPECT_EQ(Top("svs.spatial-scene.child.id"), "a");
  agent_.imagery().Enable();
  Send("add b world b 1");
  Cycle();
  EXPECT_EQ(agent_.imagery().Query("list-all-objs"), "objs 3 world a b\n");
  EXPECT_TRUE(agent_.imagery().Disable());
  agent_.InitSoar();
  Cycle(2);
  EXPECT_EQ(Top("svs"), "nothing");
  agent_.imagery().Enable();
  Cycle();
  EXPECT_EQ(Top("svs.spatial-scene.child.id"), "b");
}

TEST_F(ImageryTest, LongRunsLeaveNothingBehind) {
  Ask("(<x> ^type node_position ^a <a>) (<a> ^type all_nodes)");
  Send("add a world b 1");
  Cycle(20);
  const std::uint32_t before = agent_.memory().wme_count();
  for (int n = 0; n < 3000; ++n) {
    Send("change a p " + std::to_string(n) + " 0 0\nadd b world b 1\ntag add b t " + std::to_string(n) + "\ndelete b");
    agent_.Step(RunUnit::kDecision);
  }
  Cycle();
  EXPECT_EQ(agent_.memory().wme_count(), before);
  EXPECT_LT(agent_.memory().identifier_count(), 20000u);
}

TEST_F(ImageryTest, ViewersSeeWhatChanges) {
  std::string seen;
  agent_.imagery().SetViewer([&](std::string_view line) {
    seen += line;
    return true;
  });
  Send("add a world b 1 p 1 0 0");
  Cycle();
  EXPECT_EQ(seen, "-S1\n+S1 +a b 1 p 1 0 0 r 0 0 0 1 s 1 1 1\n");
  seen.clear();
  Send("change a p 2 0 0\ndelete a");
  Cycle();
  EXPECT_EQ(seen, "+S1 +a p 2 0 0 r 0 0 0 1 s 1 1 1\nS1 -a\n");
  seen.clear();
  agent_.imagery().SetViewer({});
  EXPECT_EQ(seen, "-S1\n");
}

TEST_F(ImageryTest, AgentsImagineApart) {
  Agent other("other");
  other.imagery().Enable();
  Send("add a world b 1");
  Cycle();
  other.Step(RunUnit::kDecision);
  EXPECT_EQ(other.imagery().Query("list-all-objs"), "objs 1 world\n");
}

}  // namespace
}  // namespace soarbox::kernel
