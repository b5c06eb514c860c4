// SPDX-License-Identifier: BSD-2-Clause
#include "mission/rule_watch.h"

#include <algorithm>
#include <optional>
#include <string_view>

#include "explain/inspector.h"
#include "mission/account.h"
#include "sim/simulation.h"

namespace soarbox::mission {
namespace {

/// Maximum number of unfired rules that are watched: the first of the file.
constexpr std::size_t kMostWatched = 40;
constexpr std::size_t kMostElements = 1000;

/// The attribute and the constant value that a printed condition tests; empty: any.
struct Asked {
  std::string attribute, value;
};
Asked ReadAsked(const std::string& printed) {
  Asked asked;
  const std::size_t caret = printed.find('^');
  if (caret == std::string::npos) return asked;
  std::size_t end = printed.find_first_of(" )", caret);
  asked.attribute = printed.substr(caret + 1, std::min(end, printed.size()) - caret - 1);
  if (asked.attribute.find_first_of("<{") != std::string::npos) asked.attribute.clear();
  const std::size_t begin = printed.find_first_not_of(' ', std::min(end, printed.size()));
  end = printed.find_last_of(')');
  if (begin == std::string::npos || end == std::string::npos || end <= begin) return asked;
  asked.value = printed.substr(begin, end - begin);
  while (asked.value.ends_with(' ')) asked.value.pop_back();
  if (asked.value.find_first_of("<>{= ") != std::string::npos) asked.value.clear();
  return asked;
}

/// Whether working memory contains an element with the attribute of a condition, and one with its value as well,
/// regardless of the other conditions.
struct Presence {
  bool has_attribute = false, has_value = false;
};
Presence PresenceOf(explain::Inspector& inspector, const std::string& printed) {
  Presence presence;
  const Asked asked = ReadAsked(printed);
  if (asked.attribute.empty()) return {true, true};
  std::string value = asked.value;
  if (value.size() > 1 && value.front() == '|' && value.back() == '|') value = value.substr(1, value.size() - 2);
  for (const explain::ElementFact& element : inspector.Search(asked.attribute, kMostElements)) {
    if (element.attribute != asked.attribute) continue;
    presence.has_attribute = true;
    presence.has_value |= value.empty() || element.value == value || element.value == asked.value;
  }
  return presence;
}

/// Whether the failing condition of a rule is about the selected operator.
bool IsAboutSelected(std::string_view why) {
  return why.find("no operator is selected") != std::string_view::npos ||
         why.find("the operator selected in") != std::string_view::npos;
}

/// Whether a reason says only that an element is missing, perhaps with what is there instead, or that one exists. A
/// different value, or a value that no rule can make, is more informative.
bool IsAboutOthers(std::string_view why) {
  constexpr std::string_view kNone = "but there is none now";
  const std::size_t none = why.find(kNone);
  const std::string_view rest = none == std::string_view::npos ? "." : why.substr(none + kNone.size());
  const bool is_other = rest.starts_with("; ^") && rest.find(" has only ^") != std::string_view::npos;
  return rest.empty() || is_other || (why.starts_with("requires no ") && why.ends_with("but there is one"));
}

/// "; rule x made it", for a reason "requires no ^fire, but ..."; empty if the maker is not known.
std::string MakerOfExcluded(explain::Inspector& inspector, const std::string& why) {
  constexpr std::string_view kExcluded = "requires no ^";
  if (!why.starts_with(kExcluded)) return {};
  std::string path = why.substr(kExcluded.size(), why.find_first_of(" ,", kExcluded.size()) - kExcluded.size());
  path.erase(0, path.rfind('.') + 1);
  std::set<std::string> makers;
  for (const explain::ElementFact& element : inspector.Search(path, kMostElements)) {
    if (element.attribute != path) continue;
    for (const explain::MakerFact& maker : inspector.MakersOf(element.timetag))
      if (maker.kind == explain::MakerFact::Kind::kRule) makers.insert(maker.rule);
  }
  return makers.size() == 1 ? "; rule " + *makers.begin() + " made it" : std::string();
}

}  // namespace

std::string WhyRuleWaits(sim::Simulation& simulation, const std::string& agent, const std::string& rule) {
  const Result<std::vector<explain::WhyNode>> why = simulation.WhyTopic(agent, rule);
  if (!why) return {};
  const std::string start = "rule " + rule + " ";
  for (const explain::WhyNode& node : *why) {
    for (const std::string& line : explain::Lines(node, 0)) {
      const std::size_t begin = std::min(line.find_first_not_of(' '), line.size());
      if (line.compare(begin, start.size(), start) != 0) continue;
      std::string text = line.substr(begin + start.size());
      const auto inspector = simulation.Inspect(agent);
      if (inspector != nullptr) text += MakerOfExcluded(*inspector, text);
      return text;
    }
  }
  return {};
}

RuleWatch::RuleWatch(sim::Simulation& simulation, const AccountSettings& settings)
    : simulation_(simulation), settings_(settings) {}

void RuleWatch::See() {
  for (std::size_t i = 0; i < simulation_.soar_agents(); ++i) {
    const std::string agent = simulation_.AgentOfMind(i);
    if (!settings_.IsAboutAgent(agent)) continue;
    const auto inspector = simulation_.Inspect(agent);
    if (inspector == nullptr || !inspector->TellsAll()) continue;
    std::size_t watched = 0;
    for (const explain::RuleFact& rule : inspector->Rules()) {
      if (rule.firings > 0 || settings_.given.contains(rule.name) || !settings_.IsAbout(rule.file)) continue;
      if (++watched > kMostWatched) break;
      Look(*inspector, agent, rule.name);
    }
  }
}

void RuleWatch::Look(explain::Inspector& inspector, const std::string& agent, const std::string& rule) {
  const std::optional<explain::MatchFacts> match = inspector.Match(rule);
  if (!match || !match->failing) return;
  Score score;
  score.matched = *match->failing;
  for (const explain::ConditionFact& condition : match->conditions) {
    if (condition.negated) continue;
    const Presence presence = PresenceOf(inspector, condition.text);
    score.values += presence.has_value ? 1 : 0;
    score.attributes += presence.has_attribute ? 1 : 0;
  }
  const auto [at, is_new] = best_.try_emplace({agent, rule});
  if (is_new) order_.push_back(at->first);
  if (!is_new && score <= at->second.score) return;
  at->second.score = score;
  std::string why = WhyRuleWaits(simulation_, agent, rule);
  if (why.empty()) return;
  const bool waits = IsAboutSelected(why);
  Waiting& waiting = at->second.waiting;
  waiting.agent = agent;
  waiting.rule = rule;
  waiting.why = std::move(why);
  waiting.time_s = simulation_.time_s();
  waiting.waits_for_operator = waits;
  waiting.waits_for_others = IsAboutOthers(waiting.why);
}

std::vector<RuleWatch::Waiting> RuleWatch::Finish() {
  std::set<Key> fired;
  std::set<std::string> agents;  // Only agents whose minds were not halted.
  for (std::size_t i = 0; i < simulation_.soar_agents(); ++i) {
    const std::string agent = simulation_.AgentOfMind(i);
    const auto inspector = simulation_.Inspect(agent);
    if (inspector == nullptr) continue;
    agents.insert(agent);
    for (const explain::RuleFact& rule : inspector->Rules())
      if (rule.firings > 0) fired.emplace(agent, rule.name);
  }
  std::vector<Waiting> waiting;
  for (const Key& key : order_) {
    const Best& best = best_.at(key);
    if (fired.contains(key) || best.waiting.rule.empty() || !agents.contains(key.first)) continue;
    Waiting& each = waiting.emplace_back(best.waiting);
    constexpr std::string_view kRequires = "requires ", kMadeBy = ", but there is none now; rule ";
    const std::size_t at = each.why.find(kMadeBy);
    if (at == std::string::npos || !each.why.starts_with(kRequires)) continue;
    const std::size_t begin = at + kMadeBy.size(), end = each.why.find(" makes it", begin);
    if (end == std::string::npos) continue;
    std::string maker = each.why.substr(begin, end - begin);
    if (!fired.contains({each.agent, maker})) {
      each.waits_for_others = true;  // That the maker never fired is nearer to the cause.
      continue;
    }
    each.wanted = each.why.substr(kRequires.size(), at - kRequires.size());
    each.maker = std::move(maker);
  }
  std::ranges::stable_sort(waiting, {}, [](const Waiting& each) { return each.waits_for_operator; });
  return waiting;
}

}  // namespace soarbox::mission
