// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "debugger/operators.h"
#include "debugger/why.h"
#include "explain/inspector.h"
#include "mind/decision.h"
#include "record/header.h"
#include "record/percept_values.h"
#include "record/tick_record.h"

namespace soarbox::debugger {

/// What the records of ticks tell of one mind at the end of the last of them.
struct RecordedMind {
  /// An operator that was selected, and why.
  struct Selected {
    std::string id, name;
    std::string decision;  ///< Packed (mind/decision_codec.h); may be empty.
  };
  struct Command {
    std::string name, parameters;                             ///< "^waypoint gate ^within 0.8"
    std::vector<std::pair<std::string, std::string>> values;  ///< The same by attribute.
    std::string status;                                       ///< Empty: under way.
    std::string reason;
    std::string rule;                ///< That said it; empty if it is not known.
    std::vector<Selected> selected;  ///< When it was given, from the top state down.
    std::uint64_t tick = 0;
  };

  record::Level level = record::Level::kDecisions;
  bool is_whole = true;  ///< Known since the beginning of its run.
  std::vector<explain::StateFact> stack;
  /// Why an operator was selected in a state, or none was.
  struct Account {
    std::string decision;  ///< Packed (mind/decision_codec.h); may be empty.
    std::string remark;    ///< What an old recording says instead, in words.
  };
  std::map<int, Account> accounts;  ///< By level of the stack.
  record::PerceptValues percepts;
  std::map<std::uint64_t, explain::ElementFact> elements;  ///< Level::kAll, by time tag.
  std::map<std::string, std::uint64_t> firings;            ///< Level::kAll, by rule.
  std::deque<Command> commands;                            ///< Newest first.
  std::uint64_t decisions = 0, fired = 0;
  bool halted = false;
};

/// Minds of a recording, for moments that are not simulated again: goal stack, percepts and commands at
/// Level::kDecisions, working memory and firings at Level::kAll. Fed tick by tick.
class RecordedMinds {
 public:
  /// `only`: the one mind that is wanted; empty: all.
  explicit RecordedMinds(record::Level level = record::Level::kDecisions, std::string only = {})
      : level_(level), only_(std::move(only)) {}

  /// Ticks come in order, from the first that is recorded on. For an earlier one begin again with Clear.
  void Add(const record::TickRecord& tick);
  void Clear();
  bool empty() const { return !has_ticks_; }
  std::uint64_t last_tick() const { return last_tick_; }

  /// Null if nothing was recorded of such a mind up to now.
  const RecordedMind* Find(std::string_view agent) const;
  /// The same mind for views of living minds; valid until the next Add or the end of this. What is not recorded is
  /// empty, and the views say so.
  std::unique_ptr<explain::Inspector> Inspect(std::string_view agent) const;

 private:
  record::Level level_;
  std::string only_;
  bool has_ticks_ = false, from_begin_ = false;
  std::uint64_t last_tick_ = 0;
  std::map<std::string, RecordedMind, std::less<>> minds_;
};

/// What a view says in place of what this mind does not tell: "not available there"; of a recorded one "not recorded".
std::string_view Absence(const explain::Inspector& mind);
/// Why a view of a recorded mind's memory or rules is empty, and what to do; empty for others, and where they are
/// recorded.
std::string MemoryAbsence(const explain::Inspector& mind);

/// Takes out of a view of operators what a recording cannot know, and puts the recorded reason in; others stay.
void TellRecorded(const explain::Inspector& mind, OperatorsView& view);

/// How a command went and which rule gave it; nothing if none of that name is recorded.
std::optional<WhyNode> WhyRecordedCommand(const RecordedMind& mind, std::string_view name);
/// Why it does what it does, as far as that is recorded.
WhyNode WhyRecorded(const RecordedMind& mind, std::string_view agent);

}  // namespace soarbox::debugger
