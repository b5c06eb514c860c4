// SPDX-License-Identifier: BSD-2-Clause
#include "sml/server/decision_facts.h"

#include <algorithm>

#include "cli/object_printer.h"
#include "kernel/decide/exploration.h"
#include "mind/decision_codec.h"

namespace soarbox::server {
namespace {

using kernel::PreferenceType;
using mind::PreferenceKind;

/// Maximum number of preferences, and of drops, for which the decision is repeated to find out which drops were
/// decisive.
constexpr std::size_t kMostTried = 64, kMostDropsTried = 16;

PreferenceKind KindOf(PreferenceType type) {
  using enum PreferenceKind;
  static constexpr PreferenceKind kKinds[] = {kAcceptable,  kRequire, kReject, kProhibit, kBest, kWorst,
                                              kIndifferent, kNumeric, kEqual,  kBetter,   kWorse};
  return kKinds[static_cast<std::size_t>(type)];
}

// The enumerations of the kernel and of mind/ must have the same order.
static_assert(static_cast<int>(mind::Stage::kWorst) == static_cast<int>(kernel::DecisionStage::kWorst));
static_assert(static_cast<int>(mind::Policy::kLast) == static_cast<int>(kernel::ExplorationPolicy::kLast));

mind::Impasse ImpasseOf(kernel::ImpasseType impasse) {
  switch (impasse) {
    case kernel::ImpasseType::kTie:
      return mind::Impasse::kTie;
    case kernel::ImpasseType::kConflict:
      return mind::Impasse::kConflict;
    case kernel::ImpasseType::kConstraintFailure:
      return mind::Impasse::kConstraintFailure;
    case kernel::ImpasseType::kNone:
    case kernel::ImpasseType::kNoChange:
      break;
  }
  return mind::Impasse::kNone;
}

bool IsBinary(PreferenceType type) {
  return type == PreferenceType::kBetter || type == PreferenceType::kWorse ||
         type == PreferenceType::kBinaryIndifferent;
}

}  // namespace

std::string_view DecisionReader::Keep(std::string_view text) {
  if (used_ == texts_.size()) texts_.emplace_back();
  return texts_[used_++] = text;
}

std::uint32_t DecisionReader::PlaceOf(const kernel::Agent& agent, kernel::Symbol op) {
  std::uint32_t place = 0;
  while (place < operators_.size() && operators_[place] != op) ++place;
  if (place == operators_.size()) {
    operators_.push_back(op);
    const std::string_view id = Keep(IdentifierText(agent, op).view());
    decision_.operators.push_back({id, Keep(names_.NameOfOperator(agent, op))});
  }
  return place;
}

const mind::DecisionView::Operator* DecisionReader::Find(kernel::Symbol op) const {
  const auto found = std::ranges::find(operators_, op);
  return found == operators_.end() ? nullptr
                                   : &decision_.operators[static_cast<std::size_t>(found - operators_.begin())];
}

const mind::DecisionView& DecisionReader::Read(const kernel::Agent& agent, const kernel::DecisionReport& report) {
  decision_.Clear();
  operators_.clear();
  used_ = 0;
  decision_.impasse = ImpasseOf(report.impasse);
  decision_.policy = static_cast<mind::Policy>(agent.exploration().policy);
  decision_.is_forced = report.is_forced;
  for (const kernel::SlotPreference& from : report.preferences) {
    mind::DecisionView::Preference& to = decision_.preferences.emplace_back();
    to.kind = KindOf(from.type);
    to.op = PlaceOf(agent, from.value);
    if (IsBinary(from.type)) to.referent = PlaceOf(agent, from.referent);
    if (from.type == PreferenceType::kNumericIndifferent) to.number = from.number;
    to.rule = agent.ProductionName(agent.memory().preference(from.preference).instantiation);
  }
  if (report.selected) decision_.selected = PlaceOf(agent, report.selected);

  const kernel::DecisionTrace& trace = report.trace;
  decision_.by.assign(trace.by.begin(), trace.by.end());
  const bool is_tried = report.preferences.size() <= kMostTried && trace.drops.size() <= kMostDropsTried;
  for (const kernel::DecisionTrace::Drop& from : trace.drops) {
    mind::Decisive decisive = mind::Decisive::kUnknown;
    if (is_tried && from.count > 0) {
      decisive = kernel::IsDecisive(report.preferences, trace, from) ? mind::Decisive::kYes : mind::Decisive::kNo;
    }
    decision_.drops.push_back(
        {PlaceOf(agent, from.value), static_cast<mind::Stage>(from.stage), decisive, from.first, from.count});
  }

  const bool is_choice = report.impasse == kernel::ImpasseType::kNone;
  std::vector<double> chances;
  if (is_choice && report.candidates.size() > 1)
    chances = kernel::SelectionChances(report.candidates, agent.exploration());
  for (std::size_t i = 0; i < report.candidates.size(); ++i) {
    const kernel::Candidate& candidate = report.candidates[i];
    const double probability = !is_choice ? 0 : chances.empty() ? 1 : chances[i];
    decision_.left.push_back(
        {PlaceOf(agent, candidate.value), kernel::NumericValue(candidate, agent.exploration()), probability});
  }
  return decision_;
}

mind::Decision DecisionNow(const kernel::Agent& agent, std::string_view state) {
  for (kernel::GoalLevel level = 1; level <= agent.goals().depth(); ++level) {
    const kernel::Goal& goal = agent.goals().at(level);
    if (goal.operator_slot == kernel::SlotId::kNone || cli::SymbolText(agent, goal.id) != state) continue;
    DecisionReader reader;
    mind::Decision decision = mind::Owned(reader.Read(agent, agent.ExplainDecision(goal)));
    decision.has_changed = agent.OperatorOf(goal) && agent.memory().slot(goal.operator_slot).changed_since_selected;
    return decision;
  }
  return {};
}

}  // namespace soarbox::server
