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

/// The learned data of one rule whose only action is a numeric preference.
struct RlValue {
  ProductionId rule = ProductionId::kNone;
  Symbol value;                   ///< The number in its preferences. Before the first update, the number in its text.
  double current = 0;             ///< The part of the value that is the reward of the decision itself.
  double future = 0;              ///< The part of the value that is the expected future reward.
  double updates = 0;             ///< Number of updates.
  double correction = 0;          ///< The second weight of the gq-lambda policies.
  double beta = -3;               ///< Delta-bar-delta: the logarithm of its learning rate.
  double h = 0;                   ///< Delta-bar-delta: a trace of its latest updates.
  std::uint32_t previous_in = 0;  ///< Number of entries for it in goals' lists of rules to update.
  std::uint32_t mark = 0;         ///< The last update that changed it.
};

/// The learned numbers of one agent. Shared rules contain the initial values. A record is created when learning first
/// uses a rule, and is removed with the rule. Agents without reinforcement learning have no records.
class RlValues {
 public:
  explicit RlValues(SymbolTable& symbols) : symbols_(symbols) {}

  bool empty() const { return rows_.empty(); }
  /// Returns null if nothing has been learned for the rule.
  const RlValue* Find(ProductionId rule) const {
    return Index(rule) < row_of_.size() && row_of_[Index(rule)] != 0 ? &rows_[row_of_[Index(rule)] - 1] : nullptr;
  }
  RlValue* Find(ProductionId rule) { return const_cast<RlValue*>(std::as_const(*this).Find(rule)); }
  /// The record of a rule that is_rl; created if necessary. Valid until the next call.
  RlValue& Of(ProductionId rule, const Production& production);
  /// The number for a preference of the rule. `text` is the number in the rule's text.
  Symbol Number(ProductionId rule, Symbol text) const {
    const RlValue* const learned = Find(rule);
    return learned != nullptr ? learned->value : text;
  }
  void Forget(ProductionId rule);

  /// The documentation that replaces the one in the rule's text; null if there is none.
  const std::string* DocumentationOf(ProductionId rule) const;
  /// Writes updates and h into the documentation (`rl --set meta on`).
  void Document(const RlValue& value);
  /// Reads updates and h from the documentation of a loaded rule.
  void ReadDocumentation(ProductionId rule, const Production& production);

  /// The rule with its learned data, for printing and saving; `production` itself if there are none.
  ProductionPtr AsLearned(ProductionId rule, const ProductionPtr& production) const;

  template <typename Visit>
  void ForEach(Visit&& visit) {
    for (RlValue& value : rows_) {
      if (value.rule != ProductionId::kNone) visit(value);
    }
  }

 private:
  SymbolTable& symbols_;
  std::vector<std::uint32_t> row_of_;  ///< By ProductionId: its row plus 1; 0 for none.
  std::vector<RlValue> rows_;          ///< Free rows have no rule.
  std::vector<std::uint32_t> free_;
  std::map<ProductionId, std::string> documentation_;
};

}  // namespace soarbox::kernel
