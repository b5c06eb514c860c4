// SPDX-License-Identifier: BSD-2-Clause
#include "record/client_ticks.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace soarbox::record {
namespace {

std::vector<std::string> TicksOf(const std::vector<std::string>& lines) {
  ClientTicks ticks([](const std::string&, const std::string&) {});
  for (const std::string& line : lines) ticks.Add(line);
  ticks.Flush();
  std::vector<std::string> all;
  for (std::size_t i = 0; i < ticks.complete(); ++i) all.push_back(ticks.At(i));
  return all;
}

TEST(ClientTicks, HoldNoWallTime) {
  const std::vector<std::string> once = TicksOf({"agent\ta", "go\ta\t1\t0\t0\t2\t17", "go\ta\t2\t0\t0\t3\t40"});
  const std::vector<std::string> again = TicksOf({"agent\ta", "go\ta\t1\t0\t0\t2\t9000", "go\ta\t2\t0\t0\t3\t9001"});
  EXPECT_EQ(once, again);
  EXPECT_EQ(once, (std::vector<std::string>{"agent\ta\ngo\ta\t1\t0\t0\t2\n", "go\ta\t2\t0\t0\t3\n"}));
}

TEST(ClientTicks, HoldOneDecisionOfEachAgent) {
  EXPECT_EQ(TicksOf({"agent\ta", "agent\tb", "go\ta\t1\t0\t0\t1\t0", "go\tb\t1\t0\t0\t1\t0", "remove\ta\t7",
                     "go\ta\t3\t0\t0\t1\t0"}),
            (std::vector<std::string>{"agent\ta\nagent\tb\ngo\ta\t1\t0\t0\t1\ngo\tb\t1\t0\t0\t1\n",
                                      "remove\ta\t7\ngo\ta\t1\t3\t0\t-\n", "go\ta\t3\t0\t0\t1\n"}));
}

TEST(ClientTicks, LeaveAgentsOfAProgramThatEnded) {
  EXPECT_EQ(TicksOf({"agent\ta", "agent\tb", "gone\ta", "go\tb\t1\t0\t0\t1\t0", "gone\tb"}),
            (std::vector<std::string>{"agent\ta\nagent\tb\ngone\ta\ngo\tb\t1\t0\t0\t1\n"}));
}

TEST(ClientTicks, TakeLinesAsTheyCome) {
  std::vector<std::string> files;
  ClientTicks ticks([&files](const std::string& path, const std::string& content) { files.push_back(path + content); });
  ticks.Flush();
  EXPECT_EQ(ticks.complete(), 0u);
  ticks.Add("soarbox-client\t1\t9.6.3");
  ticks.Add("agent\ta");
  ticks.Add("file\t/r.soar\tsp");
  EXPECT_EQ(ticks.complete(), 0u);
  ticks.Flush();
  ASSERT_EQ(ticks.complete(), 1u);
  EXPECT_EQ(ticks.At(0), "agent\ta\n");
  ticks.Add("go\ta\t1\t0\t0\t1\t5");
  ticks.Add("line\ta\tprint");
  ticks.Flush();
  ASSERT_EQ(ticks.complete(), 3u);
  EXPECT_EQ(ticks.At(1), "go\ta\t1\t0\t0\t1\n");
  EXPECT_EQ(ticks.At(2), "line\ta\tprint\n");
  EXPECT_EQ(files, std::vector<std::string>{"/r.soarsp"});
}

}  // namespace
}  // namespace soarbox::record
