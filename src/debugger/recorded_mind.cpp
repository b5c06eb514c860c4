// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/recorded_mind.h"

#include <algorithm>
#include <optional>

#include "debugger/facts_text.h"
#include "debugger/memory.h"
#include "mind/decision_codec.h"
#include "wording/decision_text.h"
#include "wording/mind_words.h"
#include "wording/sentences.h"

namespace soarbox::debugger {
namespace {

constexpr std::size_t kMostCommands = 12;
constexpr std::string_view kInput = "input-link", kOutput = "output-link", kCommandId = "command#";

/// Applies events in order.
class MindReader {
 public:
  MindReader(RecordedMind& mind, std::uint64_t tick) : mind_(mind), tick_(tick) {}

  void operator()(const mind::OperatorSelected& selected) {
    ++mind_.decisions;
    Keep(selected.level);
    Assume(selected.level);
    mind_.stack.back().operator_id = selected.id;
    mind_.stack.back().operator_name = selected.name;
    Note(selected.level, selected.decision);
  }
  void operator()(const mind::StateMade& made) {
    Keep(made.level - 1);
    Assume(made.level - 1);
    explain::StateFact state;
    state.level = made.level;
    state.id = made.id;
    state.impasse = wording::ReasonName(made.reason);
    if (made.level > 1) state.attribute = made.on_operator ? "operator" : "state";
    mind_.stack.push_back(std::move(state));
    // The decision of a no-change impasse is about the state above.
    if (!made.decision.empty()) Note(std::max(made.level - 1, 1), made.decision);
  }
  void operator()(const mind::StateGone& gone) { Keep(gone.level - 1); }
  void operator()(const mind::Halted&) { mind_.halted = true; }
  void operator()(const mind::Remark& remark) {
    if (last_level_ > 0) mind_.accounts[last_level_].remark = wording::ReasonText(remark);
  }
  void operator()(const mind::CommandSaid& said) {
    RecordedMind::Command command;
    command.name = said.name;
    command.parameters = wording::ParametersText(said.parameters);
    for (std::size_t i = 0; i < said.parameters.size(); ++i) {
      const mind::Parameter& parameter = said.parameters[i];
      if (parameter.depth > 0) continue;
      std::size_t end = i + 1;
      while (end < said.parameters.size() && said.parameters[end].depth > 0) ++end;
      std::string value = wording::ValueText(parameter.value);
      if (parameter.is_object) {
        std::vector<mind::Parameter> below(said.parameters.begin() + static_cast<std::ptrdiff_t>(i + 1),
                                           said.parameters.begin() + static_cast<std::ptrdiff_t>(end));
        for (mind::Parameter& one : below) --one.depth;
        value = "(" + wording::ParametersText(below) + ")";
      }
      command.values.emplace_back(parameter.attribute, std::move(value));
    }
    command.rule = said.rule;
    command.tick = tick_;
    for (const explain::StateFact& state : mind_.stack) {
      if (state.operator_id.empty()) continue;
      const auto account = mind_.accounts.find(state.level);
      command.selected.push_back({state.operator_id, state.operator_name,
                                  account == mind_.accounts.end() ? std::string() : account->second.decision});
    }
    mind_.commands.push_front(std::move(command));
    if (mind_.commands.size() > kMostCommands) mind_.commands.pop_back();
  }
  void operator()(const mind::CommandEnded& ended) {
    const auto said =
        std::ranges::find_if(mind_.commands, [&](const RecordedMind::Command& c) { return c.name == ended.name; });
    if (said == mind_.commands.end()) return;
    said->status = wording::StatusName(ended.status);
    said->reason = ended.fault;
  }
  void operator()(const mind::RuleFired& fired) {
    if (mind_.level != record::Level::kAll || fired.retracts) return;
    ++mind_.fired;
    ++mind_.firings[std::string(fired.rule)];
  }
  void operator()(const mind::ElementChanged& element) {
    if (mind_.level != record::Level::kAll) return;
    if (element.added) {
      mind_.elements[element.timetag] = FactOf(element);
    } else {
      mind_.elements.erase(element.timetag);
    }
  }
  template <typename Other>
  void operator()(const Other&) {}

