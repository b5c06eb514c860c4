// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>

#include "cli/lookup.h"
#include "cli/object_printer.h"
#include "cli/printed_rule.h"
#include "cli/stack_printer.h"
#include "diagnostics/name_table.h"
#include "kernel/agent.h"
#include "kernel/learn/reinforcement.h"
#include "kernel/rules/print_production.h"
#include "rule_reading/rule_reading.h"
#include "sml/client/agent_data.h"
#include "sml/client/inspection_learning.h"
#include "sml/client/inspection_match.h"
#include "sml/client/inspection_memory.h"
#include "sml/client/local_agent_link.h"
#include "sml/server/decision_facts.h"
#include "soarbox_Inspection.h"

namespace soarbox {
namespace {

using cli::SymbolText;
using kernel::Agent;
using kernel::Goal;
using kernel::GoalLevel;
using kernel::Preference;
using kernel::PreferenceId;
using kernel::PreferenceType;
using kernel::ProductionId;
using kernel::ProductionType;
using kernel::SlotId;
using kernel::Symbol;
using kernel::WmeId;
using kernel::WmeKind;

const char* TypeName(PreferenceType type) {
  static constexpr const char* kNames[] = {"acceptable",  "require", "reject", "prohibit", "best", "worst",
                                           "indifferent", "numeric", "equal",  "better",   "worse"};
  return NameIn(kNames, type);
}

const char* TypeName(ProductionType type) {
  static constexpr const char* kNames[] = {"user", "default", "chunk", "justification", "template"};
  return NameIn(kNames, type);
}

const char* PhaseName(kernel::Phase phase) {
  static constexpr const char* kNames[] = {"input", "propose", "decide", "apply", "output"};
  return NameIn(kNames, phase);
}

class LocalInspection final : public MindInspection {
 public:
  explicit LocalInspection(sml::LocalAgentLink& link) : link_(link), agent_(link.hosted().agent()) {}

  mind::MindFacts Mind() override {
    mind::MindFacts mind;
    mind.phase = PhaseName(agent_.next_phase());
    mind.within_phase = agent_.in_middle_of_phase();
    const kernel::AgentCounters& counters = agent_.counters();
    mind.decisions = counters.decision_phases;
    mind.elaborations = counters.elaborations;
    mind.firings = counters.firings;
    mind.elements = agent_.memory().wme_count();
    mind.rules = agent_.Productions().size();
    mind.halted = agent_.halted();
    mind.breakdown = agent_.breakdown();
    if (const Symbol link = agent_.InputLinkIdentifier()) mind.input_link = SymbolText(agent_, link);
    if (const Symbol link = agent_.OutputLinkIdentifier()) mind.output_link = SymbolText(agent_, link);
    return mind;
  }

  std::vector<mind::StateFact> Stack() override {
    std::vector<mind::StateFact> stack;
    for (GoalLevel level = 1; level <= agent_.goals().depth(); ++level) {
      const Goal& goal = agent_.goals().at(level);
      const Symbol selected = agent_.OperatorOf(goal);
      mind::StateFact& state = stack.emplace_back();
      state.level = level;
      state.id = SymbolText(agent_, goal.id);
      state.impasse = cli::ImpasseName(goal.impasse);
      if (level > 1) state.attribute = goal.impasse_on_operator ? "operator" : "state";
      if (!selected) continue;
      state.operator_id = SymbolText(agent_, selected);
      state.operator_name = cli::OperatorName(agent_, selected);
    }
    return stack;
  }

  std::vector<mind::ElementFact> ElementsOf(std::string_view id) override {
    std::vector<mind::ElementFact> elements;
    if (const Symbol symbol = cli::FindIdentifier(agent_, id))
      for (const WmeId wme : cli::SortedWmes(agent_, symbol)) elements.push_back(InspectElement(agent_, wme));
    return elements;
  }

  std::vector<mind::ElementFact> Search(std::string_view text, std::size_t most) override {
    std::vector<mind::ElementFact> found;
    const kernel::WmeTable& wmes = agent_.memory().wmes();
    for (std::uint32_t i = 0; i < wmes.size(); ++i) {
      if (!wmes[i].live) continue;
      mind::ElementFact element = InspectElement(agent_, static_cast<WmeId>(i));
      if (element.attribute.find(text) == std::string::npos && element.value.find(text) == std::string::npos &&
          element.id != text)
        continue;
      found.push_back(std::move(element));
    }
    std::ranges::sort(found, {}, &mind::ElementFact::timetag);
    if (found.size() > most) found.resize(most);
    return found;
  }

