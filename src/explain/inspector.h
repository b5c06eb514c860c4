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
#include "mind/facts.h"
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

/// Where an inspector has the origins of elements from.
struct OriginSource {
  std::function<mind::OriginFacts(std::uint64_t timetag)> ask;  ///< Empty: none are noted.
  DecisionTime time;  ///< When decisions were made, for texts about origins. Empty: not known.

  /// What made an element, as the kernel noted it then (mind/origin.h). Nothing is noted by an official kernel.
  mind::OriginFacts Of(std::uint64_t timetag) const { return ask ? ask(timetag) : mind::OriginFacts(); }
};

/// Looks into one agent's mind between two ticks: facts as plain values that belong to the caller. It only reads: no
/// run differs because somebody looked. Made by Simulation::Inspect; valid until the simulation's next tick.
///
/// Our own kernel in this process reports everything. Others are asked in the Soar command language: what that does not
/// report stays empty (TellsAll).
class Inspector {
 public:
  virtual ~Inspector() = default;

  virtual bool TellsAll() const = 0;
  virtual MindFacts Mind() = 0;
  /// From the top state down.
  virtual std::vector<StateFact> Stack() = 0;
  /// Elements of an identifier, by attribute; empty if there is no such identifier.
  virtual std::vector<ElementFact> ElementsOf(std::string_view id) = 0;
  /// Elements with this text in their attribute or value or as their identifier, by time tag; no more than `most`.
  virtual std::vector<ElementFact> Search(std::string_view text, std::size_t most) = 0;
  virtual std::optional<ElementFact> Element(std::uint64_t timetag) = 0;
  virtual std::vector<MakerFact> MakersOf(std::uint64_t timetag) = 0;
  virtual std::vector<TesterFact> TestersOf(std::uint64_t timetag) = 0;
  virtual OperatorFacts Operators(std::string_view state) = 0;
  /// In the order of loading.
  virtual std::vector<RuleFact> Rules() = 0;
  /// As `print` shows it; empty if there is none of this name.
  virtual std::string RuleSource(std::string_view rule) = 0;
  virtual std::optional<MatchFacts> Match(std::string_view rule) = 0;
  /// How the last word of a command line may go on.
  virtual std::vector<std::string> Complete(std::string_view line) = 0;

  /// What made elements, as the kernel noted it then.
  OriginSource origins;
};

/// For an agent of any kernel; the agent must live longer.
std::unique_ptr<Inspector> MakeInspector(sml::Agent& agent);

}  // namespace soarbox::explain
