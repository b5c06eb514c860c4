// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/diagnostic.h"
#include "kernel/base/symbol_table.h"
#include "kernel/rules/expected_values.h"
#include "kernel/rules/production.h"
#include "kernel/rules/soar_version.h"

namespace soarbox::kernel {

/// Where a rule's text is.
struct SourcePlace {
  FileName file;  ///< As the user named it; empty for typed rules.
  int line = 1;   ///< Of the first character of the text.
  int column = 1;
};

/// A text that Soar prints while it reads a rule, exactly, with its line ends.
struct RuleMessage {
  std::string text;
  bool fresh_line = false;  ///< Begins on a new line: if the output is within a line, a line end comes first.
  bool is_warning = false;  ///< Not printed while warnings are off.
};

struct ParseOutcome {
  ProductionPtr production;  ///< None if the rule was refused.
  std::string name;          ///< Empty if not even the name could be read.
  /// As soon as the name is read, an older rule of this name is excised (and `#` printed), even if the new one is
  /// refused later; `late_messages` come after that.
  std::vector<RuleMessage> messages, late_messages;
  bool is_told = false;                 ///< The messages say already that the rule is not taken.
  std::vector<Diagnostic> diagnostics;  ///< Our own: errors with their place and a hint, and traps found.
};

/// What a rule's text means beyond the text itself.
struct RuleLanguage {
  /// As 9.6.3: `$` is a word, and a call of an unknown function becomes a call of `exec`. As 9.6.5: `$` marks what
  /// learning keeps as it is, and an unknown function is an error.
  SoarVersion version = SoarVersion::k965;
  /// Whether a client has registered a function of this name. Such a function can be called without `exec`.
  std::function<bool(std::string_view)> is_client_function;
};

/// Reads a rule: the text between the braces of `sp { ... }`. Interns what the rule mentions, pinned. Whatever the
/// text, errors appear only in the outcome; the text's length bounds work and depth. `expected` affects the order of
/// the conditions.
ParseOutcome ParseProduction(std::string_view body, const SourcePlace& place, SymbolTable& symbols,
                             const ExpectedValues& expected = {}, const RuleLanguage& language = {});

}  // namespace soarbox::kernel
