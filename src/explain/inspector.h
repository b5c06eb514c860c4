// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "explain/origin_tree.h"
#include "mind/inspection_facts.h"
#include "mind/origin.h"

namespace sml {
class Agent;
}

namespace soarbox::explain {

using mind::CandidateFact;
using mind::ConditionFact;
using mind::ElementFact;
using mind::MakerFact;
using mind::MatchFacts;
using mind::MindFacts;
using mind::OperatorFacts;
using mind::PreferenceFact;
using mind::RuleFact;
using mind::StateFact;
using mind::TesterFact;

/// Provides the origins of elements to an inspector.
struct OriginSource {
  std::function<mind::OriginFacts(std::uint64_t timetag)> ask;  ///< Empty if no origins are recorded.
  DecisionTime time;  ///< Converts decisions to simulated time, for texts about origins. Empty if that is not known.

  /// Returns what made an element, as the kernel recorded it at that time (mind/origin.h). An official kernel records
  /// nothing.
  mind::OriginFacts Of(std::uint64_t timetag) const { return ask ? ask(timetag) : mind::OriginFacts(); }
};

/// Reads one agent's mind between two ticks. Returns copies, which belong to the caller. It changes nothing: an
/// inspected run is the same as any other. Created by Simulation::Inspect; valid until the simulation's next tick.
///
/// Our own kernel in this process reports all data. Any other kernel is asked in the Soar command language. Data that
/// its commands do not print stay empty; TellsAll() is false then.
class Inspector {
 public:
  virtual ~Inspector() = default;

  /// Whether all data are reported. If not, empty data may mean "not known".
  virtual bool TellsAll() const = 0;
  virtual MindFacts Mind() = 0;
  /// From the top state down.
  virtual std::vector<StateFact> Stack() = 0;
  /// Returns the elements of an identifier, sorted by attribute. Empty if there is no such identifier.
  virtual std::vector<ElementFact> ElementsOf(std::string_view id) = 0;
  /// Returns the elements that contain `text` in their attribute or value or have it as their identifier. Sorted by
  /// time tag; at most `most` elements.
  virtual std::vector<ElementFact> Search(std::string_view text, std::size_t most) = 0;
  virtual std::optional<ElementFact> Element(std::uint64_t timetag) = 0;
  virtual std::vector<MakerFact> MakersOf(std::uint64_t timetag) = 0;
  virtual std::vector<TesterFact> TestersOf(std::uint64_t timetag) = 0;
  virtual OperatorFacts Operators(std::string_view state) = 0;
  /// In the order of loading.
  virtual std::vector<RuleFact> Rules() = 0;
  /// Returns the rule as `print` shows it. Empty if there is no rule of this name.
  virtual std::string RuleSource(std::string_view rule) = 0;
  virtual std::optional<MatchFacts> Match(std::string_view rule) = 0;
  /// Returns the possible completions of the last word of a command line.
  virtual std::vector<std::string> Complete(std::string_view line) = 0;

  /// What made the elements, as the kernel recorded it at that time.
  OriginSource origins;
};

/// Creates an inspector for an agent of any kernel. The agent must outlive it.
std::unique_ptr<Inspector> MakeInspector(sml::Agent& agent);

}  // namespace soarbox::explain
