// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "script/script_error.h"
#include "world/ids.h"

namespace soarbox::script {

/// What is reported about calls of scripts that failed.
struct ScriptTrouble {
  enum class Kind : std::uint8_t {
    kError,         ///< A call failed, in each of these agents; only this call is lost.
    kKeepsFailing,  ///< The same callback of these agents keeps failing; it is still called, but no longer reported.
    kWorksAgain,    ///< It kept failing until now.
  };
  Kind kind = Kind::kError;
  std::vector<world::EntityId> agents;  ///< In ascending id; kSandbox for the sandbox's own scripts.
  std::string callback;                 ///< "Agent_Update", "event callback", ...
  ScriptError error;                    ///< Of the first of them; not for kWorksAgain.
};

/// An error that was reported, and how often it has come since.
struct ErrorCount {
  Diagnostic error;
  std::vector<world::EntityId> agents;
  std::uint64_t count = 0;
};

/// Counts the calls of scripts that failed, so that each error is reported once, with all agents that it came in,
/// however many agents fail in however many ticks.
class FailureLedger {
 public:
  /// A call failed.
  void Failed(world::EntityId agent, std::string_view callback, const ScriptError& error);
  /// A call ended well. Costs nothing while nothing is failing.
  void Succeeded(world::EntityId agent, std::string_view callback) {
    if (!failing_.empty()) NoteSuccess(agent, callback);
  }

  /// What there is to report since the last call, in the order in which it first happened.
  std::vector<ScriptTrouble> TakeNews();
  /// Errors that came more often than was reported: what the end of a run should say.
  std::vector<ErrorCount> Untold() const;

 private:
  /// This many failures in a row make a callback one that keeps failing.
  static constexpr std::uint64_t kKeepsFailing = 3;
  /// How often a callback that fails and recovers time after time is reported.
  static constexpr int kMostTold = 3;
  /// Distinct errors that are remembered: error texts may hold numbers that change.
  static constexpr std::size_t kMostErrors = 500;

  using Callback = std::pair<world::EntityId, std::string>;
  struct Failing {
    std::uint64_t in_a_row = 0;
    bool told = false;
  };
  struct Count {
    Diagnostic error;
    std::map<world::EntityId, std::uint64_t> agents;
    std::uint64_t told = 0;  ///< Failures that some news covered.
    std::uint64_t count = 0;
    bool news = false;  ///< In the news that TakeNews will give: further agents join it.
  };

  void NoteSuccess(world::EntityId agent, std::string_view callback);
  /// Adds the agent to the news of this kind about this callback and error.
  void AddNews(ScriptTrouble::Kind kind, world::EntityId agent, std::string_view callback, const ScriptError& error,
               const std::string& text);

  std::map<Callback, Failing> failing_;  ///< Callbacks whose last call failed.
  std::map<Callback, int> times_told_;   ///< How often a callback was reported to keep failing.
  std::map<std::string, Count, std::less<>> errors_;
  std::vector<std::pair<std::string, ScriptTrouble>> news_;  ///< With the text of the error.
};

}  // namespace soarbox::script
