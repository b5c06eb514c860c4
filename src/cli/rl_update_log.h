// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <fstream>
#include <string>

#include "kernel/agent.h"

namespace soarbox::cli {

/// "RL update RULE current future number -> current future number".
std::string RlUpdateText(const kernel::Agent& agent, const kernel::RlUpdate& update);

/// Writes the updates of an agent's learned values to a file, one per line (`rl --set update-log-path`).
class RlUpdateLog : public kernel::Observer {
 public:
  explicit RlUpdateLog(kernel::Agent& agent) : agent_(agent) {}
  ~RlUpdateLog() override;

  /// Appends to this file from now on; an empty path stops the log. Returns false, without a change, if the file cannot
  /// be written.
  bool SetPath(const std::string& path);

  void OnRlUpdate(const kernel::Agent& agent, const kernel::RlUpdate& update) override;

 private:
  kernel::Agent& agent_;
  std::ofstream file_;
};

}  // namespace soarbox::cli
