// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/learn/carried_tests.h"

#include <span>

#include "kernel/learn/justification.h"

namespace soarbox::kernel {

const std::vector<IdentityPlan::KeptTest>& CarriedTests::KeptTests(const Instantiation& instantiation) const {
  static const std::vector<IdentityPlan::KeptTest> none;
  if (instantiation.justification == Instantiation::kNoJustification) return none;
  return uses_.justifier.record(instantiation.justification).tests;
}

bool CarriedTests::IsKnownAbove(InstantiationId firing, Symbol symbol) const {
  return !symbol.IsIdentifier() || uses_.memory.level(symbol) < uses_.instantiations[firing].level;
}

void CarriedTests::Collect(const Explanation& explanation, std::vector<CarriedTest>& out) {
  out.clear();
  const WorkingMemory& memory = uses_.memory;
  for (const InstantiationId firing : explanation.firings) {
    if (!reader_.CarriesTests(firing)) continue;
    const std::span<const ConditionTrace> traces = uses_.instantiations.Trace(firing);
    for (std::size_t n = 0; n < traces.size(); ++n) {
      const Wme& wme = memory.wme(traces[n].wme);
      if (memory.known_identifier(wme.id).level < explanation.level) continue;
      const auto condition = static_cast<std::uint16_t>(n);
      for (const Field field : {Field::kId, Field::kAttribute, Field::kValue}) {
        ForEach(firing, condition, field, [&](const CarriedTest& carried) {
          CarriedTest& test = out.emplace_back(carried);
          test.tested = analysis_.OfField(firing, condition, field);
          test.value = FieldOf(wme, field);
        });
      }
    }
  }
}

}  // namespace soarbox::kernel
