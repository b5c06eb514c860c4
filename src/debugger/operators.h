// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "debugger/json.h"
#include "explain/inspector.h"

namespace soarbox::debugger {

/// Why a candidate was dropped, as values.
struct DroppedBy {
  std::string stage;                ///< Of the decision procedure: "reject", "dominated", ...
  std::optional<bool> is_decisive;  ///< Without these rules the outcome would be another one; none: not tried.
  std::vector<std::string> rules;   ///< Each alone suffices; an empty name is the architecture.
};

/// One operator that preferences speak of.
struct OperatorRow {
  std::string id, name;  ///< The name may be empty.
  std::string about;     ///< "^waypoint north": what tells it from the others of its name; empty if the name does.
  bool selected = false;
  bool proposed = false;              ///< Has an acceptable or require preference.
  std::string verdict;                ///< "selected", "rule x rejects it", "could win", ...
  std::optional<DroppedBy> dropped;   ///< By the decision procedure.
  std::optional<double> value;        ///< Numeric, of those that could be chosen.
  std::optional<double> probability;  ///< 0 to 1.
  std::vector<explain::PreferenceFact> preferences;
};

/// Operators of one state, and why one of them won or none did.
struct OperatorsView {
  std::string state;
  std::string selected;  ///< Identifier; empty: none.
  std::string impasse;   ///< That this state led to: "tie", ...; empty if there is none.
  std::vector<OperatorRow> rows;
  std::string sentence;  ///< "seek (O2) was selected: rule prefer*seek makes it better than rest (O3)."
  std::string note;
};

/// An empty `state`: the lowest one with operators.
OperatorsView LookAtOperators(explain::Inspector& mind, std::string_view state = {});
/// Facts of a state as a view. What the decision procedure said is told; where it is missing, nothing takes its place.
OperatorsView View(const explain::OperatorFacts& facts);

/// "move-to (O1) ^waypoint north".
std::string Title(const OperatorRow& row);
/// "rule r makes it better than rest (O3)", in words.
std::string Describe(const explain::PreferenceFact& preference);

std::string ToText(const OperatorsView& view);
Json ToJson(const OperatorsView& view);

}  // namespace soarbox::debugger
