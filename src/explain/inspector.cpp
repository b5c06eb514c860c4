// SPDX-License-Identifier: BSD-2-Clause
#include "explain/inspector.h"

#include <utility>

#include "explain/command_inspector.h"
#include "explain/learning_facts.h"
#include "explain/memory_facts.h"
#include "sml_Client.h"
#ifdef SOARBOX_OWN_KERNEL
#include "soarbox_Inspection.h"
#endif

namespace soarbox::explain {

#ifdef SOARBOX_OWN_KERNEL

namespace {

ElementFact Fact(InspectedElement from);
MakerFact Fact(InspectedMaker from);
TesterFact Fact(InspectedTester from);
StateFact Fact(InspectedState from);
PreferenceFact Fact(InspectedPreference from);
CandidateFact Fact(InspectedCandidate from);
RuleFact Fact(InspectedRule from);
ConditionFact Fact(InspectedCondition from);
TripleFact Fact(InspectedTriple from);
FiringFact Fact(InspectedFiring from);
LessonFact Fact(InspectedLesson from);

ElementFact Fact(InspectedElement from) {
  return {from.timetag,          std::move(from.id), std::move(from.attribute),
          std::move(from.value), from.acceptable,    from.is_object};
}

template <typename To, typename From>
std::vector<To> Facts(std::vector<From> from) {
  std::vector<To> to;
  to.reserve(from.size());
  for (From& one : from) to.push_back(Fact(std::move(one)));
  return to;
}

std::vector<std::vector<ElementFact>> Matches(std::vector<std::vector<InspectedElement>> from) {
  std::vector<std::vector<ElementFact>> to;
  for (std::vector<InspectedElement>& match : from) to.push_back(Facts<ElementFact>(std::move(match)));
  return to;
}

MakerFact Fact(InspectedMaker from) {
  MakerFact to;
  to.kind = static_cast<MakerFact::Kind>(from.kind);
  to.rule = std::move(from.rule);
  to.o_supported = from.o_supported;
  to.level = from.level;
  to.elements = Facts<ElementFact>(std::move(from.elements));
  return to;
}

TesterFact Fact(InspectedTester from) {
  return {std::move(from.rule), from.condition, from.negated, from.matches};
}

StateFact Fact(InspectedState from) {
  return {from.level,
          std::move(from.id),
          std::move(from.impasse),
          std::move(from.attribute),
          std::move(from.operator_id),
          std::move(from.operator_name)};
}

PreferenceFact Fact(InspectedPreference from) {
  return {std::move(from.type),     std::move(from.sign),       std::move(from.value),      std::move(from.name),
          std::move(from.referent), std::move(from.other_name), Fact(std::move(from.maker))};
}

CandidateFact Fact(InspectedCandidate from) {
  return {std::move(from.id), std::move(from.name), from.value, from.probability};
}

RuleFact Fact(InspectedRule from) {
  return {std::move(from.name),          std::move(from.type), std::move(from.file), from.line,
          std::move(from.documentation), from.firings,         from.matches,         from.breaks};
}

ConditionFact Fact(InspectedCondition from) {
  return {std::move(from.text), from.negated, from.partial_matches};
}

TripleFact Fact(InspectedTriple from) {
  return {std::move(from.id),   std::move(from.attribute), std::move(from.value), std::move(from.referent),
          std::move(from.sign), std::move(from.met),       from.negated,          from.above,
          from.creator,         std::move(from.path)};
}

FiringFact Fact(InspectedFiring from) {
  return {from.serial,
          std::move(from.rule),
          from.level,
          from.made_result,
          Facts<TripleFact>(std::move(from.conditions)),
          Facts<TripleFact>(std::move(from.actions))};
}

LessonFact Fact(InspectedLesson from) {
  LessonFact to;
  to.rule = std::move(from.rule);
  to.decision = from.decision;
  to.level = from.level;
  to.state = std::move(from.state);
  to.superstate = std::move(from.superstate);
  to.impasse = std::move(from.impasse);
  to.attribute = std::move(from.attribute);
  to.operator_name = std::move(from.operator_name);
  to.base = from.base;
  to.conditions = Facts<TripleFact>(std::move(from.conditions));
  to.actions = Facts<TripleFact>(std::move(from.actions));
  to.firings = Facts<FiringFact>(std::move(from.firings));
  to.local_negation = from.local_negation;
  to.long_term_memory = from.long_term_memory;
  to.repaired = from.repaired;
  return to;
}

class OwnInspector final : public Inspector, public LearningSource, public LongTermSource {
 public:
  explicit OwnInspector(std::unique_ptr<MindInspection> mind) : mind_(std::move(mind)) {}

  bool TellsAll() const override { return true; }

