// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace soarbox {

enum class Severity : std::uint8_t { kNote, kWarning, kError };

/// What a diagnostic is about, for code that treats some diagnostics differently.
enum class Topic : std::uint8_t {
  kOther,
  kEndless,        ///< Rules fire endlessly in one phase.
  kHaltedAtWork,   ///< An agent was halted because its rules fired too often in one tick.
  kRepeatedWrite,  ///< A rule writes text again at each change of a percept.
  kUnmade,         ///< A rule tests an attribute that no percept and no rule makes.
  kUnfired,        ///< A rule never fired in a run.
  kDroppedText,    ///< A part of a rule's text is not in the rule, so that later checks cannot find it.
};
inline constexpr Topic kLastTopic = Topic::kDroppedText;

/// An error in something that a user wrote: what is wrong, where, and what to do about it. The command line, the panels
/// and the JSON output all show this struct.
struct Diagnostic {
  Severity severity = Severity::kError;
  std::string file;        ///< As the user named it; empty for typed input.
  int line = 0;            ///< From 1; 0 if unknown.
  int column = 0;          ///< From 1; 0 if unknown.
  std::string message;     ///< One sentence without a full stop: what is wrong.
  std::string excerpt;     ///< The offending source line, if known.
  int excerpt_length = 1;  ///< How many characters of the excerpt to underline.
  std::string hint;        ///< What to do, if that is known: "did you mean <target>?".
  int more = 0;            ///< Number of further places with the same error; this is the first.
  std::string rule;        ///< Name of the rule that it is about; may be empty.
  Topic topic = Topic::kOther;
  std::string meant;  ///< The word that was probably meant, if the topic is a wrong word; may be empty.
};

/// "file:line:column: error: message", the excerpt with a caret line, "   note: hint".
/// Ends with a newline. Parts that are unknown are left out.
std::string Format(const Diagnostic& diagnostic);

/// The candidate that is most similar to a misspelt word, by edit distance; empty if none is similar.
std::string_view Suggest(std::string_view word, const std::vector<std::string_view>& candidates);

}  // namespace soarbox
