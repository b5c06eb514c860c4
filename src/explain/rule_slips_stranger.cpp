// SPDX-License-Identifier: BSD-2-Clause
// Rules that were written for another world.
#include <algorithm>

#include "explain/rule_slips.h"
#include "vocabulary/vocabulary.h"

namespace soarbox::explain {
namespace {

/// Rules are for another world if they test at least kLeastForeign percepts that this world does not have. These must
/// also be at least kForeignPerOurs times as many as the percepts of this world that the rules test.
constexpr std::size_t kLeastForeign = 3, kForeignPerOurs = 4;
constexpr std::size_t kMostNamed = 6;

}  // namespace

std::optional<Slip> FindOtherWorld(const std::vector<RuleText>& rules, const KnownWords& known) {
  if (known.own_world || !known.complete || known.has_database) return std::nullopt;
  std::vector<std::string> foreign;
  std::set<std::string> ours;
  const RuleText* first = nullptr;
  for (const RuleText& rule : rules) {
    for (const RuleAttribute& condition : rule.conditions) {
      const auto path = rule.paths.find(condition.id);
      const bool is_percept = path != rule.paths.end() && path->second.size() > 1 && path->second[0] == "io" &&
                              path->second[1] == "input-link";
      if (!is_percept || condition.attribute.find_first_of(" <>{}") != std::string::npos) continue;
      if (vocabulary::IsPerceptAttribute(condition.attribute)) {
        ours.insert(condition.attribute);
      } else if (!known.attributes.contains(condition.attribute) && !known.scripts.contains(condition.attribute) &&
                 std::ranges::find(foreign, condition.attribute) == foreign.end()) {
        foreign.push_back(condition.attribute);
        if (first == nullptr) first = &rule;
      }
    }
  }
  if (foreign.size() < kLeastForeign || ours.size() * kForeignPerOurs > foreign.size()) return std::nullopt;
  std::string names;
  for (std::size_t i = 0; i < foreign.size() && i < kMostNamed; ++i) names += (i == 0 ? "^" : ", ^") + foreign[i];
  if (foreign.size() > kMostNamed) names += " and " + std::to_string(foreign.size() - kMostNamed) + " more";
  return Slip{
      first->name, foreign.front(), true,
      "these rules seem to be written for another world: nothing here makes the percepts " + names,
      "docs/percepts.md lists what agents perceive here; a world whose script makes percepts of its own says so "
      "with by = \"sandbox\" (docs/scenarios.md), and its rules are not compared with ours"};
}

}  // namespace soarbox::explain
