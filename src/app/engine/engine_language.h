// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "debugger/json.h"

namespace soarbox::app {

/// Helps whoever types rules in a page, as an editor is helped: messages of the Language Server Protocol, in and out.
/// It reads below one folder only, and runs nothing.
class EngineLanguage {
 public:
  using Json = debugger::Json;
  virtual ~EngineLanguage() = default;

  /// The answers, as JSON.
  virtual std::vector<std::string> Handle(const Json& message) = 0;
  /// Slower work; call it while nobody asks for anything.
  virtual std::vector<std::string> Idle() = 0;

  /// Null: this build has none.
  static std::unique_ptr<EngineLanguage> Make(const std::filesystem::path& folder);
};

}  // namespace soarbox::app
