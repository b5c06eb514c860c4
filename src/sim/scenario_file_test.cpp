// SPDX-License-Identifier: BSD-2-Clause
#include "sim/scenario_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace soarbox::sim {
namespace {

using testing::ElementsAre;

/// "line: problem" for an obstacle, or another entry, with these lines.
std::vector<std::string> ProblemsOf(const std::string& lines, const std::string& of = "[[obstacle]]") {
  std::vector<Diagnostic> problems;
  ParseScenarioFile(of + "\n" + lines, "yard.toml", problems);
  std::vector<std::string> told;
  for (const Diagnostic& problem : problems) told.push_back(std::to_string(problem.line) + ": " + problem.message);
  return told;
}

TEST(ScenarioFile, ObstaclesThatNoBodyCouldBeAreRefusedWithTheirLine) {
  EXPECT_THAT(ProblemsOf("size = [5, 2, 0.5]\nmass = 10"), ElementsAre());
  EXPECT_THAT(ProblemsOf("mass = 3\nsize = [-5, 2, 1e-9]"),
              ElementsAre("3: a width of -5 m is not possible", "3: a length of 1e-09 m is not possible"));
  EXPECT_THAT(ProblemsOf("size = [nan, 2, 1]"), ElementsAre("2: 'size' takes [width, height, length] in metres"));
  EXPECT_THAT(ProblemsOf("mass = -1"), ElementsAre("2: 'mass' takes a number from 0 to 1000000"));
  EXPECT_THAT(ProblemsOf("mass = nan"), ElementsAre("2: 'mass' takes a number from 0 to 1000000"));
}

TEST(ScenarioFile, AnItemHasASizeThatSomebodyCanCarry) {
  EXPECT_THAT(ProblemsOf("name = 'crate'\nsize = [1.6, 0.1, 1]", "[[item]]"), ElementsAre());
  EXPECT_THAT(ProblemsOf("name = 'crate'", "[[item]]"), ElementsAre());
  for (const char* size : {"[3, 1, 1]", "[1, 0, 1]", "[1, 1, -1]"}) {
    EXPECT_THAT(ProblemsOf(std::string("name = 'crate'\nsize = ") + size, "[[item]]"),
                ElementsAre("3: the sides of an item are 0.1 to 1.6 m: agents carry nothing larger"));
  }
  EXPECT_THAT(ProblemsOf("name = 'crate'\nsize = [nan, 1, 1]", "[[item]]"),
              ElementsAre("3: 'size' takes [width, height, length] in metres"));
}

TEST(ScenarioFile, ARegionWithABadRadiusHasOneProblem) {
  std::vector<Diagnostic> problems;
  ParseScenarioFile("[[region]]\nradius = -2\n[[region]]\nname = 'gate'", "yard.toml", problems);
  ASSERT_EQ(problems.size(), 2u);
  EXPECT_EQ(problems[0].message, "'radius' takes a number from 0.1 to 100000");
  EXPECT_EQ(problems[1].message, "this region has neither 'radius' nor 'size'");
}

TEST(ScenarioFile, TextWithoutQuotesIsCalledThat) {
  for (const char* word : {"scout", "north", "inn", "tower", "field"}) {
    std::vector<Diagnostic> problems;
    ParseScenarioFile(std::string("[[waypoint]]\nname = ") + word, "yard.toml", problems);
    ASSERT_EQ(problems.size(), 1u) << word;
    EXPECT_EQ(problems[0].hint, "put text between quotes: name = \"scout\"") << word;
  }
}

TEST(ScenarioFile, AColumnIsRound) {
  EXPECT_THAT(ProblemsOf("shape = 'column'\nsize = [1, 2.5, 1]"), ElementsAre());
  EXPECT_THAT(ProblemsOf("shape = 'column'\nsize = [3, 2, 1]"),
              ElementsAre("3: a column is as long as it is wide", "3: a column is at least as high as it is wide"));
}

}  // namespace
}  // namespace soarbox::sim
