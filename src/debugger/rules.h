// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "debugger/syntax.h"
#include "explain/inspector.h"
#include "record/tick_record.h"

namespace soarbox::debugger {

enum class RuleSet : std::uint8_t { kAll, kMatching, kFired, kNeverFired };

/// Rules that contain each word of the filter in their name, file or documentation, in the order of loading.
std::vector<explain::RuleFact> ListRules(explain::Inspector& mind, std::string_view filter = {},
                                         RuleSet set = RuleSet::kAll);

/// How many conditions of a rule match, with a sentence about the condition at which it stops.
struct PartialMatch {
  explain::MatchFacts facts;
  std::string sentence;  ///< "stops at condition 2 of 3, (<s> ^color red): S1 ^color is blue"
};
std::optional<PartialMatch> LookAtMatch(explain::Inspector& mind, std::string_view rule);
/// Returns only the sentence.
std::string Explain(const explain::MatchFacts& facts);

struct RuleView {
  explain::RuleFact rule;
  std::string source;
  std::vector<Token> tokens;  ///< The tokens of `source`.
  PartialMatch match;
};
/// Returns nothing if there is no rule of this name.
std::optional<RuleView> LookAtRule(explain::Inspector& mind, std::string_view rule);

/// Rules with similar names, the most similar first, then rules whose names contain `rule`. At most `most`.
std::vector<std::string> NearRules(explain::Inspector& mind, std::string_view rule, std::size_t most = 3);

/// Which rules of one agent took part in a run. The data come from the events of its ticks (MindDetail::kAll) and from
/// inspections of its mind. After the run went back, the ticks of the abandoned future still count.
class Coverage {
 public:
  struct Row {
    std::string rule;
    std::uint64_t firings = 0;                 ///< As far as they were recorded.
    std::optional<std::uint64_t> first, last;  ///< Ticks in which it fired.
    bool matched = false;                      ///< It had a complete match in a tick that was inspected, or it fired.
    std::size_t furthest = 0, conditions = 0;  ///< The largest number of conditions that matched in an inspection, and
                                               ///< the total number.
    std::string stops_at;                      ///< The first condition that failed then; empty if all matched.
  };

  /// Adds what the agent did in a tick.
  void Add(std::uint64_t tick, const record::MindRecord& mind);
  /// Records how many conditions match now, for each rule that has not fired. Costs one query for each of these rules.
  void Look(explain::Inspector& mind);
  /// The rules that the last inspection listed, in the order of loading, followed by other rules that fired.
  std::vector<Row> rows() const;

 private:
  Row& At(const std::string& rule);

  std::vector<std::string> order_;
  std::map<std::string, Row> rows_;
};

std::string ToText(const std::vector<explain::RuleFact>& rules);
std::string ToText(const RuleView& view);
std::string ToText(const std::vector<Coverage::Row>& rows);

}  // namespace soarbox::debugger
