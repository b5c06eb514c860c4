// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <set>
#include <string>
#include <string_view>

#include "script/failure_ledger.h"
#include "script/lua_machine.h"
#include "script/script_error.h"
#include "world/ids.h"

namespace soarbox::script {

/// Who wants to hear what scripts print and what goes wrong in them.
class ScriptListener {
 public:
  virtual ~ScriptListener() = default;
  virtual void OnPrint(std::string_view script, std::string_view text) = 0;
  /// A script failed for good: it did not load, or the agent has no mind. `agent` is kSandbox for the sandbox's own.
  virtual void OnScriptFailed(world::EntityId agent, const ScriptError& error) = 0;
  /// Calls of scripts failed, or work again; the scripts go on.
  virtual void OnScriptTrouble(const ScriptTrouble& trouble) = 0;
  /// An error came more often than was reported. For the end of a run.
  virtual void OnErrorCount(const ErrorCount& count) = 0;
  /// Something a script did had no effect. Distinct messages only.
  virtual void OnScriptWarning(const Diagnostic& warning) = 0;
  /// A script says that the run has come to an end (Sandbox.End), and which. Scripts go on.
  virtual void OnEndReached(std::string_view /*end*/) {}
};

/// Passes on errors and warnings, each distinct message once, and texts as far as the world's budget for them goes.
class ScriptReporter final : public PrintSink {
 public:
  ScriptReporter(ScriptListener& listener, WorldBudget& budget) : listener_(listener), budget_(budget) {}

  void OnPrint(std::string_view script, std::string_view text) override;
  void FailedForGood(world::EntityId agent, const ScriptError& error) {
    if (!budget_.end()) listener_.OnScriptFailed(agent, error);
  }
  void EndReached(std::string_view end) { listener_.OnEndReached(end); }
  /// `subject`: what it is about, if only one of its messages is to be reported for each place in a script.
  void Warn(const Diagnostic& warning, std::string_view subject = {});

  /// A call of a script failed, or ended well.
  void Failed(world::EntityId agent, std::string_view callback, const ScriptError& error) {
    if (!LuaMachine::Interrupted() && !budget_.end()) ledger_.Failed(agent, callback, error);
  }
  void Succeeded(world::EntityId agent, std::string_view callback) { ledger_.Succeeded(agent, callback); }
  /// Reports what went wrong since the last call.
  void TellTroubles();
  /// Reports what was not reported at once because it came again and again.
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
