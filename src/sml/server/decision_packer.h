// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/agent.h"
#include "kernel/decide/decision_trace.h"
#include "kernel/decide/exploration.h"
#include "sml/server/decision_facts.h"
#include "sml/server/printed_names.h"

namespace soarbox::server {

/// Packs the decisions of one agent (mind/decision_codec.h) quickly. Most decisions of an agent repeat an earlier one
/// except for the identifiers and names of operators. The packed bytes depend only on the preferences, their creators,
/// the selected operator, and the exploration policy. If these equal those of an earlier decision, its bytes are
/// reused. The bytes are the same as those of DecisionReader and Pack.
class DecisionPacker {
 public:
  struct Operator {
    std::string_view id, name;  ///< The name may be empty.
  };

  /// Valid until the next call.
  std::string_view Pack(const kernel::Agent& agent, const kernel::DecisionReport& report);
  /// The id and name of an operator in the last decision; empty if the decision does not contain it. Valid until the
  /// next Pack.
  Operator Find(kernel::Symbol op) const;

 private:
  static constexpr std::size_t kMostShapes = 8, kMostPreferences = 64;

  /// The common part of decisions that differ only in their operators, and the packed bytes for it.
  struct Shape {
    std::vector<std::uint64_t> key;
    std::string rules;       ///< Rules of the preferences, concatenated; their sizes are in the key.
    std::string head, tail;  ///< The packed bytes before and after the operators.
    /// One rule proposed the only operator, which was selected: the bytes depend only on that and the policy.
    bool is_alone = false;
    kernel::ExplorationPolicy policy = kernel::ExplorationPolicy::kSoftmax;
  };
  /// An operator of the last decision, with the positions of its id and name in bytes_.
  struct Mentioned {
    kernel::Symbol op;
    std::size_t id = 0, id_size = 0, name = 0, name_size = 0;
  };

  void ReadKey(const kernel::Agent& agent, const kernel::DecisionReport& report);
  std::uint64_t PlaceOf(kernel::Symbol op);
  const Shape* FindShape();
  const Shape* FindAlone(const kernel::Agent& agent, const kernel::DecisionReport& report);
  bool HasRules(const Shape& shape) const;
  std::string_view PackAs(const kernel::Agent& agent, const Shape& shape);
  std::string_view PackAnew(const kernel::Agent& agent, const kernel::DecisionReport& report, bool keep);

  DecisionReader reader_;
  PrintedNames names_;
  std::vector<Mentioned> operators_;  ///< By index.
  bool is_anew_ = false;              ///< The last decision was read by reader_, which then contains its operators.
  std::vector<std::uint64_t> key_;
  std::vector<std::string_view> rules_;
  std::vector<Shape> shapes_;
  std::size_t last_ = 0;  ///< The index of the last used shape.
  std::size_t next_ = 0;  ///< The index of the shape to be replaced next.
  std::string bytes_;     ///< Only grows; the last decision is at its beginning.
};

}  // namespace soarbox::server
