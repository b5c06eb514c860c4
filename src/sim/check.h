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

/// Looks over files of rules, Lua and scenario files without running them: what does not parse, and what is likely a
/// slip: attributes that nothing writes, commands that no body knows, operators that are proposed and never applied.
/// Folders stand for the files in them. Problems come in the order of the files.
/// `check_toml` looks over what else .toml files hold, and says whether one is a scenario at all.
using CheckToml = std::function<bool(const std::filesystem::path& file, std::vector<Diagnostic>& problems)>;
std::vector<Diagnostic> CheckFiles(const std::vector<std::filesystem::path>& files, const CheckToml& check_toml = {});

/// What is wrong with a text of rules, with lines and columns in it. `name` is what it is called in the messages.
std::vector<Diagnostic> CheckRuleText(const std::string& text, const std::string& name);
/// What is no error in a rule file and the files that it sources, and still is likely a mistake: what our own kernel
/// warns of. For kernels that warn of nothing. `folders` is what the files may read.
std::vector<Diagnostic> WarningsOfRules(const std::filesystem::path& rules,
                                        const std::vector<std::filesystem::path>& folders);

/// What the rules of a file may test and say besides the vocabulary: what the files of its folder make, and the places
/// of its scenario.
explain::KnownWords WordsAround(const std::filesystem::path& rules);

/// What is wrong with a Lua script, as with a text of rules.
std::vector<Diagnostic> CheckScriptText(const std::string& text, const std::string& name);

}  // namespace soarbox::sim
