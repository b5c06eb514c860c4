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

/// Packs what the decision procedure says of one agent (mind/decision_codec.h), quickly: an agent decides in the same
/// few ways again and again, and all but its operators' identifiers and names is as it was then. What a decision says
/// follows from its preferences, who made them, what was selected, and how one of several is selected; where these are
/// those of an earlier decision, its bytes serve again. They are the same bytes that DecisionReader and Pack make.
class DecisionPacker {
 public:
  struct Operator {
    std::string_view id, name;  ///< The name may be empty.
  };

  /// Valid until the next call.
  std::string_view Pack(const kernel::Agent& agent, const kernel::DecisionReport& report);
  /// How the last decision names an operator; empty if it does not mention it. Valid until the next Pack.
  Operator Find(kernel::Symbol op) const;

 private:
  static constexpr std::size_t kMostShapes = 8, kMostPreferences = 64;

  /// What decisions have in common that differ in their operators only, and the bytes that follow from it.
  struct Shape {
    std::vector<std::uint64_t> key;
    std::string rules;       ///< Of the preferences, one after the other; their sizes are in the key.
    std::string head, tail;  ///< What is packed before and after the operators.
    /// One operator was proposed, by one rule, and selected; that and the policy is all that the bytes follow from.
    bool is_alone = false;
    kernel::ExplorationPolicy policy = kernel::ExplorationPolicy::kSoftmax;
  };
  /// An operator of the last decision, and where its id and its name are in bytes_.
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
  std::vector<Mentioned> operators_;  ///< By place.
  bool is_anew_ = false;              ///< The last decision was read by reader_, which knows its operators.
  std::vector<std::uint64_t> key_;
  std::vector<std::string_view> rules_;
  std::vector<Shape> shapes_;
  std::size_t last_ = 0;  ///< The shape of the last decision that had one.
  std::size_t next_ = 0;  ///< The shape to give up next.
  std::string bytes_;     ///< Only grows: of the last decision are the first.
};

}  // namespace soarbox::server