 private:
  /// Removes all states below this level.
  void Keep(int levels) {
    last_level_ = 0;
    if (static_cast<int>(mind_.stack.size()) > levels)
      mind_.stack.resize(static_cast<std::size_t>(std::max(levels, 0)));
    mind_.accounts.erase(mind_.accounts.upper_bound(levels), mind_.accounts.end());
  }
  /// Adds missing states down to this level. Events do not report the top state, which exists before a mind is
  /// observed, nor states that were made before the recording began. Their names are not known, except S1.
  void Assume(int levels) {
    while (static_cast<int>(mind_.stack.size()) < levels) {
      explain::StateFact& state = mind_.stack.emplace_back();
      state.level = static_cast<int>(mind_.stack.size());
      state.id = state.level == 1 ? "S1" : "?";
      state.impasse = state.level == 1 ? "none" : "?";
    }
  }
  void Note(int level, std::string_view decision) {
    last_level_ = level;
    mind_.accounts[level] = {std::string(decision), {}};
  }

  RecordedMind& mind_;
  std::uint64_t tick_;
  int last_level_ = 0;  ///< The level of the last decision.
};

/// The last recorded decision in a state; nothing if none is recorded.
std::optional<mind::Decision> DecisionOf(const RecordedMind::Account* account) {
  return account == nullptr || account->decision.empty() ? std::nullopt : mind::Unpack(account->decision);
}

const RecordedMind::Account* AccountOf(const RecordedMind& mind, const explain::StateFact& state) {
  const auto found = mind.accounts.find(state.level);
  return found == mind.accounts.end() ? nullptr : &found->second;
}

/// Converts a preference of a recorded decision to the form in which Inspectors return it.
explain::PreferenceFact FactOf(const mind::Decision& decision, const mind::Decision::Preference& preference) {
  constexpr std::pair<std::string_view, std::string_view> kKinds[] = {
      {"acceptable", "+"}, {"require", "!"}, {"reject", "-"},      {"prohibit", "~"}, {"best", ">"}, {"worst", "<"},
      {"better", ">"},     {"worse", "<"},   {"indifferent", "="}, {"numeric", "="},  {"equal", "="}};
  explain::PreferenceFact fact;
  const auto& [type, sign] = kKinds[static_cast<std::size_t>(preference.kind)];
  fact.type = type;
  fact.sign = sign;
  fact.value = decision.operators[preference.op].id;
  fact.name = decision.operators[preference.op].name;
  if (preference.referent != mind::Decision::kNoOperator) {
    fact.referent = decision.operators[preference.referent].id;
    fact.other_name = decision.operators[preference.referent].name;
  }
  if (preference.kind == mind::PreferenceKind::kNumeric) fact.referent = wording::ValueText(preference.number);
  fact.maker.kind = preference.rule.empty() ? explain::MakerFact::Kind::kArchitecture : explain::MakerFact::Kind::kRule;
  fact.maker.rule = preference.rule;
  return fact;
}

class RecordInspector final : public explain::Inspector {
 public:
  explicit RecordInspector(const RecordedMind& mind) : mind_(mind) {
    const explain::ElementFact* io = FindElement("S1", "io");
    const explain::ElementFact* input = io == nullptr ? nullptr : FindElement(io->value, kInput);
    const explain::ElementFact* output = io == nullptr ? nullptr : FindElement(io->value, kOutput);
    // Soar creates the links with the agent, before events are recorded; their names are always I2 and I3. If memory is
    // not recorded, recorded percepts and commands are shown as elements of the links.
    const bool has_memory = !mind.elements.empty();
    input_ = input != nullptr ? input->value : std::string(has_memory ? "I2" : kInput);
    output_ = output != nullptr ? output->value : std::string(has_memory ? "I3" : kOutput);
  }

  const RecordedMind& mind() const { return mind_; }

  bool TellsAll() const override { return false; }

  explain::MindFacts Mind() override {
    explain::MindFacts facts;
    facts.decisions = mind_.decisions;
    facts.firings = mind_.fired;
    facts.elements = mind_.elements.size();
    facts.halted = mind_.halted;
    facts.input_link = input_;
    facts.output_link = output_;
    return facts;
  }

