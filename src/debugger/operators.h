// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "explain/inspector.h"

namespace soarbox::debugger {

/// Why a candidate was dropped.
struct DroppedBy {
  std::string stage;                ///< The stage of the decision procedure: "reject", "dominated", ...
  std::optional<bool> is_decisive;  ///< Whether the outcome would be different without these rules; nothing if that was
                                    ///< not tested.
  std::vector<std::string> rules;   ///< The rules that dropped it. Each of them is sufficient. An empty name means the
                                    ///< architecture.
};

/// One operator that at least one preference mentions.
struct OperatorRow {
  std::string id, name;  ///< The name may be empty.
  std::string about;     ///< "^waypoint north": the attributes that distinguish it from others of the same name; empty
                         ///< if the name is unique.
  bool selected = false;
  bool proposed = false;              ///< It has an acceptable or require preference.
  std::string verdict;                ///< "selected", "rule x rejects it", "could win", ...
  std::optional<DroppedBy> dropped;   ///< How the decision procedure dropped it, if it did.
  std::optional<double> value;        ///< Its numeric value, if it could be chosen.
  std::optional<double> probability;  ///< 0 to 1.
  std::vector<explain::PreferenceFact> preferences;
};

/// The operators of one state, and why one of them or none was selected.
struct OperatorsView {
  std::string state;
  std::string selected;  ///< Its identifier; empty if none is selected.
  std::string impasse;   ///< The impasse of this state: "tie", ...; empty if there is none.
  std::vector<OperatorRow> rows;
  std::string sentence;  ///< "seek (O2) was selected: rule prefer*seek makes it better than rest (O3)."
  std::string note;
};

/// An empty `state` means the lowest state with operators.
OperatorsView LookAtOperators(explain::Inspector& mind, std::string_view state = {});
/// Converts the operators of a state to a view. It shows the recorded decision. If there is none, it shows no reason.
OperatorsView View(const explain::OperatorFacts& facts);

/// "move-to (O1) ^waypoint north".
std::string Title(const OperatorRow& row);
/// Describes a preference: "rule r makes it better than rest (O3)".
std::string Describe(const explain::PreferenceFact& preference);

std::string ToText(const OperatorsView& view);

}  // namespace soarbox::debugger
