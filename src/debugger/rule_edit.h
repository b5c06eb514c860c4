// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "debugger/json.h"
#include "diagnostics/diagnostic.h"
#include "diagnostics/result.h"
#include "sim/simulation.h"

namespace soarbox::debugger {

/// A file of rules or a script that is being edited while the world runs.
class Edit {
 public:
  /// Reads the file; fails if it cannot.
  static Result<Edit> Open(const sim::WatchedFile& file);

  const sim::WatchedFile& file() const { return file_; }
  std::string& text() { return text_; }
  const std::string& text() const { return text_; }
  /// It is a scenario file: the running world was built from it, and does not read it again.
  bool is_scenario() const;
  /// It differs from what runs.
  bool is_changed() const { return text_ != running_; }
  /// It differs from what is on the disk.
  bool is_unsaved() const { return text_ != saved_; }

  /// What is wrong with the text, with lines; changes nothing.
  std::vector<Diagnostic> Check() const;
  /// Lets the text take effect in the next tick, through the simulation's door, for all agents that were made from this
  /// file. An error among the problems: nothing is done. Returns what Check does. A scenario file is only checked.
  std::vector<Diagnostic> Apply(sim::Simulation& simulation);
  /// Writes the file.
  Result<void> Save();
  /// The world has begun again, with what is on the disk.
  void BeginAgain() { running_ = saved_; }
  /// Back to what is on the disk.
  void Revert() { text_ = saved_; }

  enum class Disk : std::uint8_t {
    kSame,     ///< Nobody else has written the file.
    kTaken,    ///< Somebody has; the text was as it had been on the disk, and is as it is there now.
    kDiffers,  ///< Somebody has, and the text has changes of its own: it stays; Revert takes over what was written.
  };
  /// Looks whether another program has written the file, which by then has taken effect in the running world.
  Disk LookAtDisk();

  /// The first line (from 1) of a rule in the text; 0 if it is not there.
  int LineOf(std::string_view rule) const;

 private:
  sim::WatchedFile file_;
  std::string text_, running_, saved_;
  std::filesystem::file_time_type written_{};  ///< When the file was, last time that it was read.
};

/// The files that an agent was made from, with those that its rules source, and the scenario file last. An empty agent
/// means the files of all agents. Each file occurs once.
std::vector<sim::WatchedFile> FilesOf(sim::Simulation& simulation, std::string_view agent);

}  // namespace soarbox::debugger
