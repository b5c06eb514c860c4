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
#include "mind/facts.h"
#include "mind/origin.h"
#include "mind/rule_facts.h"

namespace sml {
class Agent;
}

namespace soarbox {

/// Looks into the mind of a client's agent between its runs. What Soarbox's own kernel tells besides the client API:
/// values, not texts to be taken apart. Reads only; what it returns belongs to the caller. Used on the thread that runs
/// the agent, never in the middle of its cycle. Must end before the agent does.
class EXPORT MindInspection {
 public:
  virtual ~MindInspection() = default;

  virtual mind::MindFacts Mind() = 0;
  virtual std::vector<mind::StateFact> Stack() = 0;
  /// Elements of an identifier, by attribute; empty if there is no such identifier.
  virtual std::vector<mind::ElementFact> ElementsOf(std::string_view id) = 0;
  /// Elements with this text in their attribute or value or as their identifier, by time tag; no more than `most`.
  virtual std::vector<mind::ElementFact> Search(std::string_view text, std::size_t most) = 0;
  virtual std::optional<mind::ElementFact> Element(std::uint64_t timetag) = 0;
  virtual std::vector<mind::MakerFact> MakersOf(std::uint64_t timetag) = 0;
  virtual std::vector<mind::TesterFact> TestersOf(std::uint64_t timetag) = 0;
  /// Empty texts if there is no such state.
  virtual mind::OperatorFacts Operators(std::string_view state) = 0;
  /// In the order of loading.
  virtual std::vector<mind::RuleFact> Rules() = 0;
  /// As `print` shows it; empty if there is none of this name.
  virtual std::string RuleSource(std::string_view rule) = 0;
  virtual std::optional<mind::MatchFacts> Match(std::string_view rule) = 0;
  virtual mind::LearningFacts Learning() = 0;
  /// How rules were learned while somebody observed the mind (soarbox_Observation.h): the last 1,000, in their order,
  /// or that of this rule alone. `whole`: with conditions, actions and firings.
  virtual std::vector<mind::LessonFact> Lessons(bool whole, std::string_view rule) = 0;
  /// Known objects with this text in their number or augmentations, no more than `most`.
  virtual mind::LongTermFacts LongTerm(std::size_t most, std::string_view text) = 0;
  /// The contents of an episode, objects before what hangs on them; empty if there is no such episode.
  virtual std::vector<mind::RememberedFact> Episode(std::size_t number) = 0;
  /// How the word that a command line ends with may go on.
  virtual std::vector<std::string> Complete(std::string_view line) = 0;
};

/// Null if the agent's kernel is in another process: then only the client API tells what there is.
std::unique_ptr<MindInspection> EXPORT InspectMind(sml::Agent& agent);

/// What the rules say, in the order of loading, without justifications. None if the agent's kernel is in another
/// process.
std::optional<std::vector<mind::RuleFacts>> EXPORT AskRuleContents(sml::Agent& agent);

/// What the decision procedure says of a state's operators now; also of an agent whose kernel is in another process, if
/// that is Soarbox's own. None if it is not. Empty if there is no such state, or no preference.
std::optional<mind::Decision> EXPORT AskDecision(sml::Agent& agent, std::string_view state);

/// Lets the kernel note what makes elements and who proposes operators, from now on (mind/origin.h). False if it is not
/// Soarbox's own. An agent runs the same with it.
bool EXPORT NoteOrigins(sml::Agent& agent);

/// What made an element, as it was then, by time tag; also of an agent whose kernel is in another process, if that is
/// Soarbox's own. Elements that have gone are known only if they were commands, the last 8.
mind::OriginFacts EXPORT AskOrigin(sml::Agent& agent, std::uint64_t timetag);
/// The same for the newest command of this name.
mind::OriginFacts EXPORT AskCommandOrigin(sml::Agent& agent, std::string_view command);

}  // namespace soarbox