  std::optional<mind::ElementFact> Element(std::uint64_t timetag) override {
    const WmeId wme = agent_.memory().FindByTimetag(timetag);
    if (wme == WmeId::kNone) return std::nullopt;
    return InspectElement(agent_, wme);
  }

  std::vector<mind::MakerFact> MakersOf(std::uint64_t timetag) override {
    std::vector<mind::MakerFact> makers;
    const WmeId wme = agent_.memory().FindByTimetag(timetag);
    if (wme == WmeId::kNone) return makers;
    const kernel::WmeRecord& record = agent_.memory().record(wme);
    if (record.kind == WmeKind::kInput || record.kind == WmeKind::kArchitecture) {
      makers.emplace_back().kind =
          record.kind == WmeKind::kInput ? mind::MakerFact::Kind::kInput : mind::MakerFact::Kind::kArchitecture;
      return makers;
    }
    if (record.slot() == SlotId::kNone) return makers;
    const Symbol value = agent_.memory().wme(wme).value;
    for (const PreferenceType type : {PreferenceType::kAcceptable, PreferenceType::kRequire})
      for (const PreferenceId id : agent_.PreferencesOf(record.slot(), type))
        if (agent_.memory().preference(id).value == value) makers.push_back(MakerOf(agent_.memory().preference(id)));
    return makers;
  }

  std::vector<mind::TesterFact> TestersOf(std::uint64_t timetag) override {
    const WmeId wme = agent_.memory().FindByTimetag(timetag);
    return wme == WmeId::kNone ? std::vector<mind::TesterFact>() : InspectTesters(agent_, wme);
  }

  mind::OperatorFacts Operators(std::string_view state) override {
    mind::OperatorFacts operators;
    for (GoalLevel level = 1; level <= agent_.goals().depth(); ++level) {
      const Goal& goal = agent_.goals().at(level);
      if (SymbolText(agent_, goal.id) != state) continue;
      operators.state = state;
      if (const Symbol selected = agent_.OperatorOf(goal)) operators.selected = SymbolText(agent_, selected);
      operators.impasse = level < agent_.goals().depth()
                              ? cli::ImpasseName(agent_.goals().at(static_cast<GoalLevel>(level + 1)).impasse)
                              : "none";
      AddPreferences(goal, operators);
      for (const Agent::CandidateChance& chance : agent_.SelectionProbabilities(goal)) {
        operators.candidates.push_back({SymbolText(agent_, chance.value), cli::OperatorName(agent_, chance.value),
                                        chance.numeric_value, chance.probability});
      }
      operators.decision = server::DecisionNow(agent_, state);
    }
    return operators;
  }

  std::vector<mind::RuleFact> Rules() override {
    std::vector<mind::RuleFact> rules;
    for (const ProductionId id : agent_.Productions()) {
      const kernel::Production& production = agent_.production(id);
      mind::RuleFact& rule = rules.emplace_back();
      rule.name = cli::RuleName(agent_, production);
      rule.type = TypeName(production.type);
      rule.file = production.file();
      rule.line = production.line;
      rule.documentation = production.documentation;
      rule.firings = agent_.FiringCount(id);
      if (!agent_.out_of_memory()) rule.matches = CountMatches(agent_, id);
      rule.breaks = agent_.HasBreak(id);
    }
    return rules;
  }

  mind::LearningFacts Learning() override {
    mind::LearningFacts learning;
    learning.by_reward = agent_.reinforcement().learning;
    learning.last_reward = agent_.reward().reward;
    learning.total_reward = agent_.reward().total_reward;
    for (const ProductionId id : agent_.Productions()) {
      const kernel::Production& production = agent_.production(id);
      if (!production.is_rl) continue;
      mind::NumberFact& number = learning.numbers.emplace_back();
      number.rule = cli::RuleName(agent_, production);
      number.when = ConstantsOf(agent_, production);
      if (const kernel::RlValue* const learned = agent_.LearnedValue(id)) {
        number.value = agent_.symbols().NumberValue(learned->value);
        number.current = learned->current;
        number.future = learned->future;
        number.updates = static_cast<std::uint64_t>(learned->updates);
      } else if (const Symbol text = production.actions.front().referent.symbol(); text.IsNumber()) {
        number.value = number.future = agent_.symbols().NumberValue(text);
      }
    }
    return learning;
  }

  std::vector<mind::LearnedRuleFact> LearnedRules(bool whole, std::string_view rule) override {
    return InspectLessons(agent_, whole, rule);
  }

  mind::LongTermFacts LongTerm(std::size_t most, std::string_view text) override {
    return InspectLongTerm(agent_, most, text);
  }
  std::vector<mind::RememberedFact> Episode(std::size_t number) override { return InspectEpisode(agent_, number); }

