// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "debugger/json.h"

namespace soarbox::app {

/// Supports the user who edits rules in a page in the same way as in an editor: messages of the Language Server
/// Protocol, in and out. It reads only below one folder and executes nothing.
class EngineLanguage {
 public:
  using Json = debugger::Json;
  virtual ~EngineLanguage() = default;

  /// Returns the replies as JSON.
  virtual std::vector<std::string> Handle(const Json& message) = 0;
  /// Does slower work; call it while there are no requests.
  virtual std::vector<std::string> Idle() = 0;

  /// Null: this build has none.
  static std::unique_ptr<EngineLanguage> Make(const std::filesystem::path& folder);
};

}  // namespace soarbox::app
