// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/line_stops.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <memory>

#include "sim/scenario.h"
#include "sim/simulation.h"

namespace soarbox::debugger {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* kSandbox = R"(function Sandbox_Initialize(sandbox)
  Sandbox.CreateAgent(sandbox, "Walker.lua")
end
)";

constexpr const char* kWalker = R"(local steps = 0
local function Twice(number)
  local result = number * 2
  return result
end

function Agent_Update(agent, ms)
  steps = steps + 1
  local place = {x = Twice(steps), inner = {deep = "yes"}}
  agent:SetPosition(Vector.new(place.x, 0, 0))
end
)";

class LineStopsTest : public testing::Test {
 protected:
  LineStopsTest() {
    std::string name = (std::filesystem::temp_directory_path() / "soarbox-stops-XXXXXX").string();
    folder_ = mkdtemp(name.data());
    Write("Sandbox.lua", kSandbox);
    Write("Walker.lua", kWalker);
  }
  ~LineStopsTest() override {
    simulation_.reset();
    std::filesystem::remove_all(folder_);
  }

  void Write(const char* file, const char* text) const { std::ofstream(folder_ / file) << text; }
  std::unique_ptr<sim::Simulation> Make() const {
    const std::string root = SOARBOX_SOURCE_DIR;
    const auto scenario = sim::FindScenario(folder_.string(), {root + "/scenarios", root + "/media"});
    sim::SimulationSettings settings;
    settings.soar.threads = 1;
    return std::move(*sim::Simulation::Create(*scenario, settings));
  }
  std::string Walker() const { return (folder_ / "Walker.lua").string(); }
  void Begin() {
    simulation_ = Make();
    sim::ObserveScripts(*simulation_, &stops_.observer());
    stops_.SetEnabled(true);
  }
  static std::string Shown(const std::vector<ScriptRow>& rows) {
    std::string text;
    for (const ScriptRow& row : rows) {
      text += (text.empty() ? "" : ", ") + row.name + "=" + row.value;
      if (row.is_open) text += "[" + Shown(row.below) + "]";
    }
    return text;
  }

  std::filesystem::path folder_;
  std::unique_ptr<sim::Simulation> simulation_;
  std::vector<int> places_;                ///< The lines at which it stopped.
  std::function<void()> look_ = [] {};     ///< At each stop.
  std::vector<script::ScriptStep> steps_;  ///< After each stop; then kGo.
  LineStops stops_{[this] {
    EXPECT_TRUE(stops_.is_stopped());
    places_.push_back(stops_.Place().line);
    look_();
    if (stops_.is_stopped())
      stops_.GoOn(places_.size() <= steps_.size() ? steps_[places_.size() - 1] : script::ScriptStep::kGo);
  }};
};

TEST_F(LineStopsTest, AScriptStopsInEachTickAtTheNextLineThatIsExecuted) {
  Begin();
  EXPECT_EQ(stops_.Set(Walker(), kWalker, 6).value(), 8) << "lines 6 and 7 are in no function";
  EXPECT_THAT(stops_.list(), ElementsAre(LineStop{Walker(), 8}));
  simulation_->Tick();
  simulation_->Tick();
  EXPECT_THAT(places_, ElementsAre(8, 8));
  stops_.Clear(Walker(), 8);
  simulation_->Tick();
  EXPECT_EQ(places_.size(), 2u);
}

TEST_F(LineStopsTest, AStopWithAConditionStopsOnlyIfItIsTrue) {
  Begin();
  stops_.Set(Walker(), kWalker, 9).value();
  stops_.Set(Walker(), kWalker, 9, "steps == 3 and agent:GetPosition().x > 1").value();
  ASSERT_EQ(stops_.list().size(), 1u) << "it replaces the stop at this line";
  EXPECT_EQ(stops_.list().begin()->condition, "steps == 3 and agent:GetPosition().x > 1");
  look_ = [&] {
    const StoppedScript shown = stops_.Look(0, {}, {"steps"});
    EXPECT_EQ(shown.watches[0].value.value, "3");
    EXPECT_EQ(shown.error, "");
  };
  for (int i = 0; i < 5; ++i) simulation_->Tick();
  EXPECT_THAT(places_, ElementsAre(9));
  stops_.Bring({{Walker(), 9, "steps == 7"}});
  look_ = [] {};
  for (int i = 0; i < 5; ++i) simulation_->Tick();
  EXPECT_THAT(places_, ElementsAre(9, 9));
}

TEST_F(LineStopsTest, AClickAboveALineKeepsItsCondition) {
  Begin();
  const int line = stops_.Set(Walker(), kWalker, 7, "steps == 3").value();
  EXPECT_EQ(stops_.Set(Walker(), kWalker, 6).value(), line) << "line 6 is empty";
  ASSERT_EQ(stops_.list().size(), 1u);
  EXPECT_EQ(stops_.list().begin()->condition, "steps == 3");
  stops_.Set(Walker(), kWalker, line).value();
  EXPECT_EQ(stops_.list().begin()->condition, "") << "a request for the line itself removes the condition";
}

