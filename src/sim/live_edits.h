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

/// A file that a running world was made from: rules, or a script that a machine has run.
struct WatchedFile {
  std::string agent;  ///< Empty: the sandbox's own script.
  std::filesystem::path file;
  bool is_rules = false;
  std::string script = {};  ///< What scripts call it ("Lib.lua"), if it is one.
};

/// The same files, each file of rules followed by those that it sources, with all below them. Reads the disk.
std::vector<WatchedFile> WithSourced(const std::vector<WatchedFile>& files);

/// The rules of a text by name, with comments blanked and plain line ends. Empty, with the name of the rule at fault,
/// if one is not closed.
struct SplitText {
  std::map<std::string, std::string> rules;
  std::string only_rules;  ///< The text with everything outside of rules blanked: places stay.
  std::string outside;     ///< The other way round: what is outside of rules.
  std::string unclosed;
};
SplitText SplitRules(std::string_view text);

/// The commands that turn one version of a file of rules into another: a changed rule replaces the previous one, a rule
/// that is gone is excised, and everything in working memory stays.
std::vector<std::string> EditsBetween(const SplitText& before, const SplitText& after);

/// Hands an edit from one version of a file to another to the simulation's one door. Working memory and what a script
/// knows stay. `elsewhere`: rules that another file now has, so that they are not excised.
void SubmitEdit(Simulation& simulation, const WatchedFile& file, const std::string& before, const std::string& after,
                const std::set<std::string>& elsewhere = {});

/// True if nothing is left of a file that held something: that is a slip, or an editor is about to write.
bool IsEmptied(const std::string& before, const std::string& after);

/// Lets edits of rules and scripts reach a running world: looks at the files' times between ticks, and hands what
/// changed to the simulation's one door, so that a record of the inputs replays the edits too. A file that does not
/// parse changes nothing (vet_rules.h): the previous version keeps running. Reads the disk; for the program that runs
/// the simulation.
class LiveEdits {
 public:
  explicit LiveEdits(Simulation& simulation);
  /// For a simulation that went back in the run that `earlier` watched: its files count as they were at this tick of
  /// that run, so what you edited since soon reaches it as an edit of its own.
  LiveEdits(Simulation& simulation, const LiveEdits& earlier);

  /// Looks at all files; says what was reloaded (a note), and what is wrong.
  std::vector<Diagnostic> Poll();

 private:
  struct Version {
    std::filesystem::file_time_type time;
    std::string text;
    std::vector<std::pair<std::uint64_t, std::string>> earlier;  ///< Texts that were in effect up to the end of a tick.
    int missed = 0;                                              ///< How often in a row it was missing.
  };
  void Watch();
  /// The new text of a file that has changed; nothing if it has not, or cannot be read.
  std::optional<std::string> TakeChange(const std::filesystem::path& file, Version& version,
                                        std::vector<Diagnostic>& told);
  /// Names of the rules that other files of the agent hold: a rule that was moved there is still meant.
  std::set<std::string> RulesElsewhere(const WatchedFile& file) const;
  /// False if somebody may be about to write the rest of it: it was written only just now, and something is missing.
  bool IsWhole(const WatchedFile& file, const Version& version, const std::string& text, bool is_refused) const;
  /// Loads files that the new version sources and the previous one did not; removes the rules of those that it no
  /// longer sources.
  void FollowSources(const WatchedFile& changed, const std::string& before, const std::string& after,
                     std::vector<Diagnostic>& told);
  /// Reports slips in rules that were edited, once they run: what others make counts.
  void TellSlips(std::vector<Diagnostic>& told);

  Simulation& simulation_;
  std::vector<WatchedFile> files_;
  std::map<std::filesystem::path, Version> versions_;
  struct Edited {
    std::string agent;
    std::set<std::string> rules;
    std::uint64_t tick = 0;  ///< They run after this one.
  };
  std::vector<Edited> edited_;  ///< One agent for each file.
};

}  // namespace soarbox::sim
