// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "debugger/json.h"
#include "debugger/syntax.h"
#include "explain/inspector.h"
#include "record/tick_record.h"

namespace soarbox::debugger {

enum class RuleSet : std::uint8_t { kAll, kMatching, kFired, kNeverFired };

/// Rules with each word of the text in their name, file or documentation, in the order of loading.
std::vector<explain::RuleFact> ListRules(explain::Inspector& mind, std::string_view filter = {},
                                         RuleSet set = RuleSet::kAll);

/// How far a rule matches, with a sentence about the condition at which it stops.
struct PartialMatch {
  explain::MatchFacts facts;
  std::string sentence;  ///< "stops at condition 2 of 3, (<s> ^color red): S1 ^color is blue"
};
std::optional<PartialMatch> LookAtMatch(explain::Inspector& mind, std::string_view rule);
/// The sentence alone.
std::string Explain(const explain::MatchFacts& facts);

struct RuleView {
  explain::RuleFact rule;
  std::string source;
  std::vector<Token> tokens;  ///< Of the source.
  PartialMatch match;
};
/// Nothing if there is none of this name.
std::optional<RuleView> LookAtRule(explain::Inspector& mind, std::string_view rule);

/// Rules whose names are like this one, most like first.
std::vector<std::string> NearRules(explain::Inspector& mind, std::string_view rule, std::size_t most = 3);

/// Which rules of one agent took part in a run, from what was noted of its ticks (MindDetail::kAll) and from looks at
/// its mind. Counts all that was added, also of futures that somebody left by going back.
class Coverage {
 public:
  struct Row {
    std::string rule;
    std::uint64_t firings = 0;                 ///< As far as is known.
    std::optional<std::uint64_t> first, last;  ///< Ticks in which it fired.
    bool matched = false;                      ///< Had a whole match in a tick that was looked at, or fired.
    std::size_t furthest = 0, conditions = 0;  ///< How many conditions held at best in the looks.
    std::string stops_at;                      ///< The condition behind these; empty if all held.
  };

  /// What the agent did in a tick.
  void Add(std::uint64_t tick, const record::MindRecord& mind);
  /// Notes how far each rule that has not fired matches now. Costs a look at each of them.
  void Look(explain::Inspector& mind);
  /// Rules that the last look saw, in the order of loading, then others that fired.
  std::vector<Row> rows() const;

 private:
  Row& At(const std::string& rule);

  std::vector<std::string> order_;
  std::map<std::string, Row> rows_;
};

std::string ToText(const std::vector<explain::RuleFact>& rules);
Json ToJson(const std::vector<explain::RuleFact>& rules);
std::string ToText(const RuleView& view);
Json ToJson(const RuleView& view);
std::string ToText(const std::vector<Coverage::Row>& rows);
Json ToJson(const std::vector<Coverage::Row>& rows);

}  // namespace soarbox::debugger