  MindFacts Mind() override {
    InspectedMind from = mind_->Mind();
    return {std::move(from.phase),
            from.within_phase,
            from.decisions,
            from.elaborations,
            from.firings,
            from.elements,
            from.rules,
            from.halted,
            std::move(from.breakdown),
            std::move(from.input_link),
            std::move(from.output_link)};
  }
  std::vector<StateFact> Stack() override { return Facts<StateFact>(mind_->Stack()); }
  std::vector<ElementFact> ElementsOf(std::string_view id) override {
    return Facts<ElementFact>(mind_->ElementsOf(id));
  }
  std::vector<ElementFact> Search(std::string_view text, std::size_t most) override {
    return Facts<ElementFact>(mind_->Search(text, most));
  }
  std::optional<ElementFact> Element(std::uint64_t timetag) override {
    std::optional<InspectedElement> found = mind_->Element(timetag);
    if (!found) return std::nullopt;
    return Fact(std::move(*found));
  }
  std::vector<MakerFact> MakersOf(std::uint64_t timetag) override { return Facts<MakerFact>(mind_->MakersOf(timetag)); }
  std::vector<TesterFact> TestersOf(std::uint64_t timetag) override {
    return Facts<TesterFact>(mind_->TestersOf(timetag));
  }
  OperatorFacts Operators(std::string_view state) override {
    InspectedOperators from = mind_->Operators(state);
    return {std::move(from.state),
            std::move(from.selected),
            Facts<PreferenceFact>(std::move(from.preferences)),
            Facts<CandidateFact>(std::move(from.candidates)),
            std::move(from.impasse),
            std::move(from.decision)};
  }
  std::vector<RuleFact> Rules() override { return Facts<RuleFact>(mind_->Rules()); }
  std::string RuleSource(std::string_view rule) override { return mind_->RuleSource(rule); }
  std::optional<MatchFacts> Match(std::string_view rule) override {
    std::optional<InspectedMatch> from = mind_->Match(rule);
    if (!from) return std::nullopt;
    MatchFacts to;
    to.rule = std::move(from->rule);
    to.conditions = Facts<ConditionFact>(std::move(from->conditions));
    to.failing = from->failing;
    to.complete = from->complete;
    to.matches = Matches(std::move(from->matches));
    to.before = Matches(std::move(from->before));
    to.candidates = Facts<ElementFact>(std::move(from->candidates));
    to.seen = Facts<ElementFact>(std::move(from->seen));
    return to;
  }
  std::vector<std::string> Complete(std::string_view line) override { return mind_->Complete(line); }
  LearningFacts Learning() override {
    InspectedLearning from = mind_->Learning();
    LearningFacts facts{from.by_reward, from.last_reward, from.total_reward, {}};
    for (InspectedNumber& number : from.numbers) {
      facts.numbers.push_back({std::move(number.rule), number.value, number.current, number.future, number.updates});
    }
    return facts;
  }

  std::vector<LessonFact> Lessons() override { return Facts<LessonFact>(mind_->Lessons(false, {})); }
  std::optional<LessonFact> Lesson(std::string_view rule) override {
    std::vector<InspectedLesson> found = mind_->Lessons(true, rule);
    if (rule.empty() || found.empty()) return std::nullopt;
    return Fact(std::move(found.back()));
  }

  LongTermFacts LongTerm(std::size_t most, const std::string& text) override {
    InspectedLongTerm from = mind_->LongTerm(most, text);
    LongTermFacts facts;
    facts.semantic = from.semantic;
    facts.episodic = from.episodic;
    facts.objects = from.objects;
    facts.augmentations = from.augmentations;
    for (InspectedObject& object : from.known) {
      facts.known.push_back({object.number, std::move(object.text), object.activation, object.uses});
    }
    facts.episodes = from.episodes;
    facts.decisions = std::move(from.decisions);
    return facts;
  }
  std::vector<RememberedFact> Episode(std::size_t number) override {
    std::vector<RememberedFact> facts;
    for (InspectedMemory& from : mind_->Episode(number)) {
      facts.push_back(
          {from.object, std::move(from.attribute), std::move(from.value), from.is_object, from.value_object});
    }
    return facts;
  }

 private:
  std::unique_ptr<MindInspection> mind_;
};

}  // namespace

std::unique_ptr<Inspector> MakeInspector(sml::Agent& agent) {
  if (std::unique_ptr<MindInspection> mind = InspectMind(agent)) return std::make_unique<OwnInspector>(std::move(mind));
  return std::make_unique<CommandInspector>(agent);
}

#else

std::unique_ptr<Inspector> MakeInspector(sml::Agent& agent) {
  return std::make_unique<CommandInspector>(agent);
}

#endif

}  // namespace soarbox::explain
