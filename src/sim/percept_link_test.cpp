// SPDX-License-Identifier: BSD-2-Clause
#include "sim/percept_link.h"

#include <gtest/gtest.h>
#ifndef _WIN32
#include <pthread.h>
#endif

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "sim/client_input.h"
#include "sim/graph_mirror.h"
#include "sim/input_mirror.h"
#include "sml_Client.h"
#include "vocabulary/vocabulary_percepts.h"

namespace soarbox::sim {
namespace {

enum class Way { kShortest, kClientApi };

/// An agent with three mirrors, which share its input link. One rule tests some percepts.
struct Mind {
  Mind(sml::Kernel& kernel, const char* name, Way way)
      : agent(*kernel.CreateAgent(name)),
        own_link(way == Way::kShortest ? new PerceptLink(agent) : new PerceptLink(OpenClientInput(agent))) {
    agent.ExecuteCommandLine(
        "sp {near (state <s> ^io.input-link.agent <a>) (<a> ^range < 3 ^name <n>) --> (<s> ^near <n>)}");
  }
  /// Everything in working memory with its identifiers and time tags.
  std::string Memory() { return agent.ExecuteCommandLine("print --depth 9 --internal --tree s1"); }

  sml::Agent& agent;
  std::unique_ptr<PerceptLink> own_link;
  PerceptLink& link = *own_link;
  InputMirror first{link}, second{link};
  GraphMirror graph{link};
};

int CountOf(const std::string& text, const std::string& part) {
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++count;
  return count;
}

/// Calls a function in a thread with a stack of 512 KiB, where threads have a size of stack.
template <typename Function>
void OnASmallStack(Function function) {
#ifdef _WIN32
  function();
#else
  pthread_attr_t small;
  ASSERT_EQ(pthread_attr_init(&small), 0);
  ASSERT_EQ(pthread_attr_setstacksize(&small, std::size_t{512} << 10), 0);
  const auto call = [](void* what) -> void* {
    (*static_cast<Function*>(what))();
    return nullptr;
  };
  pthread_t thread;
  ASSERT_EQ(pthread_create(&thread, &small, call, &function), 0);
  ASSERT_EQ(pthread_join(thread, nullptr), 0);
  pthread_attr_destroy(&small);
#endif
}

class PerceptLinkTest : public testing::Test {
 protected:
  ~PerceptLinkTest() override { kernel_->Shutdown(); }

  /// Updates both minds with equal percepts and compares their working memories.
  template <typename Tell>
  void ShowBoth(InputMirror Mind::*mirror, Tell tell) {
    for (Mind* mind : {&direct_, &client_}) {
      (mind->*mirror).Show(tell);
      mind->agent.RunSelf(1);
    }
    Compare();
  }
  void Compare() { ASSERT_EQ(direct_.Memory(), client_.Memory()); }

