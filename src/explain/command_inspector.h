// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <vector>

#include "explain/inspector.h"
#include "explain/learning_facts.h"
#include "explain/scene_source.h"

namespace soarbox::explain {

/// Inspects a mind of any kernel: sends commands of the Soar command language and parses their output.
class CommandInspector final : public Inspector, public LearningSource, public SceneSource {
 public:
  explicit CommandInspector(sml::Agent& agent) : agent_(agent) {}

  bool TellsAll() const override { return false; }
  MindFacts Mind() override;
  std::vector<StateFact> Stack() override;
  std::vector<ElementFact> ElementsOf(std::string_view id) override;
  std::vector<ElementFact> Search(std::string_view text, std::size_t most) override;
  std::optional<ElementFact> Element(std::uint64_t timetag) override;
  /// Always empty: commands do not report it.
  std::vector<MakerFact> MakersOf(std::uint64_t timetag) override;
  /// Always empty: commands do not report it.
  std::vector<TesterFact> TestersOf(std::uint64_t timetag) override;
  OperatorFacts Operators(std::string_view state) override;
  /// Returns names and numbers of firings. Adds the numbers of matches if there are at most 300 rules, because each
  /// number costs one command.
  std::vector<RuleFact> Rules() override;
  std::string RuleSource(std::string_view rule) override;
  /// Returns the conditions and how many partial matches reach each of them. Adds elements that have an attribute of
  /// the failing condition, at most 20 for each of its attributes.
  std::optional<MatchFacts> Match(std::string_view rule) override;
  std::vector<std::string> Complete(std::string_view line) override;
  /// Leaves NumberFact::when, `current` and `future` empty: commands do not report them.
  LearningFacts Learning() override;
  std::string SceneFacts() override;

 private:
  std::string Ask(const std::string& command);

  sml::Agent& agent_;
};

// Parsers of the output of commands. They are public for tests.

/// Parses elements such as "(12: S1 ^a b +)", also several in one line. Skips any other text.
std::vector<ElementFact> ReadElements(std::string_view text);
/// Parses the output of `print --stack`.
std::vector<StateFact> ReadStack(std::string_view text);
/// Parses the output of `preferences S1 operator --names`.
OperatorFacts ReadPreferences(std::string_view text);
/// Parses the output of `print --rl`: name, number of updates, value.
std::vector<NumberFact> ReadNumbers(std::string_view text);
/// Parses the output of `matches RULE`.
MatchFacts ReadMatches(std::string_view rule, std::string_view text);
/// Parses the output of `matches --assertions`. Returns whether it lists a match of the rule.
bool ReadIsPending(std::string_view rule, std::string_view text);
/// Parses the output of `preferences S1 operator --names --wmes`. Returns the time tags of the elements that the
/// preference depends on.
std::vector<std::uint64_t> ReadRestsOn(const PreferenceFact& preference, std::string_view text);

}  // namespace soarbox::explain
