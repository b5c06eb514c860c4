// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

#include "kernel/agent.h"

namespace soarbox::cli {

class Session;

/// Prints what learning traces back (`trace --backtracing`). Owned by the trace printer.
class BacktracePrinter : public kernel::Observer {
 public:
  explicit BacktracePrinter(Session& session) : session_(session) {}
  ~BacktracePrinter() override;

  /// Subscribes to the steps, or unsubscribes.
  void Listen(bool on);

  void OnBacktrace(const kernel::Agent& agent, const kernel::BacktraceStep& step) override;

 private:
  void PrintFiring(const kernel::Agent& agent, const kernel::BacktraceStep& step);

  Session& session_;
  bool listens_ = false;
};

/// Appends a negated condition, indented, without a line end.
void AppendNegation(std::string& text, const kernel::Agent& agent, const kernel::Condition& condition);

}  // namespace soarbox::cli
