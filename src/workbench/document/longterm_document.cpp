// SPDX-License-Identifier: BSD-2-Clause
// Long-term memory: objects with their activation, what was recalled and why, episodes.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <utility>

#include "workbench/document/build.h"
#include "workbench/document/panels.h"

namespace soarbox::workbench::document {
namespace {

using debugger::Recall;

constexpr std::size_t kMostRecalls = 300;

/// The object that was recalled last; 0 if none was.
std::uint64_t LastRecalled(const Contents& contents) {
  if (contents.recalls == nullptr) return 0;
  const auto& all = contents.recalls->recalls();
  for (auto recall = all.rbegin(); recall != all.rend(); ++recall)
    if (!recall->is_episode && recall->number != 0 && recall->tick <= contents.moment.shown_tick) return recall->number;
  return 0;
}

Nodes Known(const Contents& contents) {
  const debugger::LongTermView& view = contents.long_term;
  Nodes nodes{
      LineForm("known", SearchKnownRequest{},
               {Field::Kind::kLine, "text", "Search all that is known", "Filter by text", contents.known_search})};
  if (!view.note.empty()) nodes.push_back(Text(view.note, Role::kQuiet));
  const auto& known = view.facts.known;
  if (known.empty()) {
    if (!contents.known_search.empty())
      nodes.push_back(Empty("Nothing that is known has this text."));
    else if (view.note.empty())
      nodes.push_back(Empty("Nothing is known yet.",
                            "Rules store objects with ^smem.command.store; smem --add adds some at once."));
    return nodes;
  }
  if (contents.known_search.empty() && known.size() < view.facts.objects)
    nodes.push_back(
        Text("The " + std::to_string(known.size()) + " most active. The filter looks through all that is known.",
             Role::kQuiet));
  double most = 1e-9;
  for (const mind::KnownObjectFact& object : known) most = std::max(most, std::abs(object.activation));
  const std::uint64_t recalled = LastRecalled(contents);
  Table table{"objects", {{"Object"}, {"Activation", true}, {"Uses", true}, {"What is known of it"}}};
  table.is_sortable = true;
  for (const mind::KnownObjectFact& object : known) {
    const std::string key = "@" + std::to_string(object.number);
    char activation[32];
    std::snprintf(activation, sizeof activation, "%.3f", object.activation);
    Cell number = TextCell(key, object.number == recalled ? Role::kGood : Role::kObject);
    if (object.number == recalled) number.spans[0].hint = "Recalled last";
    Cell active = NumberCell(object.activation, activation);
    active.bar = object.activation / most;
    table.Add(key, {std::move(number), std::move(active), CountCell(object.uses), TextCell(object.text)});
  }
  nodes.push_back(std::move(table));
  return nodes;
}

Spans AnswerOf(const Recall& recall) {
  if (recall.number == 0) return {{"nothing", Role::kBad}};
  if (!recall.is_episode) return {{"@" + std::to_string(recall.number) + " " + recall.answer, Role::kObject}};
  return {{"episode " + std::to_string(recall.number), Role::kName,
           Action{EpisodeRequest{static_cast<std::size_t>(recall.number)}}, "Look at this episode"}};
}

Nodes Recalled(const Contents& contents) {
  if (contents.recalls == nullptr || contents.recalls->recalls().empty())
    return {
        Empty("Nothing was asked yet.",
              "Rules ask with ^smem.command.query or ^epmem.command.query. This panel shows what they got, and why.")};
  Table table{"recalled",
              {{"When"}, {"Asked for", false, false, true}, {"Came", false, false, true}, {"Why", false, false, true}}};
  table.filter = "Filter by text";
  table.none_fits = {"No recall has this text.", ""};
  const auto& all = contents.recalls->recalls();
  for (auto recall = all.rbegin(); recall != all.rend() && table.rows.size() < kMostRecalls; ++recall) {
    TableRow& row = table.Add(std::to_string(all.rend() - recall), {TimeCell(recall->tick),
                                                                    TextCell(recall->question),
                                                                    {AnswerOf(*recall)},
                                                                    TextCell(recall->reason, Role::kQuiet)});
    // The recall happened after the shown moment.
    if (recall->tick > contents.moment.shown_tick) row.cells[0].spans[0].role = Role::kQuiet;
  }
  return {std::move(table)};
}

/// The first and the last of the successive episodes that have the same contents as this one.
std::pair<std::size_t, std::size_t> AlikeAround(const mind::LongTermFacts& facts, std::size_t episode) {
  if (facts.changed.empty()) return {episode, episode};
  const auto after = std::ranges::upper_bound(facts.changed, episode);
  const std::size_t first = after == facts.changed.begin() ? episode : *std::prev(after);
  return {first, after == facts.changed.end() ? facts.episodes : *after - 1};
}

/// "Episodes 31 to 45 of 73518, all alike, at 2.10 s, taken in decisions 31 to 45"
std::string WhichEpisode(const Contents& contents) {
  const mind::LongTermFacts& facts = contents.long_term.facts;
  const std::size_t chosen = contents.episode.number;
  const auto [first, last] = AlikeAround(facts, chosen);
  const auto range = [](std::size_t from, std::size_t to) {
    return from == to ? " " + std::to_string(from) : "s " + std::to_string(from) + " to " + std::to_string(to);
  };
  std::string text = "Episode" + range(first, last) + " of " + std::to_string(facts.episodes);
  if (first != last) text += ", all alike";
  if (contents.episode.time_s) text += fmt::format(", at {:.2f} s", *contents.episode.time_s);
  if (last > facts.decisions.size()) return text;
  if (facts.decisions[chosen - 1] == 0) return text + ", from an earlier run";
  const std::size_t from = facts.decisions[first - 1] == 0 ? facts.decisions[chosen - 1] : facts.decisions[first - 1];
  return text + ", taken in decision" + range(from, facts.decisions[last - 1]);
}

Nodes EpisodesPart(const Contents& contents) {
  const debugger::LongTermView& view = contents.long_term;
  const std::size_t episodes = view.facts.episodes, chosen = contents.episode.number;
  if (episodes == 0) {
    if (!view.note.empty()) return {Text(view.note, Role::kQuiet)};
    return {Empty("There are no episodes yet.", "epmem --enable takes one in each decision.")};
  }
  Line line;
  const auto step = [&](const char* label, std::size_t to, const char* hint, bool is_there) {
    Button button{label, Action{EpisodeRequest{to}}, hint};
    button.is_enabled = is_there;
    line.nodes.push_back(std::move(button));
  };
  const auto [first, last] = AlikeAround(view.facts, chosen);
  const std::size_t before = first > 1 ? AlikeAround(view.facts, first - 1).first : 0;
  step("<", before, "The episode before that differs", chosen != 0 && first > 1);
  step(">", last + 1, "The next episode that differs", last < episodes);
  if (chosen != 0) step("Close", 0, "", true);
  Strip strip{"episode", "Episode", episodes, chosen, {}, "recalled by rules", RowAction{{EpisodeRequest{}}, "number"}};
  if (contents.recalls != nullptr)
    for (const Recall& recall : contents.recalls->recalls())
      if (recall.is_episode && recall.number > 0 && recall.number <= episodes &&
          std::ranges::find(strip.marks, recall.number) == strip.marks.end())
        strip.marks.push_back(static_cast<std::size_t>(recall.number));
  Nodes nodes{std::move(line), std::move(strip)};
  if (chosen == 0) {
    nodes.push_back(Empty("Choose an episode on the strip: that world appears as ghosts.",
                          "Marked episodes were recalled by rules; the page Recalled leads to them."));
    return nodes;
  }
  nodes.push_back(Text(WhichEpisode(contents)));
  if (contents.episode.things.empty())
    nodes.push_back(Text("Nothing in this episode has a ^position, so it has no ghosts.", Role::kQuiet));
  std::string lines;
  for (const std::string& line_text : contents.episode.lines) lines += (lines.empty() ? "" : "\n") + line_text;
  nodes.push_back(Code{std::move(lines)});
  return nodes;
}

}  // namespace

Nodes LongTermDocument(const Contents& contents) {
  const mind::LongTermFacts& facts = contents.long_term.facts;
  Tabs tabs{"pages", {}};
  if (const std::size_t episode = contents.episode.number; episode != 0) {
    tabs.first = 2;
    tabs.reason = "episode " + std::to_string(episode);
  }
  tabs.pages.push_back(
      {"Known " + std::to_string(facts.objects), "Objects of semantic memory, the most active first", Known(contents)});
  tabs.pages.push_back({"Recalled " + std::to_string(contents.recalls == nullptr ? 0 : contents.recalls->count()),
                        "What rules asked of long-term memory, what came, and why", Recalled(contents)});
  tabs.pages.push_back(
      {"Episodes " + std::to_string(facts.episodes), "What episodic memory holds", EpisodesPart(contents)});
  return {std::move(tabs)};
}

}  // namespace soarbox::workbench::document
