// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "debugger/json.h"
#include "diagnostics/diagnostic.h"
#include "diagnostics/result.h"
#include "sim/simulation.h"

namespace soarbox::debugger {

/// A file of rules, a script or a scenario file that a user edits while the world runs.
class Edit {
 public:
  /// Reads the file; fails if it cannot.
  static Result<Edit> Open(const sim::WatchedFile& file);

  const sim::WatchedFile& file() const { return file_; }
  std::string& text() { return text_; }
  const std::string& text() const { return text_; }
  /// Whether it is a scenario file. The running world was built from it, and does not read it again.
  bool is_scenario() const;
  /// Whether the text differs from the version that the world uses.
  bool is_changed() const { return text_ != InUse(); }
  /// Whether the text differs from the file.
  bool is_unsaved() const { return text_ != saved_; }

  /// Returns the errors in the text, with lines. Changes nothing.
  std::vector<Diagnostic> Check() const;
  /// Submits the text to the simulation, for all agents that use this file. It takes effect in the next tick. Does
  /// nothing if there are errors, or for a scenario file. Returns the result of Check, with a further error if the user
  /// has deleted the entire text. `is_past`: it is a rebuilt past, and the running world keeps its text until EndPast.
  std::vector<Diagnostic> Apply(sim::Simulation& simulation, bool is_past = false);
  /// The rebuilt past is left, or the run continues from it. Returns whether the running world now uses another text.
  bool EndPast(bool continues);
  /// Writes the file. The running world then loads it, unless it has errors.
  Result<void> Save();
  /// Call it when the world was restarted, which loads the files again.
  void BeginAgain() { running_ = saved_; }
  /// Replaces the text by the contents of the file.
  void Revert() { text_ = saved_; }

  enum class Disk : std::uint8_t {
    kSame,     ///< No other program has changed the file, or it cannot be read.
    kTaken,    ///< Another program has changed the file. The text was unchanged and now has the new contents.
    kDiffers,  ///< Another program has changed the file, and the text has unsaved changes. The text stays; Revert
               ///< replaces it by the file.
  };
  /// Checks whether another program has changed the file. The running world also watches the file, and loads the new
  /// contents unless they have errors.
  Disk LookAtDisk();

  /// The first line (from 1) of a rule in the text; 0 if the text does not contain it.
  int LineOf(std::string_view rule) const;

 private:
  const std::string& InUse() const { return past_ ? *past_ : running_; }

  sim::WatchedFile file_;
  std::string text_, running_, saved_;
  std::optional<std::string> past_;            ///< The text that the rebuilt past uses, if it is not the running one.
  std::filesystem::file_time_type written_{};  ///< Modification time of the file when it was last read or saved.
};

/// The files that an agent was loaded from, with those that its rules source, and the scenario file last. An empty
/// agent means the files of all agents. Each file occurs once.
std::vector<sim::WatchedFile> FilesOf(sim::Simulation& simulation, std::string_view agent);

}  // namespace soarbox::debugger
