// SPDX-License-Identifier: BSD-2-Clause
#include "sml/client/decision_reason.h"

#include <algorithm>
#include <cstdio>
#include <vector>

#include "cli/object_printer.h"
#include "cli/stack_printer.h"
#include "kernel/decide/exploration.h"

namespace soarbox {
namespace {

using kernel::PreferenceType;
using kernel::Symbol;

constexpr std::size_t kMostNamed = 3;

std::string Called(const kernel::Agent& agent, Symbol op) {
  const std::string name = cli::OperatorName(agent, op);
  const std::string id = cli::SymbolText(agent, op);
  return name.empty() ? id : name + " (" + id + ")";
}

std::string Listed(const kernel::Agent& agent, const std::vector<Symbol>& operators) {
  std::string text;
  for (std::size_t i = 0; i < std::min(operators.size(), kMostNamed); ++i)
    text += (i == 0 ? "" : ", ") + Called(agent, operators[i]);
  if (operators.size() > kMostNamed) text += " and " + std::to_string(operators.size() - kMostNamed) + " more";
  return text;
}

/// The preferences of an operator slot, and who is left of its candidates step by step, as the decision procedure goes.
class Contest {
 public:
  Contest(const kernel::Agent& agent, const kernel::Slot& slot, Symbol winner) : agent_(agent), winner_(winner) {
    const kernel::WorkingMemory& memory = agent.memory();
    for (kernel::PreferenceId p = slot.acceptable; p != kernel::PreferenceId::kNone;
         p = memory.preference(p).next_in_slot) {
      const kernel::Preference& preference = memory.preference(p);
      if (preference.value == winner && proposal_ == nullptr) proposal_ = &preference;
      if (!Has(left_, preference.value)) left_.push_back(preference.value);
    }
    for (kernel::PreferenceId p = slot.others; p != kernel::PreferenceId::kNone; p = memory.preference(p).next_in_slot)
      others_.push_back(&memory.preference(p));
  }

  /// Proposed by what; null if it is required only.
  const kernel::Preference* proposal() const { return proposal_; }

  std::string Reason() {
    if (const kernel::Preference* required = Find(PreferenceType::kRequire)) return "required by " + RuleOf(*required);
    if (left_.size() == 1) return "the only one proposed";
    Drop([](const kernel::Preference& p, Symbol candidate) {
      return p.value == candidate && (p.type == PreferenceType::kReject || p.type == PreferenceType::kProhibit);
    });
    if (left_.size() == 1) return "the only one that is not rejected";
    if (std::string reason = AfterComparing(); left_.size() == 1) return reason;
    if (const kernel::Preference* best = Find(PreferenceType::kBest)) {
      KeepBest();
      if (left_.size() == 1) return "best, says " + RuleOf(*best);
    }
    DropWorst();
    if (left_.size() == 1) return "the others are worst";
    return AmongIndifferent();
  }

 private:
  static bool Has(const std::vector<Symbol>& list, Symbol value) {
    return std::find(list.begin(), list.end(), value) != list.end();
  }
  const kernel::Preference* Find(PreferenceType type) const {
    const auto at = std::find_if(others_.begin(), others_.end(),
                                 [&](const kernel::Preference* p) { return p->type == type && p->value == winner_; });
    return at == others_.end() ? nullptr : *at;
  }
  std::string RuleOf(const kernel::Preference& preference) const {
    return std::string(agent_.ProductionName(preference.instantiation));
  }

  template <typename Loses>
  void Drop(Loses loses) {
    std::erase_if(left_, [&](Symbol candidate) {
      return std::any_of(others_.begin(), others_.end(),
                         [&](const kernel::Preference* p) { return loses(*p, candidate); });
    });
  }

  /// Drops those that others are better than; names those that the winner itself is better than.
  std::string AfterComparing() {
    const std::vector<Symbol> all = left_;
    std::vector<Symbol> beaten;
    const kernel::Preference* said = nullptr;
    for (const kernel::Preference* p : others_) {
      const bool is_better = p->type == PreferenceType::kBetter;
      if (!is_better && p->type != PreferenceType::kWorse) continue;
      const Symbol better = is_better ? p->value : p->referent, worse = is_better ? p->referent : p->value;
      if (!Has(all, better) || !Has(all, worse) || better == worse) continue;
      std::erase(left_, worse);
      if (better != winner_ || Has(beaten, worse)) continue;
      beaten.push_back(worse);
      said = p;
    }
    if (beaten.empty()) return "the others are worse than others";
    return "better than " + Listed(agent_, beaten) + ", says " + RuleOf(*said);
  }
  void KeepBest() {
    std::erase_if(left_, [&](Symbol candidate) {
      return std::none_of(others_.begin(), others_.end(), [&](const kernel::Preference* p) {
        return p->type == PreferenceType::kBest && p->value == candidate;
      });
    });
  }
  void DropWorst() {
    const std::vector<Symbol> before = left_;
    Drop([](const kernel::Preference& p, Symbol candidate) {
      return p.type == PreferenceType::kWorst && p.value == candidate;
    });
    if (left_.empty()) left_ = before;  // If all are worst nobody is.
  }

