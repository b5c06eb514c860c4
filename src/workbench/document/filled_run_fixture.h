// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "debugger/console.h"
#include "debugger/run_models.h"
#include "record/tick_record.h"
#include "sim/simulation.h"
#include "workbench/contents.h"

namespace soarbox::workbench {

/// A small world after 45 ticks, with contents of all panels, for tests.
class FilledRun {
 public:
  FilledRun();
  ~FilledRun();
  FilledRun(const FilledRun&) = delete;
  FilledRun& operator=(const FilledRun&) = delete;

  /// The contents of all panels while this agent is selected: "walker", "listener-with-a-rather-long-name" or nobody.
  void Fill(const std::string& agent);

  std::unique_ptr<sim::Simulation> simulation;
  debugger::RunModels models;
  record::TickRecord last;
  Contents contents;

  /// Where its files are: another folder in each process.
  const std::filesystem::path& folder() const { return folder_; }

 private:
  void Write(const char* file, const char* text) const;

  std::filesystem::path folder_;
  std::optional<debugger::Console> console_;
};

}  // namespace soarbox::workbench
