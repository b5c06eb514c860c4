// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/learn/explained_rule.h"

namespace soarbox::kernel {
namespace {

std::size_t BytesOfText(const std::string& text) {
  constexpr std::size_t kInPlace = 15;
  return text.size() <= kInPlace ? 0 : text.size() + 1;
}

std::size_t BytesOf(const ExplainedRule::Field& field) {
  return BytesOfText(field.text) + BytesOfText(field.identity) + BytesOfText(field.value);
}

std::size_t BytesOf(const std::vector<ExplainedRule::Condition>& conditions) {
  std::size_t bytes = conditions.size() * sizeof(ExplainedRule::Condition);
  for (const ExplainedRule::Condition& condition : conditions) {
    bytes += BytesOf(condition.id) + BytesOf(condition.attribute) + BytesOf(condition.value) +
             BytesOfText(condition.creator_rule) + condition.path.size() * sizeof(condition.path[0]) +
             condition.parts.size() * sizeof(condition.parts[0]);
    for (const ExplainedRule::Condition::Part& part : condition.parts) {
      bytes += BytesOfText(part.text) + BytesOfText(part.identity) + BytesOfText(part.value);
    }
  }
  return bytes;
}

std::size_t BytesOf(const std::vector<ExplainedRule::Action>& actions) {
  std::size_t bytes = actions.size() * sizeof(ExplainedRule::Action);
  for (const ExplainedRule::Action& action : actions) {
    bytes += BytesOf(action.id) + BytesOf(action.attribute) + BytesOf(action.value) + BytesOf(action.referent);
  }
  return bytes;
}

}  // namespace

std::size_t ExplainedRule::MemoryBytes() const {
  std::size_t bytes = sizeof(*this) + BytesOfText(name) + BytesOfText(op) + BytesOf(conditions) + BytesOf(actions) +
                      firings.size() * sizeof(Firing) + events.size() * sizeof(Event) +
                      constraints.size() * sizeof(Constraint) +
                      (other_results.size() + identities.size()) * sizeof(std::uint32_t);
  for (const Firing& firing : firings) {
    bytes += BytesOfText(firing.rule) + BytesOf(firing.conditions) + BytesOf(firing.actions) +
             firing.path.size() * sizeof(firing.path[0]);
  }
  for (const Event& event : events) bytes += BytesOfText(event.variable);
  for (const Constraint& constraint : constraints) bytes += BytesOfText(constraint.text);
  return bytes;
}

}  // namespace soarbox::kernel
