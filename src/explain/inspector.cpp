// SPDX-License-Identifier: BSD-2-Clause
#include "explain/inspector.h"

#include <utility>

#include "explain/command_inspector.h"
#include "explain/learning_facts.h"
#include "explain/memory_facts.h"
#include "explain/scene_source.h"
#include "sml_Client.h"
#ifdef SOARBOX_OWN_KERNEL
#include "soarbox_Inspection.h"
#endif

namespace soarbox::explain {

#ifdef SOARBOX_OWN_KERNEL

namespace {

class OwnInspector final : public Inspector, public LearningSource, public LongTermSource, public SceneSource {
 public:
  OwnInspector(std::unique_ptr<MindInspection> mind, sml::Agent& agent) : mind_(std::move(mind)), agent_(agent) {}

  bool TellsAll() const override { return true; }

  MindFacts Mind() override { return mind_->Mind(); }
  std::vector<StateFact> Stack() override { return mind_->Stack(); }
  std::vector<ElementFact> ElementsOf(std::string_view id) override { return mind_->ElementsOf(id); }
  std::vector<ElementFact> Search(std::string_view text, std::size_t most) override {
    return mind_->Search(text, most);
  }
  std::optional<ElementFact> Element(std::uint64_t timetag) override { return mind_->Element(timetag); }
  std::vector<MakerFact> MakersOf(std::uint64_t timetag) override { return mind_->MakersOf(timetag); }
  std::vector<TesterFact> TestersOf(std::uint64_t timetag) override { return mind_->TestersOf(timetag); }
  OperatorFacts Operators(std::string_view state) override { return mind_->Operators(state); }
  std::vector<RuleFact> Rules() override { return mind_->Rules(); }
  std::string RuleSource(std::string_view rule) override { return mind_->RuleSource(rule); }
  std::optional<MatchFacts> Match(std::string_view rule) override { return mind_->Match(rule); }
  std::vector<std::string> Complete(std::string_view line) override { return mind_->Complete(line); }

  LearningFacts Learning() override { return mind_->Learning(); }
  std::vector<LearnedRuleFact> LearnedRules() override { return mind_->LearnedRules(false, {}); }
  std::optional<LearnedRuleFact> LearnedRule(std::string_view rule) override {
    std::vector<LearnedRuleFact> found = mind_->LearnedRules(true, rule);
    if (rule.empty() || found.empty()) return std::nullopt;
    return std::move(found.back());
  }

  LongTermFacts LongTerm(std::size_t most, const std::string& text) override { return mind_->LongTerm(most, text); }
  std::vector<RememberedFact> Episode(std::size_t number) override { return mind_->Episode(number); }
  std::string SceneFacts() override { return agent_.ExecuteCommandLine("svs facts"); }

 private:
  std::unique_ptr<MindInspection> mind_;
  sml::Agent& agent_;
};

}  // namespace

std::unique_ptr<Inspector> MakeInspector(sml::Agent& agent) {
  std::unique_ptr<Inspector> inspector;
  if (std::unique_ptr<MindInspection> mind = InspectMind(agent)) {
    inspector = std::make_unique<OwnInspector>(std::move(mind), agent);
  } else {
    inspector = std::make_unique<CommandInspector>(agent);
  }
  inspector->origins.ask = [&agent](std::uint64_t timetag) { return AskOrigin(agent, timetag); };
  return inspector;
}

#else

std::unique_ptr<Inspector> MakeInspector(sml::Agent& agent) {
  return std::make_unique<CommandInspector>(agent);
}

#endif

}  // namespace soarbox::explain
