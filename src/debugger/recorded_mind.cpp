// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/recorded_mind.h"

#include <algorithm>
#include <optional>

#include "debugger/facts_text.h"
#include "debugger/memory.h"
#include "tell/sentences.h"

namespace soarbox::debugger {
namespace {

constexpr std::size_t kMostCommands = 12;
constexpr std::string_view kInput = "input-link", kOutput = "output-link", kCommandId = "command#";

/// "O1 (seek)" apart.
std::pair<std::string, std::string> IdAndAbout(std::string_view text) {
  const std::size_t open = text.find(" (");
  std::pair<std::string, std::string> parts{std::string(text.substr(0, open)), std::string()};
  if (open != std::string_view::npos && text.ends_with(')'))
    parts.second = text.substr(open + 2, text.size() - open - 3);
  return parts;
}

/// A line of MindLog::decisions; see there.
void ReadDecision(RecordedMind& mind, std::string_view line, const std::string& reason) {
  const std::size_t indent = std::min(line.find_first_not_of(' '), line.size());
  const int level = 1 + static_cast<int>(indent / 3);
  line.remove_prefix(indent);
  const auto keep = [&](int levels) {
    if (static_cast<int>(mind.stack.size()) > levels) mind.stack.resize(static_cast<std::size_t>(levels));
    mind.reasons.erase(mind.reasons.upper_bound(levels), mind.reasons.end());
  };
  if (line == "halt") {
    mind.halted = true;
  } else if (line.starts_with("<==S: ")) {
    keep(level - 1);
  } else if (line.starts_with("==>S: ")) {
    auto [id, about] = IdAndAbout(line.substr(6));
    keep(level - 1);
    sim::StateFact state;
    state.level = level;
    state.id = std::move(id);
    // "operator no-change"
    const std::size_t blank = about.find(' ');
    state.attribute = about.substr(0, std::min(blank, about.size()));
    state.impasse = blank == std::string::npos ? (level == 1 ? "none" : about) : about.substr(blank + 1);
    if (level == 1) state.attribute.clear();
    mind.stack.push_back(std::move(state));
  } else if (line.starts_with("O: ")) {
    ++mind.decisions;
    keep(level);
    // A recording may begin in the middle of a run: states above are there, whatever they are called.
    while (static_cast<int>(mind.stack.size()) < level) {
      sim::StateFact state;
      state.level = static_cast<int>(mind.stack.size()) + 1;
      state.id = state.level == 1 ? "S1" : "?";
      state.impasse = state.level == 1 ? "none" : "?";
      mind.stack.push_back(std::move(state));
    }
    auto [id, name] = IdAndAbout(line.substr(3));
    mind.stack.back().operator_id = std::move(id);
    mind.stack.back().operator_name = std::move(name);
    mind.reasons[level] = reason;
  }
}

/// "move-to ^waypoint gate", or how one went: "move-to: complete", "shoot: error no-target".
void ReadCommand(RecordedMind& mind, std::string_view line, const std::string& rule, std::uint64_t tick) {
  const std::size_t colon = line.find(": "), blank = line.find(' ');
  if (colon != std::string_view::npos && colon < blank) {
    const std::string_view name = line.substr(0, colon), outcome = line.substr(colon + 2);
    const auto said =
        std::ranges::find_if(mind.commands, [&](const RecordedMind::Command& c) { return c.name == name; });
    if (said == mind.commands.end()) return;
    const std::size_t end = std::min(outcome.find(' '), outcome.size());
    said->status = outcome.substr(0, end);
    said->reason = end < outcome.size() ? outcome.substr(end + 1) : std::string_view{};
    return;
  }
  RecordedMind::Command command;
  command.name = line.substr(0, blank);
  if (blank != std::string_view::npos) command.parameters = line.substr(blank + 1);
  command.rule = rule;
  command.tick = tick;
  mind.commands.push_front(std::move(command));
  if (mind.commands.size() > kMostCommands) mind.commands.pop_back();
}

void ReadDetail(RecordedMind& mind, const std::string& detail) {
  if (std::optional<ElementLine> line = ReadElementLine(detail)) {
    const std::uint64_t timetag = line->element.timetag;
    if (line->added) {
      mind.elements[timetag] = std::move(line->element);
    } else {
      mind.elements.erase(timetag);
    }
    return;
  }
  const std::size_t blank = detail.find(' ');
  constexpr std::string_view kFire = " fire ";
  if (blank == std::string::npos || !std::string_view(detail).substr(blank).starts_with(kFire)) return;
  ++mind.fired;
  ++mind.firings[detail.substr(blank + kFire.size())];
}

/// Where the next " ^" is that does not stand between bars; the end if there is none.
std::size_t EndOfParameter(std::string_view text) {
  bool is_quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '|' && (i == 0 || text[i - 1] != '\\')) is_quoted = !is_quoted;
    if (!is_quoted && text.substr(i).starts_with(" ^")) return i;
  }
  return text.size();
}

