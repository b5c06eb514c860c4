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
#include "mind/decision_facts.h"
#include "record/header.h"
#include "record/percept_values.h"
#include "record/tick_record.h"

namespace soarbox::debugger {

/// The state of one mind after the last added tick, as far as the records of the ticks contain it.
struct RecordedMind {
  /// A selected operator, and why it was selected.
  struct Selected {
    std::string id, name;
    std::string decision;  ///< Packed (mind/decision_codec.h); may be empty.
  };
  struct Command {
    std::string name, parameters;                             ///< "^waypoint gate ^within 0.8"
    std::vector<std::pair<std::string, std::string>> values;  ///< The same as pairs of attribute and value.
    std::string status;                                       ///< Empty while the command is under way.
    std::string reason;
    std::string rule;                ///< The rule that gave it; empty if it is not known.
    std::vector<Selected> selected;  ///< The operators that were selected when it was given, from the top state down.
    std::uint64_t tick = 0;
  };

  record::Level level = record::Level::kDecisions;
  bool is_whole = true;  ///< The records are complete from the beginning of the mind's run.
  std::vector<explain::StateFact> stack;
  /// Why an operator was selected in a state, or why none was.
  struct Account {
    std::string decision;  ///< Packed (mind/decision_codec.h); may be empty.
    std::string remark;    ///< The text of a mind::Remark, which nothing writes any more.
  };
  std::map<int, Account> accounts;  ///< By level of the stack.
  record::PerceptValues percepts;
  std::map<std::uint64_t, explain::ElementFact> elements;  ///< Level::kAll, by time tag.
  std::map<std::string, std::uint64_t> firings;            ///< Level::kAll, by rule.
  std::deque<Command> commands;                            ///< Newest first.
  std::uint64_t decisions = 0, fired = 0;
  bool halted = false;
};

/// The minds of a recording, for moments that are not simulated again. At Level::kDecisions they have goal stack,
/// percepts and commands; at Level::kAll also working memory and firings. Add ticks in order.
class RecordedMinds {
 public:
  /// `only`: the name of the one mind to keep; empty to keep all.
  explicit RecordedMinds(record::Level level = record::Level::kDecisions, std::string only = {})
      : level_(level), only_(std::move(only)) {}

  /// Ticks come in order, from the first recorded tick. To go back to an earlier tick, call Clear and begin again.
  void Add(const record::TickRecord& tick);
  void Clear();
  bool empty() const { return !has_ticks_; }
  std::uint64_t last_tick() const { return last_tick_; }

  /// Null if nothing was recorded about this mind so far.
  const RecordedMind* Find(std::string_view agent) const;
  /// An inspector for the mind's present state, valid until the next call of Add or until this object is destroyed.
  /// Data that are not recorded are empty, and the views say so.
  std::unique_ptr<explain::Inspector> Inspect(std::string_view agent) const;

 private:
  record::Level level_;
  std::string only_;
  bool has_ticks_ = false, from_begin_ = false;
  std::uint64_t last_tick_ = 0;
  std::map<std::string, RecordedMind, std::less<>> minds_;
};

/// What a view shows for missing data: "not available there", or "not recorded" for a recorded mind.
std::string_view Absence(const explain::Inspector& mind);
/// Why a view of a recorded mind's memory or rules is empty, and what to do. Empty for other minds, and if memory and
/// rules are recorded.
std::string MemoryAbsence(const explain::Inspector& mind);

/// For a recorded mind without a recorded decision about the view's state: notes that preferences are not recorded, and
/// says only which operators are selected or proposed. Does nothing for other minds.
void TellRecorded(const explain::Inspector& mind, OperatorsView& view);

/// Explains the result of a command and which rule gave it; nothing if no command of this name is recorded.
std::optional<WhyNode> WhyRecordedCommand(const RecordedMind& mind, std::string_view name);
/// Explains the mind's present behaviour as far as it is recorded.
WhyNode WhyRecorded(const RecordedMind& mind, std::string_view agent);

}  // namespace soarbox::debugger
