// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "kernel/learn/explanation.h"

namespace soarbox::kernel {

class Firing;
class InstantiationTable;
class SymbolTable;
class WorkingMemory;

/// The first stage of learning: what a firing gave to higher states.
class ResultCollector {
 public:
  /// What it uses of the agent.
  struct Uses {
    WorkingMemory& memory;
    InstantiationTable& instantiations;
    const SymbolTable& symbols;
    Firing& firing;
  };
  explicit ResultCollector(const Uses& uses) : uses_(uses) {}

  /// Fills in `results` and `children` of a firing; false if it gave nothing to a higher state.
  bool Collect(InstantiationId firing, Explanation& out);
  /// In builds that check themselves: aborts if something that the results reach is not one of them.
  void Check(const Explanation& explanation) const;
  void Clear() { seen_identifiers_.clear(); }

 private:
  void Add(PreferenceId preference, const Explanation::Child& from, Explanation& out);
  void AddPartsOf(Symbol id, InstantiationId base, const Explanation::Child& from, Explanation& out);

  Uses uses_;
  /// Still to be added: a preference, or else all that is said of an object; and the result that led there.
  struct Part {
    PreferenceId preference = PreferenceId::kNone;
    Symbol object;
    Explanation::Child from;
  };
  std::vector<Part> parts_;
  std::vector<std::uint32_t> seen_identifiers_;
};

}  // namespace soarbox::kernel