  std::string RuleSource(std::string_view rule) override {
    const ProductionId id = cli::FindRule(agent_, rule);
    return id == ProductionId::kNone ? std::string()
                                     : kernel::PrintProduction(agent_.symbols(), *agent_.ProductionAsLearned(id));
  }

  std::optional<mind::MatchFacts> Match(std::string_view rule) override {
    const ProductionId id = cli::FindRule(agent_, rule);
    if (id == ProductionId::kNone) return std::nullopt;
    return InspectMatch(agent_, id);
  }

  std::vector<std::string> Complete(std::string_view line) override {
    return link_.host().interpreter().Complete(link_.hosted().session(), line);
  }

 private:
  mind::MakerFact MakerOf(const Preference& preference) {
    mind::MakerFact maker;
    maker.rule = agent_.ProductionName(preference.instantiation);
    if (maker.rule.empty() || maker.rule == "|Memory System Recall|") {
      maker.kind = mind::MakerFact::Kind::kArchitecture;
      maker.rule.clear();
    }
    maker.o_supported = preference.o_supported;
    maker.level = preference.level;
    for (const WmeId wme : agent_.MatchedWmes(preference.instantiation))
      maker.elements.push_back(InspectElement(agent_, wme));
    return maker;
  }

  std::string NameOf(Symbol op) { return op.IsIdentifier() ? cli::OperatorName(agent_, op) : std::string(); }

  void AddPreferences(const Goal& goal, mind::OperatorFacts& operators) {
    if (goal.operator_slot == SlotId::kNone) return;
    constexpr PreferenceType kOrder[] = {PreferenceType::kAcceptable,
                                         PreferenceType::kRequire,
                                         PreferenceType::kReject,
                                         PreferenceType::kProhibit,
                                         PreferenceType::kBest,
                                         PreferenceType::kWorst,
                                         PreferenceType::kBetter,
                                         PreferenceType::kWorse,
                                         PreferenceType::kUnaryIndifferent,
                                         PreferenceType::kNumericIndifferent,
                                         PreferenceType::kBinaryIndifferent};
    for (const PreferenceType type : kOrder) {
      for (const PreferenceId id : agent_.PreferencesOf(goal.operator_slot, type)) {
        const Preference& preference = agent_.memory().preference(id);
        mind::PreferenceFact& told = operators.preferences.emplace_back();
        told.type = TypeName(type);
        told.sign = kernel::PreferenceSign(type);
        told.value = SymbolText(agent_, preference.value);
        told.name = NameOf(preference.value);
        if (preference.referent) {
          told.referent = SymbolText(agent_, preference.referent);
          told.other_name = NameOf(preference.referent);
        }
        told.maker = MakerOf(preference);
      }
    }
  }

  sml::LocalAgentLink& link_;
  Agent& agent_;
};

}  // namespace

std::unique_ptr<MindInspection> InspectMind(sml::Agent& agent) {
  auto* link = sml::LocalLinkOf(agent);
  if (link == nullptr) return nullptr;
  return std::make_unique<LocalInspection>(*link);
}

std::optional<std::vector<mind::RuleFacts>> AskRuleContents(sml::Agent& agent) {
  auto* link = sml::LocalLinkOf(agent);
  if (link == nullptr) return std::nullopt;
  const Agent& mind = link->hosted().agent();
  std::vector<mind::RuleFacts> rules;
  for (const ProductionId id : mind.Productions()) {
    const kernel::Production& production = mind.production(id);
    if (production.type != ProductionType::kJustification)
      rules.push_back(rule_reading::FactsOf(production, mind.symbols()));
  }
  return rules;
}

std::optional<mind::Decision> AskDecision(sml::Agent& agent, std::string_view state) {
  sml::AgentLink* link = sml::AgentData::Of(agent).link.get();
  return link == nullptr ? std::nullopt : link->mind().Decision(state);
}

bool NoteOrigins(sml::Agent& agent) {
  sml::AgentLink* link = sml::AgentData::Of(agent).link.get();
  return link != nullptr && link->mind().NoteOrigins();
}

mind::OriginFacts AskOrigin(sml::Agent& agent, std::uint64_t timetag) {
  sml::AgentLink* link = sml::AgentData::Of(agent).link.get();
  return link == nullptr ? mind::OriginFacts() : link->mind().Origin(timetag, {});
}

mind::OriginFacts AskCommandOrigin(sml::Agent& agent, std::string_view command) {
  sml::AgentLink* link = sml::AgentData::Of(agent).link.get();
  return link == nullptr || command.empty() ? mind::OriginFacts() : link->mind().Origin(0, command);
}

}  // namespace soarbox
