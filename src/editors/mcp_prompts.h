// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace soarbox::editors {

/// The prompts of the Model Context Protocol's server, as `prompts/list` describes them: tasks that a person chooses in
/// an assistant.
nlohmann::ordered_json McpPrompts();

/// The text of a prompt with these arguments; nothing if there is no prompt of this name. `missing` receives the name
/// of the first required argument that is missing.
std::optional<std::string> McpPrompt(const std::string& name, const nlohmann::ordered_json& arguments,
                                     std::string& missing);

/// What `resources/list` describes: reference texts that an assistant may read.
nlohmann::ordered_json McpResources();
/// What `resources/templates/list` describes.
nlohmann::ordered_json McpResourceTemplates();

}  // namespace soarbox::editors
