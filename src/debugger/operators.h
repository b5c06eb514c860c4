// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "debugger/json.h"
#include "sim/inspector.h"

namespace soarbox::debugger {

/// One operator that preferences speak of.
struct OperatorRow {
  std::string id, name;  ///< The name may be empty.
  bool selected = false;
  bool proposed = false;              ///< Has an acceptable or require preference.
  std::string verdict;                ///< "selected", "rejected by rule x", "worse than seek (O2)", "could win", ...
  std::optional<double> value;        ///< Numeric, of those that could be chosen.
  std::optional<double> probability;  ///< 0 to 1.
  std::vector<sim::PreferenceFact> preferences;
};

/// Operators of one state, and why one of them won or none did.
struct OperatorsView {
  std::string state;
  std::string selected;  ///< Identifier; empty: none.
  std::string impasse;   ///< That this state led to: "tie", ...; empty if there is none.
  std::vector<OperatorRow> rows;
  std::string sentence;  ///< "seek (O2) won: rule prefer*seek makes it better than rest (O3)."
  std::string note;
};

/// An empty `state`: the lowest one with operators.
OperatorsView LookAtOperators(sim::Inspector& mind, std::string_view state = {});
/// Preferences of a state weighed, without a mind: for tests and other sources.
OperatorsView Weigh(const sim::OperatorFacts& facts);

/// "rule r makes it better than rest (O3)", in words.
std::string Describe(const sim::PreferenceFact& preference);

std::string ToText(const OperatorsView& view);
Json ToJson(const OperatorsView& view);

}  // namespace soarbox::debugger
