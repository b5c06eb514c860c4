// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include "record/recorder.h"
#include "sim/simulation.h"

namespace soarbox::debugger {

/// For tests: one Soar agent, "hero", in a field, with these rules.
class MindFixture : public ::testing::Test {
 protected:
  ~MindFixture() override {
    if (!folder_.empty()) std::filesystem::remove_all(folder_);
  }

  void Start(const std::string& rules, const std::string& world = {}) {
    if (!folder_.empty()) std::filesystem::remove_all(folder_);
    std::string name = (std::filesystem::temp_directory_path() / "soarbox-debugger-XXXXXX").string();
    folder_ = mkdtemp(name.data());
    rules_file_ = folder_ / "hero.soar";
    Write(rules_file_, rules);
    Write(folder_ / "scenario.toml",
          world.empty() ? "[[agent]]\nname = \"hero\"\nrules = \"hero.soar\"\nbody = \"soldier\"\nposition = [0, 0]\n"
                        : world);
    const std::string root = SOARBOX_SOURCE_DIR;
    const auto scenario = sim::FindScenario(folder_.string(), {root + "/scenarios", root + "/media"});
    ASSERT_TRUE(scenario.ok()) << Format(scenario.error());
    sim::SimulationSettings settings;
    settings.mind_detail = sim::MindDetail::kAll;
    settings.soar.threads = 1;
    auto made = sim::Simulation::Create(*scenario, settings);
    ASSERT_TRUE(made.ok()) << Format(made.error());
    simulation_ = std::move(*made);
  }

  const record::TickRecord& Tick(int count = 1) {
    for (int i = 0; i < count; ++i) {
      simulation_->Tick();
      record::Observe(*simulation_, simulation_->TakeEvents(), record::Level::kAll, record_);
    }
    return record_;
  }

  std::unique_ptr<explain::Inspector> Mind() { return simulation_->Inspect("hero"); }

  static void Write(const std::filesystem::path& file, const std::string& text) { std::ofstream(file) << text; }

  std::filesystem::path folder_, rules_file_;
  std::unique_ptr<sim::Simulation> simulation_;
  record::TickRecord record_;
};

}  // namespace soarbox::debugger
