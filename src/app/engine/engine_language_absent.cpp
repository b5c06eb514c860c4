// SPDX-License-Identifier: BSD-2-Clause
// A build with an official Soar has no parser of rules.
#include "app/engine/engine_language.h"

namespace soarbox::app {

std::unique_ptr<EngineLanguage> EngineLanguage::Make(const std::filesystem::path&) {
  return nullptr;
}

}  // namespace soarbox::app