  std::vector<explain::StateFact> Stack() override { return mind_.stack; }

  std::vector<explain::ElementFact> ElementsOf(std::string_view id) override {
    std::vector<explain::ElementFact> found;
    for (const auto& [timetag, element] : mind_.elements)
      if (element.id == id) found.push_back(WithKind(element));
    std::ranges::stable_sort(found, {}, &explain::ElementFact::attribute);
    if (found.empty() && input_ == kInput) AddPercepts(id, found);
    if (found.empty() && output_ == kOutput) AddCommands(id, found);
    return found;
  }

  std::vector<explain::ElementFact> Search(std::string_view text, std::size_t most) override {
    std::vector<explain::ElementFact> found;
    for (const auto& [timetag, element] : mind_.elements) {
      if (found.size() >= most) break;
      if (element.attribute.find(text) != std::string::npos || element.value.find(text) != std::string::npos ||
          element.id == text)
        found.push_back(WithKind(element));
    }
    return found;
  }

  std::optional<explain::ElementFact> Element(std::uint64_t timetag) override {
    const auto at = mind_.elements.find(timetag);
    return at == mind_.elements.end() ? std::nullopt : std::optional(WithKind(at->second));
  }

  std::vector<explain::MakerFact> MakersOf(std::uint64_t) override { return {}; }
  std::vector<explain::TesterFact> TestersOf(std::uint64_t) override { return {}; }

  /// Without a recorded decision, only proposals are known: the selected operator, and acceptable elements of recorded
  /// memory.
  explain::OperatorFacts Operators(std::string_view state) override {
    explain::OperatorFacts facts;
    for (const explain::StateFact& level : mind_.stack) {
      if (level.id == state) {
        facts.state = level.id;
        facts.selected = level.operator_id;
        facts.impasse = "none";
        Decided(facts, level);
        if (!level.operator_id.empty() && !facts.decision) Propose(facts, level.operator_id, level.operator_name);
      } else if (!facts.state.empty() && facts.impasse == "none") {
        facts.impasse = level.impasse;
      }
    }
    if (facts.state.empty() || facts.decision) return facts;
    for (const auto& [timetag, element] : mind_.elements) {
      if (element.id != state || element.attribute != "operator" || element.value == facts.selected) continue;
      const explain::ElementFact* name = FindElement(element.value, "name");
      if (element.acceptable) Propose(facts, element.value, name == nullptr ? std::string{} : name->value);
    }
    return facts;
  }

  std::vector<explain::RuleFact> Rules() override {
    std::vector<explain::RuleFact> rules;
    for (const auto& [name, firings] : mind_.firings) {
      explain::RuleFact& rule = rules.emplace_back();
      rule.name = name;
      rule.type = "user";
      rule.firings = firings;
    }
    return rules;
  }
  std::string RuleSource(std::string_view) override { return {}; }
  std::optional<explain::MatchFacts> Match(std::string_view) override { return std::nullopt; }
  std::vector<std::string> Complete(std::string_view) override { return {}; }

 private:
  const explain::ElementFact* FindElement(std::string_view id, std::string_view attribute) const {
    for (const auto& [timetag, element] : mind_.elements)
      if (element.id == id && element.attribute == attribute) return &element;
    return nullptr;
  }

  /// Adds the last recorded decision in this state.
  void Decided(explain::OperatorFacts& facts, const explain::StateFact& state) const {
    facts.decision = DecisionOf(AccountOf(mind_, state));
    if (!facts.decision) return;
    const mind::Decision& decision = *facts.decision;
    for (const mind::Decision::Preference& preference : decision.preferences)
      facts.preferences.push_back(FactOf(decision, preference));
    if (decision.impasse != mind::Impasse::kNone) return;
    for (const mind::Decision::Chance& chance : decision.left) {
      const mind::Decision::Operator& op = decision.operators[chance.op];
      facts.candidates.push_back({op.id, op.name, chance.value, chance.probability});
    }
  }

