// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "Export.h"
#include "mind/inspection_facts.h"
#include "mind/origin.h"
#include "mind/rule_facts.h"

namespace sml {
class Agent;
}

namespace soarbox {

/// Reads the mind of a client's agent between its runs. Provides the data that only Soarbox's kernel has, as values
/// instead of text. Read-only; the caller owns the results. Must be used on the thread that runs the agent, never
/// during a decision cycle, and must be destroyed before the agent.
class EXPORT MindInspection {
 public:
  virtual ~MindInspection() = default;

  virtual mind::MindFacts Mind() = 0;
  virtual std::vector<mind::StateFact> Stack() = 0;
  /// The elements of an identifier, sorted by attribute; empty if there is no such identifier.
  virtual std::vector<mind::ElementFact> ElementsOf(std::string_view id) = 0;
  /// At most `most` elements whose identifier, attribute or value contains this text, sorted by time tag.
  virtual std::vector<mind::ElementFact> Search(std::string_view text, std::size_t most) = 0;
  virtual std::optional<mind::ElementFact> Element(std::uint64_t timetag) = 0;
  virtual std::vector<mind::MakerFact> MakersOf(std::uint64_t timetag) = 0;
  virtual std::vector<mind::TesterFact> TestersOf(std::uint64_t timetag) = 0;
  /// The texts are empty if there is no such state.
  virtual mind::OperatorFacts Operators(std::string_view state) = 0;
  /// In the order of loading.
  virtual std::vector<mind::RuleFact> Rules() = 0;
  /// The rule as `print` shows it; empty if there is none of this name.
  virtual std::string RuleSource(std::string_view rule) = 0;
  virtual std::optional<mind::MatchFacts> Match(std::string_view rule) = 0;
  virtual mind::LearningFacts Learning() = 0;
  /// How rules were learned while the mind was observed (soarbox_Observation.h): the last 1,000 in order, or only
  /// `rule`. `whole`: include conditions, actions and firings.
  virtual std::vector<mind::LearnedRuleFact> LearnedRules(bool whole, std::string_view rule) = 0;
  /// At most `most` objects of semantic memory whose number or augmentations contain this text.
  virtual mind::LongTermFacts LongTerm(std::size_t most, std::string_view text) = 0;
  /// The contents of an episode, parents before children; empty if there is no such episode.
  virtual std::vector<mind::RememberedFact> Episode(std::size_t number) = 0;
  /// The possible completions of the last word of a command line.
  virtual std::vector<std::string> Complete(std::string_view line) = 0;
};

/// Returns null if the agent's kernel is in another process: only the client API is available then.
std::unique_ptr<MindInspection> EXPORT InspectMind(sml::Agent& agent);

/// The contents of the rules in the order of loading, without justifications. None if the agent's kernel is in another
/// process.
std::optional<std::vector<mind::RuleFacts>> EXPORT AskRuleContents(sml::Agent& agent);

/// The current decision on a state's operators. Also works for a kernel of Soarbox in another process; none for other
/// kernels. Empty if there is no such state or no preference.
std::optional<mind::Decision> EXPORT AskDecision(sml::Agent& agent, std::string_view state);

/// Makes the kernel record, from now on, what creates elements and which rules propose operators (mind/origin.h).
/// Returns false if the kernel is not Soarbox's. Recording does not change the behaviour of the agent.
bool EXPORT NoteOrigins(sml::Agent& agent);

/// The origin of an element, by time tag: the rule and the elements that created it. Also works for a kernel of Soarbox
/// in another process. Of removed elements, only the last 8 commands are available.
mind::OriginFacts EXPORT AskOrigin(sml::Agent& agent, std::uint64_t timetag);
/// The origin of the newest command of this name.
mind::OriginFacts EXPORT AskCommandOrigin(sml::Agent& agent, std::string_view command);

}  // namespace soarbox
