// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <set>
#include <string>
#include <string_view>

#include "script/failure_ledger.h"
#include "script/lua_machine.h"
#include "script/script_error.h"
#include "world/entity_ids.h"

namespace soarbox::script {

/// Receives the output and the failures of scripts.
class ScriptListener {
 public:
  virtual ~ScriptListener() = default;
  virtual void OnPrint(std::string_view script, std::string_view text) = 0;
  /// A script failed permanently: it did not load, or the agent has no mind. `agent` is kSandbox for the sandbox's own.
  virtual void OnScriptFailed(world::EntityId agent, const ScriptError& error) = 0;
  /// Calls of scripts failed, or succeed again; the scripts continue.
  virtual void OnScriptTrouble(const ScriptTrouble& trouble) = 0;
  /// An error occurred more often than was reported; at the end of a run.
  virtual void OnErrorCount(const ErrorCount& count) = 0;
  /// An action of a script had no effect. Each distinct message is reported once.
  virtual void OnScriptWarning(const Diagnostic& warning) = 0;
  /// A script has ended the run (Sandbox.End); `end` names the ending. Scripts continue.
  virtual void OnEndReached(std::string_view /*end*/) {}
};

/// Forwards errors and warnings, each distinct message once, and printed texts within the world's budget.
class ScriptReporter final : public PrintSink {
 public:
  ScriptReporter(ScriptListener& listener, WorldBudget& budget) : listener_(listener), budget_(budget) {}

  void OnPrint(std::string_view script, std::string_view text) override;
  void FailedForGood(world::EntityId agent, const ScriptError& error) {
    if (!budget_.end()) listener_.OnScriptFailed(agent, error);
  }
  void EndReached(std::string_view end) { listener_.OnEndReached(end); }
  /// `subject`: the subject of the message, if only one message about it is to be reported for each place in a script.
  void Warn(const Diagnostic& warning, std::string_view subject = {});

  /// Notes a failed or a successful call of a script.
  void Failed(world::EntityId agent, std::string_view callback, const ScriptError& error) {
    if (!LuaMachine::Interrupted() && !budget_.end()) ledger_.Failed(agent, callback, error);
  }
  void Succeeded(world::EntityId agent, std::string_view callback) { ledger_.Succeeded(agent, callback); }
  /// Reports the failures since the last call.
  void TellTroubles();
  /// Reports errors that were not reported at once because they occurred repeatedly.
  void TellCounts();

 private:
  static constexpr std::size_t kMostWarnings = 500;

  ScriptListener& listener_;
  WorldBudget& budget_;
  FailureLedger ledger_;
  std::set<std::string> seen_;
  std::uint64_t prints_left_out_ = 0;
};

}  // namespace soarbox::script