/// "^waypoint gate ^text |go ^fast|" as attributes with values.
std::vector<std::pair<std::string, std::string>> Parameters(std::string_view text) {
  std::vector<std::pair<std::string, std::string>> list;
  while (text.starts_with('^')) {
    const std::size_t end = EndOfParameter(text);
    const std::string_view one = text.substr(1, end - 1);
    const std::size_t blank = one.find(' ');
    list.emplace_back(one.substr(0, blank),
                      blank == std::string_view::npos ? std::string_view{} : one.substr(blank + 1));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return list;
}

class RecordInspector final : public sim::Inspector {
 public:
  explicit RecordInspector(const RecordedMind& mind) : mind_(mind) {
    const sim::ElementFact* io = FindElement("S1", "io");
    const sim::ElementFact* input = io == nullptr ? nullptr : FindElement(io->value, kInput);
    const sim::ElementFact* output = io == nullptr ? nullptr : FindElement(io->value, kOutput);
    // Soar itself makes the links when an agent is made, before anybody takes notes; they are always called so. Where
    // memory itself is not recorded, percepts and commands stand in for what is on them.
    const bool has_memory = !mind.elements.empty();
    input_ = input != nullptr ? input->value : std::string(has_memory ? "I2" : kInput);
    output_ = output != nullptr ? output->value : std::string(has_memory ? "I3" : kOutput);
  }

  const RecordedMind& mind() const { return mind_; }

  bool TellsAll() const override { return false; }

  sim::MindFacts Mind() override {
    sim::MindFacts facts;
    facts.decisions = mind_.decisions;
    facts.firings = mind_.fired;
    facts.elements = mind_.elements.size();
    facts.halted = mind_.halted;
    facts.input_link = input_;
    facts.output_link = output_;
    return facts;
  }

  std::vector<sim::StateFact> Stack() override { return mind_.stack; }

  std::vector<sim::ElementFact> ElementsOf(std::string_view id) override {
    std::vector<sim::ElementFact> found;
    for (const auto& [timetag, element] : mind_.elements)
      if (element.id == id) found.push_back(WithKind(element));
    std::ranges::stable_sort(found, {}, &sim::ElementFact::attribute);
    if (found.empty() && input_ == kInput) AddPercepts(id, found);
    if (found.empty() && output_ == kOutput) AddCommands(id, found);
    return found;
  }

  std::vector<sim::ElementFact> Search(std::string_view text, std::size_t most) override {
    std::vector<sim::ElementFact> found;
    for (const auto& [timetag, element] : mind_.elements) {
      if (found.size() >= most) break;
      if (element.attribute.find(text) != std::string::npos || element.value.find(text) != std::string::npos ||
          element.id == text)
        found.push_back(WithKind(element));
    }
    return found;
  }

  std::optional<sim::ElementFact> Element(std::uint64_t timetag) override {
    const auto at = mind_.elements.find(timetag);
    return at == mind_.elements.end() ? std::nullopt : std::optional(WithKind(at->second));
  }

  std::vector<sim::MakerFact> MakersOf(std::uint64_t) override { return {}; }
  std::vector<sim::TesterFact> TestersOf(std::uint64_t) override { return {}; }

  /// Candidates stand in memory, if that is recorded; what else speaks for or against them does not.
  sim::OperatorFacts Operators(std::string_view state) override {
    sim::OperatorFacts facts;
    for (const sim::StateFact& level : mind_.stack) {
      if (level.id == state) {
        facts.state = level.id;
        facts.selected = level.operator_id;
        facts.impasse = "none";
        if (!level.operator_id.empty()) Propose(facts, level.operator_id, level.operator_name);
      } else if (!facts.state.empty() && facts.impasse == "none") {
        facts.impasse = level.impasse;
      }
    }
    if (facts.state.empty()) return facts;
    for (const auto& [timetag, element] : mind_.elements) {
      if (element.id != state || element.attribute != "operator" || element.value == facts.selected) continue;
      const sim::ElementFact* name = FindElement(element.value, "name");
      if (element.acceptable) Propose(facts, element.value, name == nullptr ? std::string{} : name->value);
    }
    return facts;
  }

  std::vector<sim::RuleFact> Rules() override {
    std::vector<sim::RuleFact> rules;
    for (const auto& [name, firings] : mind_.firings) {
      sim::RuleFact& rule = rules.emplace_back();
      rule.name = name;
      rule.type = "user";
      rule.firings = firings;
    }
    return rules;
  }
  std::string RuleSource(std::string_view) override { return {}; }
  std::optional<sim::MatchFacts> Match(std::string_view) override { return std::nullopt; }
  std::vector<std::string> Complete(std::string_view) override { return {}; }

 private:
  const sim::ElementFact* FindElement(std::string_view id, std::string_view attribute) const {
    for (const auto& [timetag, element] : mind_.elements)
      if (element.id == id && element.attribute == attribute) return &element;
    return nullptr;
  }

  static void Propose(sim::OperatorFacts& facts, const std::string& id, const std::string& name) {
    sim::PreferenceFact& preference = facts.preferences.emplace_back();
    preference.type = "acceptable";
    preference.sign = "+";
    preference.value = id;
    preference.name = name;
  }

  /// A value is an object if something is known of it.
  sim::ElementFact WithKind(sim::ElementFact element) const {
    const auto is_of = [&](const auto& entry) { return entry.second.id == element.value; };
    element.is_object = std::ranges::any_of(mind_.elements, is_of);
    return element;
  }

  /// Percepts below a path ("input-link": all) as elements; a part of a path serves as identifier.
  void AddPercepts(std::string_view id, std::vector<sim::ElementFact>& found) const {
    const std::string prefix = id == kInput ? std::string{} : std::string(id) + ".";
    std::uint64_t number = 0;
    for (const auto& [path, value] : mind_.percepts) {
      ++number;
      if (!path.starts_with(prefix)) continue;
      const std::string rest = path.substr(prefix.size());
      const std::size_t dot = rest.find('.');
      sim::ElementFact element{number, std::string(id), rest.substr(0, dot), value, false, false};
      if (dot != std::string::npos) {
        element.value = prefix + element.attribute;
        element.is_object = true;
        if (!found.empty() && found.back().value == element.value) continue;
      }
      found.push_back(std::move(element));
    }
  }

  void AddCommands(std::string_view id, std::vector<sim::ElementFact>& found) const {
    std::uint64_t number = 1'000'000;
    for (const RecordedMind::Command& command : mind_.commands) {
      --number;  // The newest has the highest time tag.
      const std::string name = std::string(kCommandId) + std::to_string(number);
      if (id == kOutput) found.push_back({number, std::string(id), command.name, name, false, true});
      if (id != name) continue;
      const auto add = [&](std::string attribute, std::string value) {
        found.push_back({number, name, std::move(attribute), std::move(value), false, false});
      };
      for (auto& [attribute, value] : Parameters(command.parameters)) add(attribute, value);
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
    record::ApplyPercepts(record.percepts, mind.percepts);
    for (std::size_t i = 0; i < record.decisions.size(); ++i)
      ReadDecision(mind, record.decisions[i], i < record.reasons.size() ? record.reasons[i] : std::string{});
    // A window notes more of the agent that is selected than its recording is to hold.
    if (level_ == record::Level::kAll) {
      for (const std::string& detail : record.details) ReadDetail(mind, detail);
    }
    for (std::size_t i = 0; i < record.commands.size(); ++i) {
      ReadCommand(mind, record.commands[i], i < record.command_rules.size() ? record.command_rules[i] : std::string{},
                  tick.tick);
    }
  }
}

const RecordedMind* RecordedMinds::Find(std::string_view agent) const {
  const auto at = minds_.find(agent);
  return at == minds_.end() ? nullptr : &at->second;
}

std::unique_ptr<sim::Inspector> RecordedMinds::Inspect(std::string_view agent) const {
  const RecordedMind* mind = Find(agent);
  return mind == nullptr ? nullptr : std::make_unique<RecordInspector>(*mind);
}

std::string_view Absence(const sim::Inspector& mind) {
  return dynamic_cast<const RecordInspector*>(&mind) != nullptr ? kNotRecorded : kNotAvailable;
}

std::string MemoryAbsence(const sim::Inspector& mind) {
  const auto* recorded = dynamic_cast<const RecordInspector*>(&mind);
  if (recorded == nullptr) return {};
  if (recorded->mind().level != record::Level::kAll)
    return "Not recorded at this level. Record with --record-level all to have working memory and rules here too.";
  if (!recorded->mind().is_whole)
    return "The recording begins in the middle of the run: what came into memory before it is not recorded.";
  return {};
}

void TellRecorded(const sim::Inspector& mind, OperatorsView& view) {
  const auto* recorded = dynamic_cast<const RecordInspector*>(&mind);
  if (recorded == nullptr) return;
  view.note = "preferences: " + std::string(kNotRecorded);
  view.sentence.clear();
  view.impasse.clear();
  for (OperatorRow& row : view.rows) {
    row.verdict = row.selected ? "selected" : "proposed";
    if (!row.selected) continue;
    const std::string op = NameAndId(row.name, row.id);
    view.sentence = tell::Say(tell::Situation::kIsSelected, {{"op", op}});
    for (const sim::StateFact& state : recorded->mind().stack) {
      if (state.id != view.state) continue;
      const auto reason = recorded->mind().reasons.find(state.level);
      if (reason != recorded->mind().reasons.end() && !reason->second.empty())
        view.sentence = tell::Say(tell::Situation::kWasSelected, {{"op", op}, {"why", reason->second}});
    }
  }
}

WhyNode WhyRecorded(const RecordedMind& mind, std::string_view agent) {
  WhyNode root{std::string(agent) + ", as it was recorded", "agent", std::string(agent), {}};
  WhyNode* below = &root;
  if (mind.commands.empty()) {
    root.below.push_back({"has given no command", "command", "", {}});
  } else {
    const RecordedMind::Command& command = mind.commands.front();
    std::string text = "command " + command.name;
    if (!command.parameters.empty()) text += " " + command.parameters;
    text += ": " + (command.status.empty() ? std::string("under way") : command.status);
    if (!command.reason.empty()) text += " " + command.reason;
    below = &root.below.emplace_back(WhyNode{std::move(text), "command", "", {}});
    if (!command.rule.empty())
      below->below.push_back({tell::Say(tell::Situation::kSaidBy, {{"rule", command.rule}}), "rule", command.rule, {}});
  }
  bool has_operator = false;
  for (const sim::StateFact& state : mind.stack) {
    if (state.operator_id.empty()) continue;
    has_operator = true;
    WhyNode& node = below->below.emplace_back(
        WhyNode{"operator " + NameAndId(state.operator_name, state.operator_id) + " is selected in " + state.id,
                "operator",
                "",
                {}});
    if (const auto reason = mind.reasons.find(state.level); reason != mind.reasons.end() && !reason->second.empty())
      node.below.push_back({reason->second, "reason", "", {}});
  }
  if (!has_operator) below->below.push_back({"no operator is selected now", "reason", "", {}});
  return root;
}

}  // namespace soarbox::debugger
