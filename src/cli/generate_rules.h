// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace soarbox::cli {

/// The rules that `gp` makes from one text. Each [list of values] in it takes each of its values in turn. The rules are
/// numbered NAME*1, NAME*2, ... The first list changes fastest.
struct GeneratedRules {
  std::uint64_t count = 0;
  std::string error;  ///< Not empty: there are no rules, and this says why.
  std::string name;
  std::vector<std::string> texts;  ///< The text before, between and after the lists.
  std::vector<std::vector<std::string>> values;

  /// The text of rule `index`, from 0 to count - 1.
  std::string Body(std::uint64_t index) const;
};

/// Reads the text; more than `limit` rules are an error.
GeneratedRules GenerateRules(std::string_view text, std::uint64_t limit);

}  // namespace soarbox::cli