TEST_F(LineStopsTest, AConditionWithoutAValueStopsAndSaysWhy) {
  Begin();
  std::vector<std::string> errors;
  look_ = [&] { errors.push_back(stops_.Look(0, {}, {}).error); };
  for (const char* condition :
       {"steps.x.y == 1", "steps ==", "agent:SetHealth(0)", "Twice(1)", "(agent.SetHealth or GetX)(agent, 0)"}) {
    stops_.Set(Walker(), kWalker, 9, condition).value();
    simulation_->Tick();
    ASSERT_FALSE(errors.empty()) << condition;
    EXPECT_THAT(errors.back(), HasSubstr("the condition '" + std::string(condition) + "' has no value: "));
  }
  EXPECT_THAT(errors[2], HasSubstr("might change the world"));
  EXPECT_THAT(errors[4], HasSubstr("might change the world"));
  EXPECT_EQ(errors.size(), 5u);
}

TEST_F(LineStopsTest, LinesWithoutCodeAreRefusedWithAReason) {
  const Result<int> behind = stops_.Set(Walker(), kWalker, 400);
  ASSERT_FALSE(behind);
  EXPECT_THAT(behind.error().hint, HasSubstr("no function executes this line or a line after it"));
  EXPECT_THAT(stops_.Set(Walker(), "function (", 1).error().hint, HasSubstr("does not compile"));
  EXPECT_THAT(stops_.list(), IsEmpty());
}

TEST_F(LineStopsTest, ShowsCallsVariablesAndWatchesAndTakesSteps) {
  Begin();
  stops_.Set(Walker(), kWalker, 9).value();
  using enum script::ScriptStep;
  steps_ = {kInto, kOut, kOver};
  look_ = [&] {
    if (places_.size() == 2) {
      const StoppedScript shown = stops_.Look(0, {}, {});
      EXPECT_EQ(shown.reason, "step");
      ASSERT_EQ(shown.calls.size(), 2u);
      EXPECT_EQ(shown.calls[0].function, "Twice");
      EXPECT_EQ(shown.calls[1].line, 9);
      EXPECT_EQ(Shown(shown.locals), "number=1");
      EXPECT_THAT(Shown(stops_.Look(1, {}, {}).upvalues), HasSubstr("steps=1"));
    }
    if (places_.size() != 4) return;
    const StoppedScript shown =
        stops_.Look(0, {"locals/place", "locals/place/inner"},
                    {"place.x + 1", "nothing.x", "agent:GetPosition().x", "agent:SetHealth(0)", "Twice(1)"});
    EXPECT_EQ(Shown(shown.locals),
              "agent=Walker-1, ms=33, place={inner = {...}, x = 2}[inner={deep = \"yes\"}[deep=\"yes\"], x=2]");
    ASSERT_EQ(shown.watches.size(), 5u);
    EXPECT_EQ(shown.watches[0].value.value, "3");
    EXPECT_NE(shown.watches[1].fault, "");
    EXPECT_EQ(shown.watches[2].fault, "");
    EXPECT_THAT(shown.watches[3].fault, HasSubstr("might change the world"));
    EXPECT_NE(shown.watches[4].fault, "");
  };
  simulation_->Tick();
  EXPECT_THAT(places_, ElementsAre(9, 3, 9, 10));
}

TEST_F(LineStopsTest, ChangeNothingInTheRunAndUseNoneOfItsLimits) {
  const std::unique_ptr<sim::Simulation> alone = Make();
  Begin();
  for (int line = 1; line < 11; ++line) static_cast<void>(stops_.Set(Walker(), kWalker, line));
  look_ = [&] { stops_.Look(0, {"locals/place"}, {"agent:GetPosition().x", "steps"}); };
  steps_.assign(100, script::ScriptStep::kInto);
  for (int i = 0; i < 20; ++i) {
    alone->Tick();
    simulation_->Tick();
    EXPECT_EQ(simulation_->StateHash(), alone->StateHash()) << i;
  }
  EXPECT_GT(places_.size(), 100u);
}

TEST_F(LineStopsTest, AfterLeavingNothingStopsUntilItIsEnabledAgain) {
  Begin();
  for (const int line : {8, 9, 10}) stops_.Set(Walker(), kWalker, line).value();
  look_ = [&] { stops_.Leave(); };
  simulation_->Tick();
  simulation_->Tick();
  EXPECT_THAT(places_, ElementsAre(8));
  stops_.SetEnabled(true);
  simulation_->Tick();
  EXPECT_THAT(places_, ElementsAre(8, 8));
}

TEST_F(LineStopsTest, StopAtErrors) {
  Write("Walker.lua", "function Agent_Update(agent)\n  local wrong = nothing.at_all\nend\n");
  Begin();
  stops_.SetAtErrors(true);
  look_ = [&] {
    EXPECT_EQ(stops_.Look(0, {}, {}).reason, "error");
    EXPECT_THAT(stops_.Look(0, {}, {}).error, HasSubstr("nothing"));
  };
  simulation_->Tick();
  EXPECT_EQ(places_.at(0), 2);
}

TEST_F(LineStopsTest, AnotherRunStopsAtTheSameLines) {
  Begin();
  stops_.Set(Walker(), kWalker, 8).value();
  simulation_->Tick();
  sim::ObserveScripts(*simulation_, nullptr);
  simulation_->Tick();
  EXPECT_EQ(places_.size(), 1u);
  Begin();
  simulation_->Tick();
  EXPECT_EQ(places_.size(), 2u);
}

}  // namespace
}  // namespace soarbox::debugger
