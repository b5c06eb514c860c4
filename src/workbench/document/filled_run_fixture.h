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

/// For tests: a small world after 45 ticks, with the contents of all panels.
class FilledRun {
 public:
  FilledRun();
  ~FilledRun();
  FilledRun(const FilledRun&) = delete;
  FilledRun& operator=(const FilledRun&) = delete;

  /// Fills in the contents of all panels with this agent selected: "walker", "listener-with-a-rather-long-name" or
  /// none.
  void Fill(const std::string& agent);

  std::unique_ptr<sim::Simulation> simulation;
  debugger::RunModels models;
  record::TickRecord last;
  Contents contents;

  /// The folder of its files. Each process uses a different one.
  const std::filesystem::path& folder() const { return folder_; }

 private:
  void Write(const char* file, const char* text) const;
  void FillScript();

  std::filesystem::path folder_;
  std::optional<debugger::Console> console_;
};

}  // namespace soarbox::workbench
