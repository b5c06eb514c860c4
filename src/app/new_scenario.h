// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

namespace soarbox::app {

/// Options of `soarbox new`. The default kind is one agent with Soar rules only.
struct NewOptions {
  std::string name;
  bool lua = false;   ///< A world that a Lua script creates.
  bool team = false;  ///< Two teams of two.
};

/// Writes a commented starter scenario with a test into a new folder. Returns an ExitCode.
int NewScenario(const NewOptions& options);

}  // namespace soarbox::app
