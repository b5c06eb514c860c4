// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "script/script_error.h"
#include "world/entity_ids.h"

namespace soarbox::script {

/// A report about failed calls of scripts.
struct ScriptTrouble {
  enum class Kind : std::uint8_t {
    kError,         ///< A call failed in each of these agents. Only this call is lost.
    kKeepsFailing,  ///< The same callback of these agents keeps failing. It is still called, but no longer reported.
    kWorksAgain,    ///< It kept failing, but the last call succeeded.
  };
  Kind kind = Kind::kError;
  std::vector<world::EntityId> agents;  ///< In ascending id; kSandbox for the sandbox's own scripts.
  std::string callback;                 ///< "Agent_Update", "event callback", ...
  ScriptError error;                    ///< Of the first agent; not for kWorksAgain.
};

/// A reported error with the number of its occurrences.
struct ErrorCount {
  Diagnostic error;
  std::vector<world::EntityId> agents;
  std::uint64_t count = 0;
};

/// Counts failed calls of scripts. Each error is reported once, with the agents in which it occurred until that report.
/// Later occurrences are only counted (Untold).
class FailureLedger {
 public:
  /// Notes a failed call.
  void Failed(world::EntityId agent, std::string_view callback, const ScriptError& error);
  /// Notes a successful call. Costs nothing while no callback is failing.
  void Succeeded(world::EntityId agent, std::string_view callback) {
    if (!failing_.empty()) NoteSuccess(agent, callback);
  }

  /// Returns the reports since the last call, in the order of their first occurrence.
  std::vector<ScriptTrouble> TakeNews();
  /// Returns errors that occurred more often than was reported, for the end of a run.
  std::vector<ErrorCount> Untold() const;

 private:
  /// Number of consecutive failures after which a callback counts as one that keeps failing.
  static constexpr std::uint64_t kKeepsFailing = 3;
  /// Maximum number of reports about a callback that repeatedly fails and recovers.
  static constexpr int kMostTold = 3;
  /// Maximum number of distinct errors that are counted and reported: error texts may contain changing numbers.
  static constexpr std::size_t kMostErrors = 500;

  using Callback = std::pair<world::EntityId, std::string>;
  struct Failing {
    std::uint64_t in_a_row = 0;
    bool told = false;
  };
  struct Count {
    Diagnostic error;
    std::map<world::EntityId, std::uint64_t> agents;
    std::uint64_t told = 0;  ///< Failures that were reported.
    std::uint64_t count = 0;
    bool news = false;  ///< TakeNews will report it: further agents are added to that report.
  };

  void NoteSuccess(world::EntityId agent, std::string_view callback);
  /// Adds the agent to the report of this kind about this callback and error.
  void AddNews(ScriptTrouble::Kind kind, world::EntityId agent, std::string_view callback, const ScriptError& error,
               const std::string& text);

  std::map<Callback, Failing> failing_;  ///< Callbacks whose last call failed.
  std::map<Callback, int> times_told_;   ///< Number of reports that a callback keeps failing.
  std::map<std::string, Count, std::less<>> errors_;
  std::vector<std::pair<std::string, ScriptTrouble>> news_;  ///< With the error's text.
};

}  // namespace soarbox::script