  std::unique_ptr<sml::Kernel> kernel_{sml::Kernel::CreateKernelInCurrentThread(true, sml::Kernel::kSuppressListener)};
  Mind direct_{*kernel_, "direct", Way::kShortest};
  Mind client_{*kernel_, "client", Way::kClientApi};
};

void TellAgent(InputMirror& mirror, std::uint32_t key, std::string_view name, double range_m) {
  mirror.Open(vocabulary::RowOf("agent"), key);
  mirror.Word(vocabulary::RowOf("agent.name"), name);
  mirror.Number(vocabulary::RowOf("agent.range"), range_m);
  mirror.Number(vocabulary::RowOf("agent.bearing"), range_m * 7);
  mirror.Open(vocabulary::RowOf("agent.position"));
  mirror.Number(vocabulary::RowOf("agent.position.x"), range_m);
  mirror.Close();
  mirror.Other("colour of a text that is long", std::string("a value that is longer than a slot") + char('a' + key));
  mirror.Close();
}

TEST_F(PerceptLinkTest, OnlyTheClientApiHasAnotherCopyOfTheInput) {
  ShowBoth(&Mind::first, [](InputMirror& mirror) { TellAgent(mirror, 1, "red", 2); });
  EXPECT_EQ(direct_.agent.GetInputLink()->GetNumberChildren(), 0);
  EXPECT_EQ(client_.agent.GetInputLink()->GetNumberChildren(), 1);
  EXPECT_NE(direct_.Memory().find("^near red"), std::string::npos);
}

TEST_F(PerceptLinkTest, BothWaysHaveTheSameElementsIdentifiersAndTimeTags) {
  std::mt19937 random(7);
  std::vector<std::uint32_t> keys;
  for (int step = 0; step < 200; ++step) {
    // Agents come and go at any place, so the order of the slots differs from the order of addition.
    if (keys.size() < 8 && random() % 2 == 0) {
      keys.insert(keys.begin() + static_cast<std::ptrdiff_t>(random() % (keys.size() + 1)),
                  static_cast<std::uint32_t>(random() % 20 + 1));
      std::vector<std::uint32_t> once;
      for (const std::uint32_t key : keys)
        if (std::ranges::find(once, key) == once.end()) once.push_back(key);
      keys = once;
    } else if (!keys.empty() && random() % 3 == 0) {
      keys.erase(keys.begin() + static_cast<std::ptrdiff_t>(random() % keys.size()));
    }
    const double range_m = static_cast<double>(random() % 60) / 10;
    ShowBoth(random() % 3 == 0 ? &Mind::second : &Mind::first, [&](InputMirror& mirror) {
      mirror.Number(vocabulary::RowOf("time"), range_m);
      for (const std::uint32_t key : keys) TellAgent(mirror, key, key % 2 == 0 ? "blue" : "red", range_m + key);
    });
    if (HasFatalFailure()) FAIL() << "in step " << step;
    if (step % 23 != 22) continue;
    for (Mind* mind : {&direct_, &client_}) mind->agent.InitSoar();
    for (Mind* mind : {&direct_, &client_}) mind->agent.RunSelf(1);
    Compare();
    if (HasFatalFailure()) FAIL() << "after init-soar in step " << step;
  }
}

/// A graph of cells in a row, with links in both directions, to further cells, and to the input link. Some links are
/// there twice.
script::PerceptGraph RandomGraph(std::mt19937& random) {
  script::PerceptGraph graph;
  graph.nodes.resize(random() % 6 + 1);
  for (std::size_t n = 0; n < graph.nodes.size(); ++n) {
    script::PerceptGraph::Node& node = graph.nodes[n];
    if (n % 3 == 2) node.key = std::to_string(random() % 3);
    if (n + 1 < graph.nodes.size()) node.links.push_back({"next", n + 1});
    if (n > 0) node.links.push_back({"back", n - 1});
    if (random() % 2 == 0) node.links.push_back({"far", random() % graph.nodes.size()});
    if (!node.links.empty() && random() % 3 == 0) {
      const script::PerceptGraph::Link again = node.links[random() % node.links.size()];
      node.links.push_back(again);
    }
    node.constants.push_back({"content", static_cast<std::int64_t>(random() % 3), random() % 4 == 0});
    node.constants.push_back({"content", 1.5, false});
    if (random() % 2 == 0)
      node.constants.push_back({"name", std::string("cell") + static_cast<char>('a' + random() % 3), false});
  }
  return graph;
}

TEST_F(PerceptLinkTest, BothWaysHaveTheSameGraphsOfObjects) {
  std::mt19937 random(11);
  for (int step = 0; step < 300; ++step) {
    const script::PerceptGraph graph = RandomGraph(random);
    const double range_m = static_cast<double>(random() % 5);
    for (Mind* mind : {&direct_, &client_}) {
      mind->first.Show([&](InputMirror& mirror) {
        for (std::uint32_t key = 1; key < range_m; ++key) TellAgent(mirror, key, "red", range_m);
      });
      mind->graph.Show(graph);
      if (step % 17 == 16) mind->agent.InitSoar();
      mind->agent.RunSelf(1);
    }
    Compare();
    if (HasFatalFailure()) FAIL() << "in step " << step;
  }
  EXPECT_NE(direct_.Memory().find("^far"), std::string::npos);
  EXPECT_EQ(direct_.agent.GetInputLink()->GetNumberChildren(), 0);
}

TEST_F(PerceptLinkTest, TwoLinksToOneObjectWithTheSameAttributeAreOneElement) {
  script::PerceptGraph graph;
  graph.nodes.resize(3);
  graph.nodes[0].links = {{"cell", 1}, {"cell", 1}, {"cell", 2}, {"other", 1}};
  graph.nodes[1].links = {{"back", 0}, {"back", 0}};
  graph.nodes[1].constants.push_back({"v", std::int64_t{1}, false});
  for (int round = 0; round < 3; ++round) {
    for (Mind* mind : {&direct_, &client_}) {
      mind->graph.Show(graph);
      if (round == 2) mind->agent.InitSoar();
      mind->agent.RunSelf(1);
      EXPECT_EQ(CountOf(mind->agent.ExecuteCommandLine("print --exact --internal (* ^cell *)"), "^cell"), 2);
      EXPECT_EQ(CountOf(mind->agent.ExecuteCommandLine("print --exact --internal (* ^back *)"), "^back"), 1);
    }
    Compare();
  }
}

/// init-soar must not need more stack for more objects: a secondary thread of some systems has only 512 KiB.
TEST_F(PerceptLinkTest, ALongChainOfObjectsIsWrittenAgainOnASmallStack) {
  script::PerceptGraph graph;
  graph.nodes.resize(1900);
  for (std::size_t n = 1; n < graph.nodes.size(); ++n) {
    graph.nodes[n - 1].links.push_back({"next", n});
    graph.nodes[n].links.push_back({"back", n - 1});
    graph.nodes[n].constants.push_back({"at", static_cast<std::int64_t>(n), false});
  }
  for (Mind* mind : {&direct_, &client_}) {
    mind->graph.Show(graph);
    mind->agent.RunSelf(1);
  }
  OnASmallStack([this] {
    for (Mind* mind : {&direct_, &client_}) {
      mind->agent.InitSoar();
      mind->agent.RunSelf(1);
    }
  });
  Compare();
  const auto memory = [](const Mind& mind) {
    // The text of a command is valid until the next command.
    std::string text = mind.agent.ExecuteCommandLine("print --exact --internal (* ^next *)");
    text += mind.agent.ExecuteCommandLine("print --exact --internal (* ^at *)");
    return text;
  };
  EXPECT_EQ(memory(direct_), memory(client_));
  EXPECT_EQ(CountOf(memory(direct_), "^next"), 1899);
}

TEST_F(PerceptLinkTest, BothWaysTreatZeroBytesAndMissingAttributesAlike) {
  using namespace std::string_literals;
  const auto show = [&](const vocabulary::PerceptList& list) {
    for (Mind* mind : {&direct_, &client_}) {
      mind->first.Show(list);
      mind->agent.RunSelf(1);
    }
    Compare();
  };
  show({{"heat\0x"s, 1, "mu\0ch"s}, {"", 2, std::int64_t{1}}, {"", 3, vocabulary::PerceptList{{"of", 0, "oven"s}}}});
  show({{"heat\0x"s, 1, "more than sixteen letters and a \0zero"s}, {"a", 2, 2.5}});
  show({{"heat\0x"s, 1, "\0"s}, {"a", 2, 3.5}, {"b", 0, vocabulary::PerceptList{{"of", 0, "oven"s}}}});
}

TEST_F(PerceptLinkTest, APerceptOfADestroyedAgentHasNoEffect) {
  kernel_->DestroyAgent(&direct_.agent);
  direct_.first.Show([](InputMirror& mirror) { TellAgent(mirror, 1, "red", 2); });
  EXPECT_EQ(direct_.first.changes(), 1u);  // The object that could not be created.
}

TEST_F(PerceptLinkTest, AfterItIsClosedNothingIsAddedOrChanged) {
  ShowBoth(&Mind::first, [](InputMirror& mirror) { TellAgent(mirror, 1, "red", 2); });
  for (Mind* mind : {&direct_, &client_}) {
    const std::string before = mind->Memory();
    mind->link.Close();
    mind->first.Show([](InputMirror& mirror) {
      TellAgent(mirror, 1, "blue", 3);
      TellAgent(mirror, 2, "blue", 3);
    });
    mind->first.Show([](InputMirror&) {});
    mind->agent.RunSelf(1);
    EXPECT_EQ(mind->Memory(), before);
  }
  // Also if the kernel is gone, as for the mind of an agent that was removed.
  kernel_->DestroyAgent(&direct_.agent);
  direct_.first.Show([](InputMirror& mirror) { TellAgent(mirror, 3, "red", 2); });
}

TEST_F(PerceptLinkTest, ASecondLinkToAnAgentUsesTheClientApi) {
  PerceptLink link(direct_.agent);
  {
    InputMirror mirror(link);
    mirror.Show([](InputMirror& told) { TellAgent(told, 9, "late", 9); });
    EXPECT_EQ(direct_.agent.GetInputLink()->GetNumberChildren(), 1);
  }
  direct_.first.Show([](InputMirror& mirror) { TellAgent(mirror, 1, "red", 2); });
  direct_.agent.InitSoar();
  direct_.agent.RunSelf(1);
  EXPECT_NE(direct_.Memory().find("^near red"), std::string::npos) << "the first link writes again";
}

TEST(PerceptLink, TheInputGoesThroughTheClientApiIfOtherClientsCanSeeIt) {
  std::unique_ptr<sml::Kernel> kernel(sml::Kernel::CreateKernelInCurrentThread(true, sml::Kernel::kUseAnyPort));
  if (kernel->GetListenerPort() > 0) {
    Mind mind(*kernel, "seen", Way::kShortest);
    mind.first.Show([](InputMirror& mirror) { TellAgent(mirror, 1, "red", 2); });
    EXPECT_EQ(mind.agent.GetInputLink()->GetNumberChildren(), 1);
  }
  kernel->Shutdown();
}

}  // namespace
}  // namespace soarbox::sim
