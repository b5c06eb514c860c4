// SPDX-License-Identifier: BSD-2-Clause
#include "script/script_reporter.h"

#include "diagnostics/plain_text.h"

namespace soarbox::script {
namespace {

/// Longer texts are cut.
constexpr std::size_t kLongestPrint = std::size_t{64} << 10;

}  // namespace

void ScriptReporter::OnPrint(std::string_view script, std::string_view text) {
  text = Beginning(text, kLongestPrint);
  if (budget_.TakePrint(text.size() + 100)) {
    listener_.OnPrint(script, text);
    return;
  }
  if (prints_left_out_++ > 0) return;
  Diagnostic warning;
  warning.severity = Severity::kWarning;
  warning.message = "scripts print more than " + std::to_string(budget_.limits().print_bytes_per_tick >> 10) +
                    " KB in each step, " + std::string(script) + " among them: lines of theirs are left out";
  listener_.OnScriptWarning(warning);
}

void ScriptReporter::Warn(const Diagnostic& warning, std::string_view subject) {
  if (seen_.size() >= kMostWarnings) return;
  const std::string known = subject.empty()
                                ? Format(warning)
                                : warning.file + ":" + std::to_string(warning.line) + ":" + std::string(subject);
  if (!seen_.insert(known).second) return;
  listener_.OnScriptWarning(warning);
  if (seen_.size() < kMostWarnings) return;
  Diagnostic last;
  last.severity = Severity::kWarning;
  last.message =
      "there were " + std::to_string(kMostWarnings) + " different warnings from scripts: further ones are not reported";
  listener_.OnScriptWarning(last);
}

void ScriptReporter::TellTroubles() {
  for (const ScriptTrouble& trouble : ledger_.TakeNews()) listener_.OnScriptTrouble(trouble);
}

void ScriptReporter::TellCounts() {
  for (const ErrorCount& count : ledger_.Untold()) listener_.OnErrorCount(count);
  if (prints_left_out_ == 0) return;
  Diagnostic warning;
  warning.severity = Severity::kWarning;
  warning.message = std::to_string(prints_left_out_) + " lines that scripts printed were left out";
  listener_.OnScriptWarning(warning);
}

}  // namespace soarbox::script
