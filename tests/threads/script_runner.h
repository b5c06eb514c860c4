// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <string>

#include "agent_scripts.h"
#include "cli/interpreter.h"
#include "cli/session.h"
#include "kernel/agent.h"
#include "kernel/io/input_link.h"

/// An agent that executes a script, and its output. Use it on one thread at a time; the thread may change between two
/// steps.
class ScriptRunner {
 public:
  explicit ScriptRunner(const AgentScript& script);

  /// Executes the next line. False if there was none left: then the transcript ends with the agent's state.
  bool Step();
  const std::string& transcript() const { return transcript_; }

 private:
  void Tick();
  void DescribeState();

  const AgentScript& script_;
  std::size_t next_ = 0;
  int ticks_ = 0;
  soarbox::kernel::InputElement range_ = soarbox::kernel::InputElement::kNone;
  std::string transcript_;
  soarbox::kernel::Agent agent_;
  soarbox::cli::Session session_;
  soarbox::cli::Interpreter interpreter_;
};
