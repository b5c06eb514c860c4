// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/diagnostic.h"
#include "kernel/base/symbol_table.h"
#include "kernel/rules/expected_values.h"
#include "kernel/rules/production.h"

namespace soarbox::kernel {

/// Where a rule's text stands.
struct SourcePlace {
  FileName file;  ///< As the user named it; empty for typed rules.
  int line = 1;   ///< Of the first character of the text.
  int column = 1;
};

/// A text that Soar prints while it reads a rule, letter by letter, with its line ends.
struct RuleMessage {
  std::string text;
  bool fresh_line = false;  ///< Begins on a new line: a line end goes first if the output stands within a line.
  bool is_warning = false;  ///< Not printed while warnings are off.
};

struct ParseOutcome {
  ProductionPtr production;  ///< None if the rule was refused.
  std::string name;          ///< Empty if not even the name could be read.
  /// As soon as the name is read, an older rule of this name is excised (and `#` printed), even if this one is refused
  /// in the end; `late_messages` come after that.
  std::vector<RuleMessage> messages, late_messages;
  std::vector<Diagnostic> diagnostics;  ///< Our own: errors with their place and a hint, and traps found.
};

/// Reads a rule: the text between the braces of `sp { ... }`. Interns what the rule mentions, pinned. Never fails in
/// another way than through the outcome, whatever the text; work and depth are bounded by its length. `expected` is for
/// the order of the conditions.
ParseOutcome ParseProduction(std::string_view body, const SourcePlace& place, SymbolTable& symbols,
                             const ExpectedValues& expected = {});

}  // namespace soarbox::kernel
