// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"
#include "kernel/base/symbol_table.h"
#include "kernel/rules/production.h"

namespace soarbox::kernel {

/// What an agent has learned of one rule whose only action is a numeric preference.
struct RlValue {
  ProductionId rule = ProductionId::kNone;
  Symbol value;                   ///< What its preferences say. Until the first update the number of its text.
  double current = 0;             ///< The part of the value that is reward of the decision itself...
  double future = 0;              ///< ... and the part that is expected of what follows.
  double updates = 0;             ///< How often it was updated.
  double correction = 0;          ///< The second weight of the gq-lambda policies.
  double beta = -3;               ///< Delta-bar-delta: the logarithm of its learning rate...
  double h = 0;                   ///< ... and a trace of its latest updates.
  std::uint32_t previous_in = 0;  ///< How many entries of goals' lists of rules to be updated name it.
  std::uint32_t mark = 0;         ///< The last update that moved it.
};

/// The learned numbers of one agent. Rules are shared by agents and say what a value is in the beginning; a record is
/// made when learning first has to do with a rule, and goes with the rule. Agents without reinforcement learning have
/// none.
class RlValues {
 public:
  explicit RlValues(SymbolTable& symbols) : symbols_(symbols) {}

  bool empty() const { return rows_.empty(); }
  /// Null if nothing has been learned of it.
  const RlValue* Find(ProductionId rule) const {
    return Index(rule) < row_of_.size() && row_of_[Index(rule)] != 0 ? &rows_[row_of_[Index(rule)] - 1] : nullptr;
  }
  RlValue* Find(ProductionId rule) { return const_cast<RlValue*>(std::as_const(*this).Find(rule)); }
  /// The record of a rule that is_rl. Valid until the next call.
  RlValue& Of(ProductionId rule, const Production& production);
  /// The number that a preference of the rule gets; `text`: the one in the rule's text.
  Symbol Number(ProductionId rule, Symbol text) const {
    const RlValue* const learned = Find(rule);
    return learned != nullptr ? learned->value : text;
  }
  void Forget(ProductionId rule);

  /// What a rule's documentation says instead of that of its text; null if nothing.
  const std::string* DocumentationOf(ProductionId rule) const;
  /// Lets the documentation tell updates and h (`rl --set meta on`).
  void Document(const RlValue& value);
  /// Takes updates and h from the documentation of a rule that is loaded.
  void ReadDocumentation(ProductionId rule, const Production& production);

  /// The rule with what was learned of it, for printing and saving; `production` itself if that is nothing.
  ProductionPtr AsLearned(ProductionId rule, const ProductionPtr& production) const;

  template <typename Visit>
  void ForEach(Visit&& visit) {
    for (RlValue& value : rows_) {
      if (value.rule != ProductionId::kNone) visit(value);
    }
  }

 private:
  SymbolTable& symbols_;
  std::vector<std::uint32_t> row_of_;  ///< By ProductionId: its row and 1; 0 for none.
  std::vector<RlValue> rows_;          ///< Free ones have no rule.
  std::vector<std::uint32_t> free_;
  std::map<ProductionId, std::string> documentation_;
};

}  // namespace soarbox::kernel
