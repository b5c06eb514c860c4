// SPDX-License-Identifier: BSD-2-Clause
// Learning: learned rules with their reasons, values learned from reward, and reward per episode.
#include <algorithm>
#include <cmath>
#include <utility>

#include "workbench/document/build.h"
#include "workbench/document/curves.h"
#include "workbench/document/panels.h"

namespace soarbox::workbench::document {
namespace {

using debugger::LearnedRuleRow;
using debugger::LearningView;

constexpr std::size_t kMostFired = 8, kMostEpisodes = 300;

/// The explanation of the selected rule, and when it has fired since.
Section Story(const Contents& contents) {
  const debugger::LearnedRuleView& rule = contents.learned_rule;
  Section section{"learned-rule", {RuleLink(rule.name)}, {}};
  section.is_story = true;
  section.nodes.push_back(Line{{Button{"Close", Action{LearnedRuleRequest{}}, "Back to all learned rules"}}});
  Spans fired{Quiet("Fired since:")};
  if (!rule.fired_note.empty()) fired.push_back(Quiet(" " + rule.fired_note + "."));
  for (std::size_t i = 0; i < std::min(kMostFired, rule.fired.size()); ++i) {
    fired.push_back({" "});
    fired.push_back(Time(rule.fired[rule.fired.size() - 1 - i]));
  }
  if (rule.fired.size() > kMostFired)
    fired.push_back(Quiet(" and " + std::to_string(rule.fired.size() - kMostFired) + " times before"));
  section.nodes.push_back(Text(std::move(fired)));
  // Its name is already in the heading.
  debugger::WhyNode why = rule.why;
  if (const std::string name = rule.name + ": "; why.text.starts_with(name)) why.text.erase(0, name.size());
  section.nodes.push_back(ReasonTree(contents, why, 2));
  return section;
}

Nodes Rules(const Contents& contents) {
  const LearningView& view = contents.learning;
  Nodes nodes;
  if (view.rules.empty()) {
    const bool is_untold = view.learners == 0 && !view.note.empty();
    if (is_untold) nodes.push_back(Text(view.note, Role::kQuiet));
    if (!is_untold || contents.not_recorded.empty())
      nodes.push_back(Empty("No rule has been learned yet.",
                            "With chunk always, the agent learns from what it works out in substates."));
    return nodes;
  }
  Table table{"learned", {{"Learned"}, {"Fired", true}, {"Rule"}, {"What it does"}, {"Learned in", false, true}}};
  table.filter = "Filter by text";
  table.none_fits = {"No learned rule has this text.", ""};
  table.press = RowAction{{LearnedRuleRequest{}}, "rule"};
  for (const LearnedRuleRow& rule : view.rules) {
    Cell when = rule.tick ? TimeCell(*rule.tick) : TextCell("-", Role::kQuiet);
    if (!rule.tick) when.spans[0].hint = "It was learned before anybody watched, or loaded";
    TableRow& row =
        table.Add(rule.name, {std::move(when), CountCell(rule.firings),
                              TextCell(rule.name, rule.is_gone ? Role::kQuiet : Role::kName),
                              rule.purpose.empty() ? TextCell("not known", Role::kQuiet) : TextCell(rule.purpose),
                              TextCell(rule.source, Role::kQuiet)});
    row.is_chosen = rule.name == contents.learned_rule.name;
    if (!rule.is_gone) continue;
    row.hint = "Excised since";
    row.cells[2].spans.push_back({" removed", Role::kWarn});
  }
  nodes.push_back(std::move(table));
  return nodes;
}

/// The curves that are drawn: the user's choice, or the values that were updated most often.
Plot ValueCurves(const Contents& contents) {
  Plot plot{"values", "Values over time", {}};
  plot.is_stepped = true;
  for (const std::string& rule : contents.learning_curves) {
    if (contents.learning_log == nullptr) break;
    const auto points = contents.learning_log->values().find(rule);
    if (points == contents.learning_log->values().end()) continue;
    Curve curve{rule};
    for (const auto& [tick, value] : points->second) curve.points.emplace_back(static_cast<double>(tick), value);
    // The last value is valid until now.
    const auto last = static_cast<double>(contents.moment.last_tick);
    if (!curve.points.empty() && curve.points.back().first < last)
      curve.points.emplace_back(last, curve.points.back().second);
    curve.points = Thinned(std::move(curve.points));
    plot.curves.push_back(std::move(curve));
  }
  return plot;
}

Nodes Values(const Contents& contents) {
  const LearningView& view = contents.learning;
  Nodes nodes;
  if (!view.note.empty()) nodes.push_back(Text(view.note, Role::kQuiet));
  if (view.learners == 0) {
    if (view.note.empty())
      nodes.push_back(Empty("No rule learns by reward.",
                            "rl --set learning on, and a rule whose only action is a numeric preference."));
    return nodes;
  }
  nodes.push_back(Text("Reward in all: " + Rounded(view.total_reward), Role::kQuiet));
  double most = 1e-9;
  for (const mind::NumberFact& number : view.numbers) most = std::max(most, std::abs(number.value));
  Table table{"numbers", {{"Value", true}, {"Updates", true}, {"Rule"}, {"If"}, {""}}};
  table.filter = "Filter by text";
  table.none_fits = {"No rule with a number has this text.", ""};
  table.is_sortable = true;
  for (const mind::NumberFact& number : view.numbers) {
    const bool is_drawn = std::ranges::find(contents.learning_curves, number.rule) != contents.learning_curves.end();
    table
        .Add(number.rule, {NumberCell(number.value, Rounded(number.value)),
                           CountCell(number.updates),
                           {{RuleLink(number.rule)}},
                           TextCell(number.when, Role::kQuiet),
                           ButtonCell(is_drawn ? kRemove : "+", CurveRequest{number.rule, !is_drawn},
                                      is_drawn ? "No longer draw its curve" : "Draw its curve")})
        .cells[0]
        .bar = number.value / most;
  }
  nodes.push_back(std::move(table));
  if (Plot curves = ValueCurves(contents); curves.curves.empty())
    nodes.push_back(Text("No number has moved yet. Each change is noted from then on.", Role::kQuiet));
  else
    nodes.push_back(std::move(curves));
  return nodes;
}

/// Number of episodes that have ended at the shown moment.
std::size_t EpisodesSoFar(const Contents& contents) {
  if (contents.learning_log == nullptr) return 0;
  return static_cast<std::size_t>(std::ranges::count_if(
      contents.learning_log->episodes(),
      [&](const debugger::RewardEpisode& episode) { return episode.last_tick <= contents.moment.shown_tick; }));
}

Nodes Episodes(const Contents& contents, std::size_t count) {
  if (count == 0)
    return {Empty("No episode has ended yet.",
                  "An episode ends when the agent halts, or selects an operator that no learning rule is about while "
                  "temporal-extension is off.")};
  const auto& episodes = contents.learning_log->episodes();
  Plot plot{"rewards", "Reward of each episode", {{"reward"}}};
  plot.is_stepped = true;
  for (const debugger::RewardEpisode& episode : episodes)
    plot.curves[0].points.emplace_back(static_cast<double>(episode.last_tick), episode.reward);
  plot.curves[0].points = Thinned(std::move(plot.curves[0].points));
  Table table{"episodes", {{"Episode", true}, {"Ended"}, {"Took", true}, {"Reward", true}}};
  for (std::size_t number = count; number > 0 && table.rows.size() < kMostEpisodes; --number) {
    const debugger::RewardEpisode& episode = episodes[number - 1];
    const double took_s = static_cast<double>(episode.last_tick - episode.first_tick) * contents.moment.step_s;
    const std::string key = std::to_string(number);
    table.Add(key,
              {NumberCell(static_cast<double>(number), key, Role::kQuiet), TimeCell(episode.last_tick),
               NumberCell(took_s, Rounded(took_s, 3) + " s"),
               NumberCell(episode.reward, Rounded(episode.reward), episode.reward < 0 ? Role::kWarn : Role::kGood)});
  }
  return {std::move(table), std::move(plot)};
}

}  // namespace

Nodes LearningDocument(const Contents& contents) {
  const LearningView& view = contents.learning;
  Nodes nodes;
  if (!contents.learned_rule.name.empty()) nodes.push_back(Story(contents));
  const std::size_t episodes = EpisodesSoFar(contents);
  Tabs tabs{"pages", {}};
  tabs.pages.push_back({"Rules " + std::to_string(view.rules.size()),
                        "Rules that were learned in substates, the newest first", Rules(contents)});
  tabs.pages.push_back(
      {"Values " + std::to_string(view.learners), "Numbers that reward moves, the highest first", Values(contents)});
  tabs.pages.push_back(
      {"Episodes " + std::to_string(episodes), "The reward of each episode", Episodes(contents, episodes)});
  // Initially shows the page that is not empty.
  tabs.first = view.rules.empty() && view.learners > 0 ? 1 : 0;
  nodes.push_back(std::move(tabs));
  return nodes;
}

}  // namespace soarbox::workbench::document