  static void Propose(explain::OperatorFacts& facts, const std::string& id, const std::string& name) {
    explain::PreferenceFact& preference = facts.preferences.emplace_back();
    preference.type = "acceptable";
    preference.sign = "+";
    preference.value = id;
    preference.name = name;
  }

  /// Marks a value as an object if elements of it are known.
  explain::ElementFact WithKind(explain::ElementFact element) const {
    const auto is_of = [&](const auto& entry) { return entry.second.id == element.value; };
    element.is_object = std::ranges::any_of(mind_.elements, is_of);
    return element;
  }

  /// Converts percepts below a path ("input-link": all) to elements. Parts of the path are used as identifiers.
  void AddPercepts(std::string_view id, std::vector<explain::ElementFact>& found) const {
    const std::string prefix = id == kInput ? std::string{} : std::string(id) + ".";
    std::uint64_t number = 0;
    for (const auto& [path, value] : mind_.percepts) {
      ++number;
      if (!path.starts_with(prefix)) continue;
      const std::string rest = path.substr(prefix.size());
      const std::size_t dot = rest.find('.');
      explain::ElementFact element{number, std::string(id), rest.substr(0, dot), record::TextOf(value), false, false};
      if (dot != std::string::npos) {
        element.value = prefix + element.attribute;
        element.is_object = true;
        if (!found.empty() && found.back().value == element.value) continue;
      }
      found.push_back(std::move(element));
    }
  }

  void AddCommands(std::string_view id, std::vector<explain::ElementFact>& found) const {
    std::uint64_t number = 1'000'000;
    for (const RecordedMind::Command& command : mind_.commands) {
      --number;  // The newest has the highest time tag.
      const std::string name = std::string(kCommandId) + std::to_string(number);
      if (id == kOutput) found.push_back({number, std::string(id), command.name, name, false, true});
      if (id != name) continue;
      const auto add = [&](std::string attribute, std::string value) {
        found.push_back({number, name, std::move(attribute), std::move(value), false, false});
      };
      for (const auto& [attribute, value] : command.values) add(attribute, value);
      if (!command.status.empty()) add("status", command.status);
      if (!command.reason.empty()) add("reason", command.reason);
    }
  }

