// SPDX-License-Identifier: BSD-2-Clause
#include "app/engine/engine_language.h"

#include <nlohmann/json.hpp>

#include "diagnostics/json_text.h"
#include "editors/lsp_server.h"

namespace soarbox::app {
namespace {

std::vector<std::string> TextsOf(const std::vector<editors::Json>& messages) {
  std::vector<std::string> texts;
  for (const editors::Json& message : messages) texts.push_back(JsonText(message));
  return texts;
}

class LspLanguage final : public EngineLanguage {
 public:
  explicit LspLanguage(const std::filesystem::path& folder) : server_(nullptr, {folder}) {}

  std::vector<std::string> Handle(const Json& message) override {
    // Ignores commands, because they start programs: they are only for editors on this machine.
    const auto method = message.find("method");
    if (method != message.end() && (*method == "workspace/executeCommand" || *method == "exit")) return {};
    return TextsOf(server_.Handle(JsonText(message)));
  }
  std::vector<std::string> Idle() override {
    return server_.HasIdleWork() ? TextsOf(server_.Idle()) : std::vector<std::string>();
  }

 private:
  editors::LspServer server_;
};

}  // namespace

std::unique_ptr<EngineLanguage> EngineLanguage::Make(const std::filesystem::path& folder) {
  return std::make_unique<LspLanguage>(folder);
}

}  // namespace soarbox::app
