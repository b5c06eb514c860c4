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

/// The place of a rule's text.
struct SourcePlace {
  FileName file;  ///< As the user named it; empty for typed rules.
  int line = 1;   ///< Line of the first character of the text.
  int column = 1;
};

/// A text that Soar prints while it reads a rule: exact, with its line ends.
struct RuleMessage {
  std::string text;
  bool fresh_line = false;  ///< Must begin on a new line: a line end is inserted if the output is within a line.
  bool is_warning = false;  ///< Not printed while warnings are off.
};

struct ParseOutcome {
  ProductionPtr production;  ///< None if the rule was refused.
  std::string name;          ///< Empty if not even the name could be read.
  /// When the name has been read, an older rule of this name is excised (and `#` printed), even if the new rule is
  /// refused later. `messages` are printed before that, `late_messages` after it.
  std::vector<RuleMessage> messages, late_messages;
  bool is_told = false;                 ///< The messages already report that the rule was refused.
  std::vector<Diagnostic> diagnostics;  ///< Our own: errors with place and hint, and warnings about probable mistakes.
};

/// Properties of the agent that affect the meaning of a rule's text.
struct RuleLanguage {
  /// 9.6.3: `$` is an ordinary character, and a call of an unknown function becomes a call of `exec`. 9.6.5: `$` marks
  /// values that learning keeps unchanged, and an unknown function is an error.
  SoarVersion version = SoarVersion::k965;
  /// Returns whether a client has registered a function of this name. Such a function can be called without `exec`.
  std::function<bool(std::string_view)> is_client_function;
};

/// Reads a rule: the text between the braces of `sp { ... }`. Interns and pins the symbols of the rule. Errors are
/// reported only in the outcome. Work and recursion depth are bounded by the length of the text. `expected` affects the
/// order of the conditions.
ParseOutcome ParseProduction(std::string_view body, const SourcePlace& place, SymbolTable& symbols,
                             const ExpectedValues& expected = {}, const RuleLanguage& language = {});

}  // namespace soarbox::kernel