  std::string AmongIndifferent() const {
    double value = 0;
    bool is_numeric = false;
    for (const kernel::Preference* p : others_) {
      if (p->type != PreferenceType::kNumericIndifferent) continue;
      is_numeric = true;
      if (p->value == winner_) value += agent_.symbols().NumberValue(p->referent);
    }
    const std::string among = " of " + std::to_string(left_.size()) + " indifferent ones";
    switch (agent_.exploration().policy) {
      case kernel::ExplorationPolicy::kFirst:
        return "the one proposed last" + among;
      case kernel::ExplorationPolicy::kLast:
        return "the one proposed first" + among;
      case kernel::ExplorationPolicy::kBoltzmann:
      case kernel::ExplorationPolicy::kEpsilonGreedy:
      case kernel::ExplorationPolicy::kSoftmax:
        break;
    }
    if (!is_numeric) return "at random, one" + among;
    char number[32];
    std::snprintf(number, sizeof number, "%g", value);
    const bool is_greedy = agent_.exploration().policy == kernel::ExplorationPolicy::kEpsilonGreedy;
    return (is_greedy ? "mostly by value (its own: " : "at random by value (its own: ") + std::string(number) +
           "), one" + among;
  }

  const kernel::Agent& agent_;
  Symbol winner_;
  const kernel::Preference* proposal_ = nullptr;
  std::vector<Symbol> left_;
  std::vector<const kernel::Preference*> others_;
};

const kernel::Slot& OperatorSlot(const kernel::Agent& agent, kernel::GoalLevel level) {
  return agent.memory().slot(agent.goals().at(level).operator_slot);
}

}  // namespace

namespace {

/// What proposes the operator if nothing else is proposed and nothing requires it, which needs no contest; else null.
const kernel::Preference* OnlyProposal(const kernel::Agent& agent, const kernel::Slot& slot, Symbol winner) {
  const kernel::WorkingMemory& memory = agent.memory();
  const kernel::Preference* first = nullptr;
  for (kernel::PreferenceId p = slot.acceptable; p != kernel::PreferenceId::kNone;
       p = memory.preference(p).next_in_slot) {
    const kernel::Preference& preference = memory.preference(p);
    if (preference.value != winner) return nullptr;
    if (first == nullptr) first = &preference;
  }
  for (kernel::PreferenceId p = slot.others; p != kernel::PreferenceId::kNone; p = memory.preference(p).next_in_slot)
    if (memory.preference(p).type == PreferenceType::kRequire) return nullptr;
  return first;
}

}  // namespace

void AppendReasonOfOperator(const kernel::Agent& agent, const kernel::GoalInfo& goal, bool is_forced,
                            std::string& text) {
  if (goal.level == 0 || goal.level > agent.goals().depth()) return;
  const kernel::Slot& slot = OperatorSlot(agent, goal.level);
  const kernel::Preference* proposal = is_forced ? nullptr : OnlyProposal(agent, slot, goal.op);
  if (proposal != nullptr) {
    text += "the only one proposed";
  } else {
    Contest contest(agent, slot, goal.op);
    text += is_forced ? "forced by select (or foretold by predict)" : contest.Reason();
    proposal = contest.proposal();
  }
  if (proposal != nullptr) text.append("; proposed by ").append(agent.ProductionName(proposal->instantiation));
}

std::string ReasonOfState(const kernel::Agent& agent, const kernel::GoalInfo& goal) {
  if (goal.impasse == kernel::ImpasseType::kNone || goal.impasse == kernel::ImpasseType::kNoChange) return {};
  if (goal.level < 2 || goal.level > agent.goals().depth()) return {};
  std::vector<Symbol> candidates;
  const kernel::WorkingMemory& memory = agent.memory();
  for (kernel::PreferenceId p = OperatorSlot(agent, static_cast<kernel::GoalLevel>(goal.level - 1)).acceptable;
       p != kernel::PreferenceId::kNone; p = memory.preference(p).next_in_slot) {
    const Symbol value = memory.preference(p).value;
    if (std::find(candidates.begin(), candidates.end(), value) == candidates.end()) candidates.push_back(value);
  }
  std::reverse(candidates.begin(), candidates.end());  // The oldest proposal first.
  return "proposed are " + Listed(agent, candidates);
}

std::string_view RuleOfOutput(const kernel::Agent& agent, Symbol attribute, std::uint64_t timetag) {
  const kernel::WorkingMemory& memory = agent.memory();
  const kernel::SlotId slot = memory.FindSlot(agent.output().identifier(), attribute);
  if (slot == kernel::SlotId::kNone) return {};
  for (kernel::WmeId wme = memory.slot(slot).wmes; wme != kernel::WmeId::kNone; wme = memory.record(wme).next) {
    if (memory.wme(wme).timetag != timetag) continue;
    const kernel::PreferenceId preference = memory.record(wme).preference;
    if (preference == kernel::PreferenceId::kNone) return {};
    return agent.ProductionName(memory.preference(preference).instantiation);
  }
  return {};
}

}  // namespace soarbox
