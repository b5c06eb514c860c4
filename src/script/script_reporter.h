// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <set>
#include <string>
#include <string_view>

#include "script/lua_machine.h"
#include "script/script_error.h"
#include "world/ids.h"

namespace soarbox::script {

/// Who wants to hear what scripts print and what goes wrong in them.
class ScriptListener {
 public:
  virtual ~ScriptListener() = default;
  virtual void OnPrint(std::string_view script, std::string_view text) = 0;
  /// A script failed; `agent` is kSandbox for the sandbox's own scripts. Distinct messages only.
  virtual void OnScriptError(world::EntityId agent, const ScriptError& error) = 0;
  /// Something a script did had no effect. Distinct messages only.
  virtual void OnScriptWarning(const Diagnostic& warning) = 0;
};

/// Passes errors and warnings on, each distinct message once.
class ScriptReporter final : public PrintSink {
 public:
  explicit ScriptReporter(ScriptListener& listener) : listener_(listener) {}

  void OnPrint(std::string_view script, std::string_view text) override { listener_.OnPrint(script, text); }
  void Error(world::EntityId agent, const ScriptError& error) {
    if (seen_.insert(std::to_string(Number(agent)) + Format(error.diagnostic)).second)
      listener_.OnScriptError(agent, error);
  }
  void Warn(const Diagnostic& warning) {
    if (seen_.insert(Format(warning)).second) listener_.OnScriptWarning(warning);
  }

 private:
  ScriptListener& listener_;
  std::set<std::string> seen_;
};

}  // namespace soarbox::script
