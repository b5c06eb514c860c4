// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string_view>

#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"
#include "kernel/observer.h"

namespace soarbox::kernel {

struct Goal;
class InstantiationTable;
class Rete;
class WorkingMemory;

/// Provides the names of justifications, which are not rules of the match.
class JustificationNames {
 public:
  virtual ~JustificationNames() = default;
  /// `index`: Instantiation::justification.
  virtual std::string_view Name(std::uint32_t index) const = 0;
};

/// Descriptions of elements, goals and firings for observers and explanations: values instead of handles.
class Descriptions {
 public:
  struct Uses {
    const WorkingMemory& memory;
    const InstantiationTable& instantiations;
    const Rete& rete;
    const JustificationNames& justifications;
  };
  explicit Descriptions(const Uses& uses) : uses_(uses) {}

  [[gnu::noinline]] WmeInfo Describe(WmeId wme) const;
  [[gnu::noinline]] GoalInfo Describe(const Goal& goal) const;
  [[gnu::noinline]] FiringInfo DescribeInstantiation(InstantiationId id) const;
  static constexpr std::string_view kNoRule = "|Memory System Recall|";  ///< The name shown for the architecture.
  /// The name of the rule or justification that fired; kNoRule for the architecture.
  std::string_view ProductionName(InstantiationId id) const;
  /// The operator selected in a goal, or none.
  Symbol OperatorOf(const Goal& goal) const;

 private:
  Uses uses_;
};

}  // namespace soarbox::kernel
