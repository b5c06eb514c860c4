// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "diagnostics/diagnostic.h"

namespace soarbox::sim {

class Simulation;

/// A file of a running world: rules, or a script that a machine has executed.
struct WatchedFile {
  std::string agent;  ///< Empty for the sandbox's own script and for the scenario file.
  std::filesystem::path file;
  bool is_rules = false;
  std::string script = {};  ///< If it is a script: its name in scripts ("Lib.lua").
};

/// Adds the files that each file of rules sources, directly or through others, after it. Reads the disk.
std::vector<WatchedFile> WithSourced(const std::vector<WatchedFile>& files);

/// The rules of a text by name. Comments are blanked, and line ends are plain. If a rule is not closed, `rules` is
/// empty and `unclosed` is the name of that rule.
struct SplitText {
  std::map<std::string, std::string> rules;
  std::string only_rules;  ///< The text with everything outside rules blanked; positions stay the same.
  std::string outside;     ///< The text with all rules blanked.
  std::string unclosed;
};
SplitText SplitRules(std::string_view text);

/// The commands that change a mind from one version of a file of rules to another. They replace changed rules and
/// excise removed ones. Working memory does not change.
std::vector<std::string> EditsBetween(const SplitText& before, const SplitText& after);

/// Submits the difference between two versions of a file to the simulation. Working memory and the variables of scripts
/// stay. `elsewhere`: rules that were moved to another file; they are not excised.
void SubmitEdit(Simulation& simulation, const WatchedFile& file, const std::string& before, const std::string& after,
                const std::set<std::string>& elsewhere = {});

/// Whether a file with content has become empty. This is a mistake, or an editor is about to write the file.
bool IsEmptied(const std::string& before, const std::string& after);

/// Applies edits of rules and scripts to a running world. It checks the times of files between ticks and submits the
/// changes to the simulation, so that a recording of the inputs also replays the edits. A file that does not parse
/// changes nothing (vet_rules.h): the previous version keeps running. Reads the disk. Used by the program that runs the
/// simulation.
class LiveEdits {
 public:
  explicit LiveEdits(Simulation& simulation);
  /// For a simulation that continues from an earlier tick of the run that `earlier` watched. The files are treated as
  /// they were at that tick. Later edits therefore reach this simulation as its own edits.
  LiveEdits(Simulation& simulation, const LiveEdits& earlier);

  /// Checks all files. Returns a note for each reloaded file, and the problems of files.
  std::vector<Diagnostic> Poll();

 private:
  struct Version {
    std::filesystem::file_time_type time;
    std::string text;
    std::vector<std::pair<std::uint64_t, std::string>> earlier;  ///< Texts that were in effect until the end of a tick.
    int missed = 0;                                              ///< Number of consecutive checks in which the file was
                                                                 ///< missing.
  };
  void Watch();
  /// Returns the new text of a file that has changed; nothing if it has not changed, or cannot be read.
  std::optional<std::string> TakeChange(const std::filesystem::path& file, Version& version,
                                        std::vector<Diagnostic>& told);
  /// Names of the rules in other files of the agent. A rule that was moved to such a file is not removed.
  std::set<std::string> RulesElsewhere(const WatchedFile& file) const;
  /// Whether a file was written completely. False if it was written only a moment ago and seems incomplete.
  bool IsWhole(const WatchedFile& file, const Version& version, const std::string& text, bool is_refused) const;
  /// Loads files that the new version sources and the previous one did not. Removes the rules of files that are no
  /// longer sourced.
  void FollowSources(const WatchedFile& changed, const std::string& before, const std::string& after,
                     std::vector<Diagnostic>& told);
  /// Reports slips in edited rules once they run, because rules of other files may make the elements that they test.
  void TellSlips(std::vector<Diagnostic>& told);

  Simulation& simulation_;
  std::vector<WatchedFile> files_;
  std::map<std::filesystem::path, Version> versions_;
  struct Edited {
    std::string agent;
    std::set<std::string> rules;
    std::uint64_t tick = 0;  ///< The rules run after this tick.
  };
  std::vector<Edited> edited_;  ///< One agent for each file.
};

}  // namespace soarbox::sim
