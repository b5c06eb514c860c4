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

/// The first stage of learning: finds the results that a firing created for higher states.
class ResultCollector {
 public:
  /// The parts of the agent that it uses.
  struct Uses {
    WorkingMemory& memory;
    InstantiationTable& instantiations;
    const SymbolTable& symbols;
    Firing& firing;
  };
  explicit ResultCollector(const Uses& uses) : uses_(uses) {}

  /// Fills in `results` and `children` of a firing. Returns false if it created no result.
  bool Collect(InstantiationId firing, Explanation& out);
  /// In builds that check invariants: aborts if something reachable from the results is missing in them.
  void Check(const Explanation& explanation) const;
  void Clear() { seen_identifiers_.clear(); }

 private:
  void Add(PreferenceId preference, const Explanation::Child& from, Explanation& out);
  void AddPartsOf(Symbol id, InstantiationId base, const Explanation::Child& from, Explanation& out);

  Uses uses_;
  /// A task that remains: a preference to add, or an object whose preferences are to be added; and the result that led
  /// to it.
  struct Part {
    PreferenceId preference = PreferenceId::kNone;
    Symbol object;
    Explanation::Child from;
  };
  std::vector<Part> parts_;
  std::vector<std::uint32_t> seen_identifiers_;
};

}  // namespace soarbox::kernel
