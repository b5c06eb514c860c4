// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace soarbox::cli {

/// The rules that `gp` generates from one text. Each [list of values] in it is replaced by each of its values in turn.
/// The rules are named NAME*1, NAME*2, ... The first list changes fastest.
struct GeneratedRules {
  std::uint64_t count = 0;
  std::string error;  ///< If not empty, there are no rules, and this says why.
  std::string name;
  std::vector<std::string> texts;  ///< The text before, between and after the lists.
  std::vector<std::vector<std::string>> values;

  /// The text of rule `index`, from 0 to count - 1.
  std::string Body(std::uint64_t index) const;
};

/// Parses the text. Fails if there are more than `limit` rules.
GeneratedRules GenerateRules(std::string_view text, std::uint64_t limit);

}  // namespace soarbox::cli
