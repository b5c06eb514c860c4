// SPDX-License-Identifier: BSD-2-Clause
#include "sim/graph_mirror.h"

#include <gtest/gtest.h>

#include <memory>
#include <sstream>
#include <string>

#include "sml_Client.h"

namespace soarbox::sim {
namespace {

using script::PerceptGraph;

/// An agent whose input link is read as text.
class GraphMirrorTest : public testing::Test {
 protected:
  GraphMirrorTest()
      : kernel_(sml::Kernel::CreateKernelInCurrentThread(true, static_cast<int>(sml::Kernel::kSuppressListener))),
        agent_(kernel_->CreateAgent("eater")),
        link_(*agent_),
        mirror_(link_) {}

  /// The element with an attribute and a value, "(16: H1 ^content wall)"; empty if there is none.
  std::string Find(const std::string& attribute_and_value) {
    agent_->Commit();
    agent_->RunSelf(1);
    const std::string attribute = attribute_and_value.substr(0, attribute_and_value.find(' '));
    std::istringstream printed(
        agent_->ExecuteCommandLine(("print --internal (* " + attribute_and_value + ")").c_str()));
    std::string found;
    for (std::string line; std::getline(printed, line);)
      if (line.find(attribute + " ") != std::string::npos) found += line + "\n";
    return found;
  }

  PerceptGraph::Node Cell(const std::string& content, bool is_new = false) {
    return {"", {{"content", content, is_new}}, {}};
  }
  /// The input link with two cells that link to each other.
  PerceptGraph TwoCells(const std::string& first, const std::string& second, bool is_new = false) {
    PerceptGraph graph;
    graph.nodes = {{"", {}, {{"here", 1}}}, Cell(first, is_new), Cell(second, is_new)};
    graph.nodes[1].links = {{"east", 2}};
    graph.nodes[2].links = {{"west", 1}};
    return graph;
  }

  std::unique_ptr<sml::Kernel> kernel_;
  sml::Agent* agent_;
  PerceptLink link_;
  GraphMirror mirror_;
};

TEST_F(GraphMirrorTest, ObjectsMayLeadBackToEachOther) {
  mirror_.Show(TwoCells("eater", "wall"));
  EXPECT_NE(Find("^content eater").find("^content eater"), std::string::npos);
  EXPECT_NE(Find("^content wall").find("^content wall"), std::string::npos);
  EXPECT_NE(Find("^west *").find("^west"), std::string::npos);
}

TEST_F(GraphMirrorTest, WhatIsEqualStaysUnlessItIsNew) {
  mirror_.Show(TwoCells("eater", "wall"));
  const std::string before = Find("^content wall"), link = Find("^east *");
  mirror_.Show(TwoCells("eater", "wall"));
  EXPECT_EQ(Find("^content wall"), before);
  mirror_.Show(TwoCells("eater", "wall", true));
  EXPECT_NE(Find("^content wall"), before);
  EXPECT_NE(Find("^content wall"), "");
  EXPECT_EQ(Find("^east *"), link);
}

TEST_F(GraphMirrorTest, WhatIsGoneGoesAndOthersStay) {
  mirror_.Show(TwoCells("eater", "wall"));
  const std::string here = Find("^here *");
  PerceptGraph graph;
  graph.nodes = {{"", {}, {{"here", 1}}}, Cell("empty")};
  mirror_.Show(graph);
  EXPECT_EQ(Find("^here *"), here);
  EXPECT_EQ(Find("^content wall").find("^content wall"), std::string::npos);
  EXPECT_EQ(Find("^west *").find("^west"), std::string::npos);
  EXPECT_NE(Find("^content empty").find("^content empty"), std::string::npos);
}

TEST_F(GraphMirrorTest, AKeyMakesItTheSameObjectOrAnother) {
  const auto graph = [&](const std::string& key) {
    PerceptGraph made;
    made.nodes = {{"", {}, {{"tank", 1}}}, Cell("red")};
    made.nodes[1].key = key;
    return made;
  };
  mirror_.Show(graph("a"));
  const std::string first = Find("^tank *");
  mirror_.Show(graph("a"));
  EXPECT_EQ(Find("^tank *"), first);
  mirror_.Show(graph("b"));
  EXPECT_NE(Find("^tank *"), first);
}

TEST_F(GraphMirrorTest, ValuesChangeTheirTypeToo) {
  const auto graph = [](PerceptGraph::Value value) {
    PerceptGraph made;
    made.nodes = {{"", {{"distance", std::move(value)}}, {}}};
    return made;
  };
  mirror_.Show(graph(std::int64_t{4}));
  EXPECT_NE(Find("^distance 4").find("^distance 4"), std::string::npos);
  mirror_.Show(graph(std::string("none")));
  EXPECT_NE(Find("^distance none").find("^distance none"), std::string::npos);
  EXPECT_EQ(Find("^distance 4").find("^distance 4"), std::string::npos);
}

TEST_F(GraphMirrorTest, OfEqualValuesOneStandsThere) {
  PerceptGraph graph;
  graph.nodes = {
      {"", {{"content", std::string("a")}, {"content", std::string("a")}, {"content", std::string("b")}}, {}}};
  mirror_.Show(graph);
  mirror_.Show(graph);
  EXPECT_NE(Find("^content a").find("^content a"), std::string::npos);
  EXPECT_NE(Find("^content b").find("^content b"), std::string::npos);
}

}  // namespace
}  // namespace soarbox::sim
