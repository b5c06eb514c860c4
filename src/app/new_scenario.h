// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

namespace soarbox::app {

/// What `soarbox new` was asked for.
struct NewOptions {
  std::string name;
  bool soar = false;  ///< One agent of Soar rules alone; so is a starter without any of these.
  bool lua = false;   ///< A world made by a Lua script.
  bool team = false;  ///< Two teams of two.
};

/// Writes a commented starter scenario with a test into a new folder. Returns an ExitCode.
int NewScenario(const NewOptions& options);

}  // namespace soarbox::app
