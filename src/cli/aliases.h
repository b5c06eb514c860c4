// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "cli/tokens.h"

namespace soarbox::cli {

/// Short names for commands with their first arguments. An expansion is not expanded again.
class AliasTable {
 public:
  /// Starts with Soar's own aliases.
  AliasTable();

  /// Replaces the first word by its expansion if it is an alias.
  void Expand(std::vector<Word>& words) const;

  void Define(std::string name, std::vector<std::string> expansion);
  void Remove(const std::string& name);
  /// The words of the expansion, separated by blanks; empty if there is no such alias.
  std::string Expansion(const std::string& name) const;
  /// All names with their expansions, sorted by name.
  std::vector<std::pair<std::string, std::string>> All() const;

 private:
  std::unordered_map<std::string, std::vector<std::string>> aliases_;
};

}  // namespace soarbox::cli
