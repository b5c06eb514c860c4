// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "diagnostics/diagnostic.h"
#include "explain/rule_slips.h"
#include "sim/scenario.h"

namespace soarbox::sim {

/// Checks a .toml file if it is not a scenario. Returns whether it is a scenario.
using CheckToml = std::function<bool(const std::filesystem::path& file, std::vector<Diagnostic>& problems)>;
/// Checks files of rules, Lua files and scenario files without running them. Finds parse errors and likely slips:
/// attributes that nothing writes, commands that no body accepts, operators that are proposed and never applied. For a
/// folder, checks the files below it in alphabetical order. Each problem is reported once. `check_toml` is called first
/// for each .toml file. `library`: folder of the Lua library, for scripts that load files from it. Without it, calls of
/// functions are checked only in scripts that load nothing.
std::vector<Diagnostic> CheckFiles(const std::vector<std::filesystem::path>& files, const CheckToml& check_toml = {},
                                   const std::filesystem::path& library = {});

/// Checks a text of rules. Problems have lines and columns; messages call the text `name`.
std::vector<Diagnostic> CheckRuleText(const std::string& text, const std::string& name);
/// Returns the warnings of our own kernel about a file of rules and the files that it sources. For kernels that do not
/// warn. `folders`: the folders from which files may be read.
std::vector<Diagnostic> WarningsOfRules(const std::filesystem::path& rules,
                                        const std::vector<std::filesystem::path>& folders);

/// The rules of a file, without those that have errors.
std::vector<explain::RuleText> RulesOf(const std::filesystem::path& file);

/// The words that rules of a file may use in addition to the vocabulary: those of other files in its folder, and the
/// places of its scenario.
explain::KnownWords WordsAround(const std::filesystem::path& rules);

/// Checks the text of a Lua script, like CheckRuleText.
std::vector<Diagnostic> CheckScriptText(const std::string& text, const std::string& name);

}  // namespace soarbox::sim