  const RecordedMind& mind_;
  std::string input_, output_;
};

}  // namespace

void RecordedMinds::Clear() {
  minds_.clear();
  has_ticks_ = from_begin_ = false;
  last_tick_ = 0;
}

void RecordedMinds::Add(const record::TickRecord& tick) {
  if (!has_ticks_) from_begin_ = tick.tick == 0;
  has_ticks_ = true;
  last_tick_ = tick.tick;
  if (level_ == record::Level::kWorld) return;
  for (const record::MindRecord& record : tick.minds) {
    if (!only_.empty() && record.agent != only_) continue;
    const auto [at, is_new] = minds_.try_emplace(record.agent);
    RecordedMind& mind = at->second;
    if (is_new) {
      mind.level = level_;
      mind.is_whole = from_begin_;
    }
    record::ApplyPercepts(record.events, mind.percepts);
    record.events.ForEach(MindReader(mind, tick.tick));
  }
}

const RecordedMind* RecordedMinds::Find(std::string_view agent) const {
  const auto at = minds_.find(agent);
  return at == minds_.end() ? nullptr : &at->second;
}

std::unique_ptr<explain::Inspector> RecordedMinds::Inspect(std::string_view agent) const {
  const RecordedMind* mind = Find(agent);
  return mind == nullptr ? nullptr : std::make_unique<RecordInspector>(*mind);
}

std::string_view Absence(const explain::Inspector& mind) {
  return dynamic_cast<const RecordInspector*>(&mind) != nullptr ? kNotRecorded : kNotAvailable;
}

std::string MemoryAbsence(const explain::Inspector& mind) {
  const auto* recorded = dynamic_cast<const RecordInspector*>(&mind);
  if (recorded == nullptr) return {};
  if (recorded->mind().level != record::Level::kAll)
    return "Not recorded at this level. Record with --record-level all to have working memory and rules here too.";
  if (!recorded->mind().is_whole)
    return "The recording begins in the middle of the run: what came into memory before it is not recorded.";
  return {};
}

void TellRecorded(const explain::Inspector& mind, OperatorsView& view) {
  const auto* recorded = dynamic_cast<const RecordInspector*>(&mind);
  if (recorded == nullptr) return;
  const RecordedMind::Account* account = nullptr;
  for (const explain::StateFact& state : recorded->mind().stack)
    if (state.id == view.state) account = AccountOf(recorded->mind(), state);
  if (DecisionOf(account)) return;
  view.note = "preferences: " + std::string(kNotRecorded);
  view.sentence.clear();
  view.impasse.clear();
  for (OperatorRow& row : view.rows) {
    row.verdict = row.selected ? "selected" : "proposed";
    if (!row.selected) continue;
    const std::string op = NameAndId(row.name, row.id);
    view.sentence = account != nullptr && !account->remark.empty()
                        ? wording::Say(wording::Situation::kWasSelected, {{"op", op}, {"why", account->remark}})
                        : wording::Say(wording::Situation::kIsSelected, {{"op", op}});
  }
}

namespace {

WhyNode NodeOf(const RecordedMind::Command& command) {
  std::string text = "command " + command.name;
  if (!command.parameters.empty()) text += " " + command.parameters;
  text += ": " + (command.status.empty() ? std::string("under way") : command.status);
  if (!command.reason.empty()) text += " " + command.reason;
  WhyNode node{std::move(text), WhyKind::kCommand, command.name};
  if (!command.rule.empty())
    node.below.push_back(
        {wording::Say(wording::Situation::kSaidBy, {{"rule", command.rule}}), WhyKind::kRule, command.rule});
  for (const RecordedMind::Selected& selected : command.selected) {
    const std::optional<mind::Decision> decision =
        selected.decision.empty() ? std::nullopt : mind::Unpack(selected.decision);
    const std::string why = decision ? wording::WhySelected(*decision) : std::string();
    node.below.push_back({wording::Say(why.empty() ? wording::Situation::kSelectedWhenGiven
                                                   : wording::Situation::kSelectedWhenGivenBecause,
                                       {{"op", NameAndId(selected.name, selected.id)}, {"why", why}}),
                          WhyKind::kOperator});
  }
  return node;
}

}  // namespace

std::optional<WhyNode> WhyRecordedCommand(const RecordedMind& mind, std::string_view name) {
  const auto command = std::ranges::find(mind.commands, name, &RecordedMind::Command::name);
  return command == mind.commands.end() ? std::nullopt : std::optional(NodeOf(*command));
}

WhyNode WhyRecorded(const RecordedMind& mind, std::string_view agent) {
  WhyNode root{std::string(agent) + ", as it was recorded", WhyKind::kAgent, std::string(agent)};
  root.below.push_back(mind.commands.empty() ? WhyNode{"has given no command", WhyKind::kCommand}
                                             : NodeOf(mind.commands.front()));
  bool has_operator = false;
  for (const explain::StateFact& state : mind.stack) {
    const RecordedMind::Account* account = AccountOf(mind, state);
    const std::optional<mind::Decision> decision = DecisionOf(account);
    if (state.operator_id.empty()) {
      // The recorded decision says why no operator was selected.
      if (!decision) continue;
      if (std::string why = wording::WhyNothing(*decision); !why.empty())
        root.below.push_back({"no operator is selected in " + state.id + ": " + why});
      continue;
    }
    has_operator = true;
    WhyNode& node = root.below.emplace_back(
        WhyNode{"operator " + NameAndId(state.operator_name, state.operator_id) + " is selected in " + state.id,
                WhyKind::kOperator});
    if (account == nullptr) continue;
    if (!account->remark.empty()) node.below.push_back({account->remark});
    if (!decision) continue;
    node.below.push_back({wording::WhyDecided(*decision)});
    for (const mind::Decision::Drop& drop : decision->drops) {
      node.below.push_back({"also there: " + wording::OperatorText(*decision, drop.op) + ", " +
                            wording::WhyDropped(*decision, drop.op)});
    }
  }
  if (!has_operator) root.below.push_back({"no operator is selected now"});
  return root;
}

}  // namespace soarbox::debugger
