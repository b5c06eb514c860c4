// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/longterm/episode_commands.h"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <unordered_map>

#include "kernel/base/known_symbols.h"
#include "kernel/base/symbol_table.h"
#include "kernel/decide/goal_stack.h"
#include "kernel/decide/observers.h"
#include "kernel/decide/preference_changes.h"
#include "kernel/longterm/long_term.h"
#include "kernel/longterm/recall_words.h"
#include "kernel/longterm/wm_activation.h"
#include "kernel/memory/working_memory.h"

namespace soarbox::kernel {

// Reading commands ----------------------------------------------------------------------------------------------------

EpisodeCommands::Reach EpisodeCommands::ReachOf(Symbol root) const {
  Reach reach;
  std::unordered_map<std::uint32_t, std::uint32_t> known;
  const auto number = [&](Symbol id) {
    const auto [found, is_new] = known.try_emplace(id.index(), static_cast<std::uint32_t>(reach.objects.size()));
    if (is_new) reach.objects.push_back(id);
    return found->second;
  };
  number(root);
  for (std::uint32_t object = 0; object < reach.objects.size(); ++object) {
    for (const WmeId wme : uses_.memory.WmesOf(reach.objects[object])) {
      const Symbol value = uses_.memory.wme(wme).value;
      reach.elements.push_back({wme, object, value.IsIdentifier() ? number(value) : 0});
    }
  }
  return reach;
}

bool EpisodeCommands::ReadElement(Command& command, Symbol attribute, Symbol value) const {
  if (!attribute.IsString()) return false;
  const std::string_view name = uses_.symbols.Text(attribute);
  const auto kind = [&](Kind kind) {
    if (command.kind != Kind::kNone) return false;
    command.kind = kind;
    command.argument = value;
    return kind == Kind::kRetrieve || value.IsIdentifier();
  };
  const std::int64_t number = value.IsInteger() ? uses_.symbols.IntegerValue(value) : 0;
  if (name == "next") return kind(Kind::kNext);
  if (name == "previous") return kind(Kind::kPrevious);
  if (name == "query") return kind(Kind::kQuery);
  if (name == "retrieve") {
    command.number = number;
    return command.number > 0 && kind(Kind::kRetrieve);
  }
  if (name == "neg-query") {
    if (!command.negative.IsNone() || !value.IsIdentifier()) return false;
    command.negative = value;
    return true;
  }
  if (!value.IsInteger()) return false;
  command.refined = true;
  if (name == "before") {
    // Numbers below 1 have no effect.
    if (number > 0) command.before = std::min(number, command.before.value_or(number));
    return true;
  }
  if (name == "after") {
    // After a negative number no episode qualifies.
    const std::int64_t after = number < 0 ? std::numeric_limits<std::int64_t>::max() : number;
    command.after = std::max(after, command.after.value_or(after));
    return true;
  }
  if (name != "prohibit") return false;
  if (number > 0 && number <= store_.last()) command.prohibited.push_back(static_cast<EpisodeNumber>(number));
  return true;
}

EpisodeCommands::Command EpisodeCommands::Read(const Reach& reach) const {
  Command command;
  bool good = true;
  for (const Reach::Element& element : reach.elements) {
    if (element.object != 0) break;
    const Wme& wme = uses_.memory.wme(element.wme);
    good = good && ReadElement(command, wme.attribute, wme.value);
  }
  if ((command.refined || !command.negative.IsNone()) && command.kind != Kind::kQuery) good = false;
  const bool endless = command.after == std::numeric_limits<std::int64_t>::max();
  if (command.before && command.after && !endless && *command.before <= *command.after) {
    command.is_counted = good && command.kind == Kind::kQuery;
    good = false;
  }
  if (!good) command.kind = Kind::kMalformed;
  std::sort(command.prohibited.begin(), command.prohibited.end());
  return command;
}

EpisodeCue EpisodeCommands::CueOf(const Reach& reach) const {
  std::vector<EpisodeCueElement> elements;
  const WmActivation* activation = settings_.balance < 1 ? WmActivation::Find(uses_.long_term) : nullptr;
  for (const Reach::Element& element : reach.elements) {
    const Wme& wme = uses_.memory.wme(element.wme);
    EpisodeCueElement& made = elements.emplace_back();
    made.object = element.object;
    if (wme.acceptable) {
      made.attribute = terms_.Find("operator*");
    } else if (wme.attribute.IsConstant()) {
      made.attribute = terms_.Find(uses_.symbols, wme.attribute);
    }
    if (activation != nullptr) made.weight = activation->Of(element.wme);
    made.value_is_object = wme.value.IsIdentifier();
    made.value = made.value_is_object ? element.value : terms_.Find(uses_.symbols, wme.value);
  }
  return EpisodeCue(elements, static_cast<std::uint32_t>(reach.objects.size()));
}

// Executing commands --------------------------------------------------------------------------------------------------

Symbol EpisodeCommands::Word(const char* text) const {
  return uses_.symbols.String(text);
}

void EpisodeCommands::Say(Output& output, GoalLevel level, const char* attribute, Symbol value) const {
  output.results.push_back({uses_.goals.at(level).epmem.result, Word(attribute), value});
}

std::vector<std::pair<EpisodeNode, Symbol>> EpisodeCommands::Recall(GoalLevel level, EpisodeNumber episode,
                                                                    Output& output) {
  std::vector<EpisodeFact> facts = store_.Replay(episode);
  std::stable_sort(facts.begin(), facts.end(),
                   [&](EpisodeFact a, EpisodeFact b) { return store_.triple(a).parent < store_.triple(b).parent; });
  struct Content {
    Triple triple;
    EpisodeFact fact;
    bool links;
  };
  std::vector<Content> contents;
  std::vector<std::pair<EpisodeNode, Symbol>> objects;
  std::unordered_map<EpisodeNode, Symbol> known;
  const auto object = [&](EpisodeNode node, EpisodeTerm attribute) {
    const auto [found, is_new] = known.try_emplace(node);
    if (is_new) {
      // An identifier gets the first letter of the attribute that refers to it, but never the letter of states.
      char letter = terms_.kind(attribute) == TermKind::kString && !terms_.Text(attribute).empty()
                        ? terms_.Text(attribute)[0]
                        : 'I';
      if (letter >= 'a' && letter <= 'z') letter = static_cast<char>(letter - 'a' + 'A');
      if (letter < 'A' || letter > 'Z' || letter == 'S') letter = 'I';
      found->second = installer_.NewIdentifier(letter, level, store_.Link(node, episode));
      objects.emplace_back(node, found->second);
    }
    return found->second;
  };
  objects.emplace_back(0, installer_.NewIdentifier('R', level));
  known.emplace(0, objects.front().second);
  for (std::size_t n = 0; n < objects.size(); ++n) {
    const auto [node, id] = objects[n];
    auto fact = std::lower_bound(facts.begin(), facts.end(), node,
                                 [&](EpisodeFact f, EpisodeNode parent) { return store_.triple(f).parent < parent; });
    for (; fact != facts.end() && store_.triple(*fact).parent == node; ++fact) {
      const EpisodeTriple triple = store_.triple(*fact);
      const Symbol value = triple.value.IsNode() ? object(triple.value.node(), triple.attribute)
                                                 : terms_.ToSymbol(uses_.symbols, triple.value.term());
      contents.push_back({{id, terms_.ToSymbol(uses_.symbols, triple.attribute), value}, *fact, triple.value.IsNode()});
    }
  }
  // Elements are created in the reverse order of this list: links before constants, the oldest facts first. Only the
  // values of one attribute are created newest first. (What Soar lists last is created first.)
  std::ranges::sort(contents,
                    [](const Content& a, const Content& b) { return a.links != b.links ? b.links : a.fact > b.fact; });
  for (const Content& content : contents) output.contents.push_back(content.triple);
  counters_.last_retrieval_wmes = output.contents.size();
  states_[level - 1u].retrieved = episode;
  return objects;
}

std::vector<std::uint32_t> EpisodeCommands::ListingOrder(const EpisodeCue& positive, const EpisodeCue& negative) {
  std::vector<std::uint32_t> taken;  // For the cue itself, then for its elements.
  for (std::size_t n = 1 + positive.edges().size() + negative.edges().size(); n > 0; --n) {
    if (free_places_.empty()) {
      taken.push_back(places_++);
    } else {
      taken.push_back(free_places_.back());
      free_places_.pop_back();
    }
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> listed;
  for (std::uint32_t edge = 0; edge < positive.edges().size(); ++edge) {
    if (positive.edge(edge).to != EpisodeCue::kNoVariable) listed.emplace_back(taken[edge + std::size_t{1}], edge);
  }
  std::sort(listed.begin(), listed.end());
  std::sort(taken.begin(), taken.end());
  free_places_.insert(free_places_.end(), taken.begin(), taken.end());
  std::vector<std::uint32_t> order;
  for (const auto& [place, edge] : listed) order.push_back(edge);
  return order;
}

void EpisodeCommands::Tell(GoalLevel level, EpisodeNumber episode, std::string_view question,
                           std::string_view reason) const {
  RecallInfo info;
  info.level = level;
  info.is_episode = true;
  info.number = episode;
  info.question = question;
  info.reason = reason;
  uses_.observers.Notify(Event::kRecall, [&](Observer& o) { o.OnRecall(uses_.agent, info); });
}

void EpisodeCommands::TellQuery(GoalLevel level, const Command& command, const EpisodeQuery& query,
                                const EpisodeAnswer& answer) const {
  if (!uses_.observers.Wants(Event::kRecall)) return;
  constexpr int kDepth = 5;
  std::string question = CueWords(uses_.memory, uses_.symbols, command.argument, kDepth);
  if (!command.negative.IsNone())
    question += " and not " + CueWords(uses_.memory, uses_.symbols, command.negative, kDepth);
  if (command.before) question += " before episode " + std::to_string(*command.before);
  if (command.after) question += " after episode " + std::to_string(*command.after);
  std::string reason;
  const std::int64_t leaves = query.positive.leaf_count();
  if (answer.episode == 0) {
    reason =
        store_.last() == 0 ? "there are no episodes yet" : "no episode that may be searched has any part of the cue";
  } else if (answer.graph_matched) {
    reason = "the latest episode that matches the entire cue";
  } else if (answer.cardinality >= leaves && query.negative.leaf_count() == 0) {
    reason = "the latest that matches each part of the cue, but not all parts together";
  } else {
    char score[40];
    std::snprintf(score, sizeof score, "%g", answer.score);
    reason = "no episode matches the entire cue; this one matches most of it: " + std::to_string(answer.cardinality) +
             " of " + std::to_string(leaves) + " parts, score " + score;
  }
  Tell(level, answer.episode, question, reason);
}

void EpisodeCommands::TraceQuery(const EpisodeQuery& query) const {
  const auto word = [](bool is_so) { return is_so ? "true" : "false"; };
  for (const SurfaceStep& step : StepsOf(store_, query)) {
    uses_.observers.Print(std::string("NEW KING (perfect, graph-match): (") + word(step.is_perfect) + ", " +
                          word(step.ends_search) + ")\n");
  }
}

void EpisodeCommands::Query(GoalLevel level, const Command& command, Output& output) {
  ++counters_.queries;
  const Reach positive = ReachOf(command.argument);
  EpisodeQuery query;
  query.positive = CueOf(positive);
  if (!command.negative.IsNone()) query.negative = CueOf(ReachOf(command.negative));
  query.graph_match = settings_.graph_match;
  query.window.last = store_.last();
  if (command.before) {
    query.window.last = static_cast<EpisodeNumber>(
        std::clamp<std::int64_t>(*command.before - 1, 0, static_cast<std::int64_t>(store_.last())));
  }
  if (command.after) {
    query.window.first = static_cast<EpisodeNumber>(
        std::clamp<std::int64_t>(*command.after, 0, static_cast<std::int64_t>(store_.last())) + 1);
  }
  query.window.prohibited = command.prohibited;
  if (traced_) TraceQuery(query);
  const EpisodeAnswer answer = Answer(store_, query);
  TellQuery(level, command, query, answer);
  const std::vector<std::uint32_t> order = ListingOrder(query.positive, query.negative);
  counters_.query_positive = query.positive.edges().size();
  counters_.query_negative = query.negative.edges().size();
  counters_.query_literals = counters_.query_positive + counters_.query_negative;
  // If nothing was found, the last result is kept.
  if (answer.episode != 0) {
    counters_.query_retrieved = answer.episode;
    counters_.query_cardinality = answer.cardinality;
  }
  const char* outcome = answer.episode == 0 ? "failure" : "success";
  if (answer.episode == 0) {
    if (!command.negative.IsNone()) Say(output, level, outcome, command.negative);
    Say(output, level, outcome, command.argument);
    return;
  }
  SymbolTable& symbols = uses_.symbols;
  Symbol mapping;
  std::vector<Symbol> pairs;
  if (answer.graph_matched) {
    mapping = installer_.NewIdentifier('M', level);
    for (std::size_t n = 0; n < order.size(); ++n) pairs.push_back(installer_.NewIdentifier('N', level));
  }
  const auto objects = Recall(level, answer.episode, output);
  const auto variable = [&](std::size_t n) { return query.positive.edge(order[n]).to; };
  // What Soar lists last is created first. Within one attribute, the last one is listed first. If several links of the
  // cue match the same node, only the last of their pairs gets ^retrieved.
  std::map<EpisodeNode, std::size_t, std::greater<>> listed;
  for (std::size_t n = 0; n < pairs.size(); ++n) listed[answer.nodes[variable(n)]] = n;
  for (const auto& [node, n] : listed) {
    const auto found = std::ranges::find(objects, node, &std::pair<EpisodeNode, Symbol>::first);
    output.results.push_back({pairs[n], Word("retrieved"), found->second});
  }
  Say(output, level, "present-id", symbols.Integer(store_.last() + std::int64_t{1}));
  Say(output, level, "memory-id", symbols.Integer(answer.episode));
  Say(output, level, "retrieved", objects.front().second);
  for (std::size_t n = pairs.size(); n-- > 0;) {
    const Symbol asked = positive.objects[query.positive.ObjectOf(variable(n))];
    output.results.push_back({pairs[n], Word("cue"), asked});
    output.results.push_back({mapping, Word("node"), pairs[n]});
  }
  if (answer.graph_matched) Say(output, level, "mapping", mapping);
  if (settings_.graph_match) Say(output, level, "graph-match", symbols.Integer(answer.graph_matched ? 1 : 0));
  if (!command.negative.IsNone()) Say(output, level, outcome, command.negative);
  Say(output, level, outcome, command.argument);
  const double perfect = query.positive.leaf_weight();
  Say(output, level, "normalized-match-score", symbols.Float(perfect == 0 ? answer.score : answer.score / perfect));
  Say(output, level, "match-score", symbols.Float(answer.score));
  Say(output, level, "match-cardinality", symbols.Integer(answer.cardinality));
  Say(output, level, "cue-size", symbols.Integer(query.positive.leaf_count() + query.negative.leaf_count()));
}

void EpisodeCommands::Execute(GoalLevel level, const Command& command, Output& output) {
  if (command.kind == Kind::kNone) return;
  if (command.is_counted) ++counters_.queries;
  if (command.kind == Kind::kMalformed) return Say(output, level, "status", Word("bad-cmd"));
  if (command.kind == Kind::kQuery) return Query(level, command, output);
  State& state = states_[level - 1u];
  std::int64_t wanted = command.number;
  if (command.kind == Kind::kRetrieve) {
    ++counters_.retrievals;
  } else if (command.kind == Kind::kNext) {
    ++counters_.nexts;
    wanted = state.retrieved == 0 ? 0 : state.retrieved + std::int64_t{1};
  } else {
    ++counters_.previous;
    wanted = state.retrieved == 0 ? 0 : state.retrieved - std::int64_t{1};
  }
  const bool there = wanted > 0 && wanted <= store_.last();
  if (uses_.observers.Wants(Event::kRecall)) {
    const bool by_number = command.kind == Kind::kRetrieve;
    const std::string from = "episode " + std::to_string(state.retrieved);
    const std::string question = by_number                     ? "episode " + std::to_string(wanted)
                                 : command.kind == Kind::kNext ? std::string("the next episode")
                                                               : std::string("the episode before");
    const std::string reason = there
                                   ? (by_number ? "asked for by its number"
                                                : (command.kind == Kind::kNext ? "it follows " : "it precedes ") + from)
                               : by_number || state.retrieved != 0 ? std::string("there is no such episode")
                                                                   : std::string("no episode was retrieved before");
    Tell(level, there ? static_cast<EpisodeNumber>(wanted) : 0, question, reason);
  }
  if (there) {
    const auto objects = Recall(level, static_cast<EpisodeNumber>(wanted), output);
    Say(output, level, "present-id", uses_.symbols.Integer(store_.last() + std::int64_t{1}));
    Say(output, level, "memory-id", uses_.symbols.Integer(wanted));
    Say(output, level, "retrieved", objects.front().second);
  } else {
    state.retrieved = 0;
    Say(output, level, "retrieved", Word("no-memory"));
  }
  if (command.kind != Kind::kRetrieve) Say(output, level, there ? "success" : "failure", command.argument);
}

bool EpisodeCommands::ProcessState(GoalLevel level) {
  if (states_.size() < level) states_.resize(level);
  const MemoryLink& link = uses_.goals.at(level).epmem;
  const Reach reach = ReachOf(link.command);
  State& state = states_[level - 1u];
  std::uint64_t newest = 0;
  for (const Symbol object : reach.objects) watch_.Watch(object);
  for (const Reach::Element& element : reach.elements) {
    newest = std::max(newest, uses_.memory.wme(element.wme).timetag);
  }
  if (newest == state.newest && reach.elements.size() == state.count) return false;
  state.newest = newest;
  state.count = reach.elements.size();
  const bool had = !state.made.empty();
  installer_.Retract(state.made);
  const Command command = Read(reach);
  Output output;
  Execute(level, command, output);
  if (output.results.empty()) return had;
  std::vector<WmeId> grounds;
  for (const Reach::Element& element : reach.elements) grounds.push_back(element.wme);
  installer_.Install(level, grounds, output.results, &state.made);
  installer_.Install(level, grounds, output.contents);
  return true;
}

bool EpisodeCommands::Process() {
  if (!watch_.TakeChanged()) return false;
  bool changed = false;
  for (std::size_t level = uses_.goals.depth(); level > 0; --level) {
    changed = ProcessState(static_cast<GoalLevel>(level)) || changed;
  }
  return changed;
}

void EpisodeCommands::StateRemoved(GoalLevel level) {
  while (states_.size() >= level) {
    for (const PreferenceId preference : states_.back().made) uses_.preferences.DropReference(preference);
    states_.pop_back();
  }
}

void EpisodeCommands::ForEachHeld(const std::function<void(PreferenceId)>& visit) const {
  for (const State& state : states_) {
    for (const PreferenceId preference : state.made) visit(preference);
  }
}

void EpisodeCommands::ForgetRetrieved() {
  for (State& state : states_) state.retrieved = 0;
}

void EpisodeCommands::Clear() {
  states_.clear();
  watch_.Clear();
}

}  // namespace soarbox::kernel
