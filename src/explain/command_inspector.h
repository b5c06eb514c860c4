// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <vector>

#include "explain/inspector.h"
#include "explain/learning_facts.h"
#include "explain/scene_source.h"

namespace soarbox::explain {

/// Asks a mind in the Soar command language, whatever kernel it lives in, and reads what that prints.
class CommandInspector final : public Inspector, public LearningSource, public SceneSource {
 public:
  explicit CommandInspector(sml::Agent& agent) : agent_(agent) {}

  bool TellsAll() const override { return false; }
  MindFacts Mind() override;
  std::vector<StateFact> Stack() override;
  std::vector<ElementFact> ElementsOf(std::string_view id) override;
  std::vector<ElementFact> Search(std::string_view text, std::size_t most) override;
  std::optional<ElementFact> Element(std::uint64_t timetag) override;
  /// Not reported.
  std::vector<MakerFact> MakersOf(std::uint64_t timetag) override;
  /// Not reported.
  std::vector<TesterFact> TestersOf(std::uint64_t timetag) override;
  OperatorFacts Operators(std::string_view state) override;
  /// Names and firings.
  std::vector<RuleFact> Rules() override;
  std::string RuleSource(std::string_view rule) override;
  /// Conditions and how many pass them.
  std::optional<MatchFacts> Match(std::string_view rule) override;
  std::vector<std::string> Complete(std::string_view line) override;
  /// Without the parts of the numbers.
  LearningFacts Learning() override;
  std::string SceneFacts() override;

 private:
  std::string Ask(const std::string& command);

  sml::Agent& agent_;
};

// Readers of what the commands print. For tests too.

/// "(12: S1 ^a b +)", also several in a line; other text is skipped.
std::vector<ElementFact> ReadElements(std::string_view text);
/// `print --stack`.
std::vector<StateFact> ReadStack(std::string_view text);
/// `preferences S1 operator --names`.
OperatorFacts ReadPreferences(std::string_view text);
/// `print --rl`: name, updates, number.
std::vector<NumberFact> ReadNumbers(std::string_view text);
/// `matches RULE`.
MatchFacts ReadMatches(std::string_view rule, std::string_view text);
/// `matches --assertions`: whether a match of the rule is in the list.
bool ReadIsPending(std::string_view rule, std::string_view text);
/// `preferences S1 operator --names --wmes`: the time tags of the elements that a preference rests on.
std::vector<std::uint64_t> ReadRestsOn(const PreferenceFact& preference, std::string_view text);

}  // namespace soarbox::explain
