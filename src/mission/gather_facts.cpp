// SPDX-License-Identifier: BSD-2-Clause
#include "mission/gather_facts.h"

#include <algorithm>
#include <cmath>

#include "explain/inspector.h"
#include "explain/learning_facts.h"
#include "mind/decision_codec.h"
#include "mission/check_sentences.h"
#include "sim/arena.h"
#include "wording/decision_text.h"
#include "wording/mind_words.h"
#include "world/world.h"

namespace soarbox::mission {
namespace {

PlaceFacts PlaceOf(const sim::Waypoint& waypoint) {
  return {waypoint.name, waypoint.position, 0, 0, 0};
}
PlaceFacts PlaceOf(const sim::Region& region) {
  return {region.name, region.center, region.radius_m, region.half_x_m, region.half_z_m};
}

/// If an agent moves by more metres than this in a tick, a script has placed it there. This does not count as distance.
constexpr double kPlacedElsewhere = 2;

std::string ImpasseName(const mind::StateMade& state) {
  if (state.reason == mind::StateReason::kNoChange) return state.on_operator ? "operator-no-change" : "state-no-change";
  return std::string(wording::ReasonName(state.reason));
}

void TellDecision(std::string_view packed, OperatorFact& selected) {
  const std::optional<mind::Decision> decision = mind::Unpack(packed);
  if (!decision || decision->empty()) return;
  selected.why = wording::WhySelected(*decision);
  // If preferences dropped some operators and chance selected one of the rest, "preference" is reported.
  selected.selected_by = decision->operators.size() < 2                        ? "only"
                         : decision->left.size() == decision->operators.size() ? "chance"
                                                                               : "preference";
}

/// Adds the candidates, and why none was selected.
void TellImpasse(std::string_view packed, EventFact& impasse) {
  const std::optional<mind::Decision> decision = mind::Unpack(packed);
  if (!decision || decision->empty()) return;
  const auto add = [&impasse](const mind::Decision::Operator& candidate) {
    impasse.with.emplace_back("operator", candidate.name.empty() ? candidate.id : candidate.name);
  };
  // Operators that were dropped are not candidates. In a constraint failure, all were dropped.
  if (decision->left.empty()) std::ranges::for_each(decision->operators, add);
  for (const mind::Decision::Chance& left : decision->left)
    if (left.op < decision->operators.size()) add(decision->operators[left.op]);
  impasse.reason = wording::WhyNothing(*decision);
}

std::string ValueText(const world::Message::Value& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return std::to_string(*whole);
  if (const auto* number = std::get_if<double>(&value)) return NumberText(*number);
  return std::get<std::string>(value);
}

/// The parameters of a command that a condition can test. Those of objects have paths.
std::vector<std::pair<std::string, std::string>> ParametersOf(const mind::CommandSaid& command) {
  std::vector<std::pair<std::string, std::string>> with;
  std::vector<std::string> path;
  for (const mind::Parameter& parameter : command.parameters) {
    path.resize(parameter.depth);
    std::string name = (path.empty() ? "" : path.back() + ".") + std::string(parameter.attribute);
    if (parameter.is_object) {
      path.push_back(std::move(name));
    } else {
      with.emplace_back(std::move(name), wording::ValueText(parameter.value));
    }
  }
  return with;
}

}  // namespace

FactGatherer::FactGatherer(sim::Simulation& simulation, Wants wants)
    : simulation_(simulation), wants_(std::move(wants)) {}

std::size_t FactGatherer::IndexOf(std::string_view name) const {
  for (std::size_t i = 0; i < facts_.agents.size(); ++i)
    if (facts_.agents[i].name == name) return i;
  return facts_.agents.size();
}

const TickFacts& FactGatherer::Gather(const sim::EventList& events) {
  facts_.tick = simulation_.tick();
  facts_.time_s = simulation_.time_s();
  if (!is_begun_) {
    for (const sim::Waypoint& waypoint : simulation_.arena().places().waypoints)
      facts_.waypoints.push_back(PlaceOf(waypoint));
    for (const sim::Region& region : simulation_.arena().places().regions) facts_.regions.push_back(PlaceOf(region));
  }
  facts_.problems.clear();
  GatherBodies();
  GatherItems();
  GatherEvents(events);
  GatherMessages();
  if (wants_.notes || wants_.firings || wants_.insight) GatherMinds();
  is_begun_ = true;
  return facts_;
}

void FactGatherer::GatherBodies() {
  const world::World& world = simulation_.world();
  const auto actors = simulation_.arena().actors();
  std::size_t next_actor = 0;
  // Both lists are sorted by ascending id. Agents that have left the world are reported as dead.
  for (const world::EntityId id : world.AgentIds()) {
    auto at = std::lower_bound(ids_.begin(), ids_.end(), world::Number(id));
    if (at == ids_.end() || *at != world::Number(id)) {
      const auto place = at - ids_.begin();
      ids_.insert(at, world::Number(id));
      facts_.agents.insert(facts_.agents.begin() + place, AgentFacts{});
      memories_.insert(memories_.begin() + place, Memory{});
      at = ids_.begin() + place;
      facts_.agents[static_cast<std::size_t>(place)].health = static_cast<double>(world.FindAgent(id)->Health());
      facts_.agents[static_cast<std::size_t>(place)].position = world.FindAgent(id)->Position();
    }
  }
  for (std::size_t i = 0; i < ids_.size(); ++i) {
    AgentFacts& facts = facts_.agents[i];
    facts.events.clear();
    const world::EntityId id{ids_[i]};
    const world::Agent* body = world.FindAgent(id);
    if (body == nullptr || body->IsGone()) {
      facts.alive = false;
      facts.speed = 0;
      facts.sees.clear();
      facts.carried.clear();
      continue;
    }
    facts.name = body->name();
    facts.team = body->Team();
    const auto health = static_cast<double>(body->Health());
    facts.damage += std::max(0.0, facts.health - health);
    facts.health = health;
    facts.alive = health > 0;
    if (const std::optional<float> score = body->Score()) facts.score = static_cast<double>(*score);
    const world::Vec3 moved = body->Position() - facts.position;
    facts.speed = std::hypot(static_cast<double>(body->Velocity().x), static_cast<double>(body->Velocity().z));
    const double walked = std::hypot(static_cast<double>(moved.x), static_cast<double>(moved.z));
    if (walked < kPlacedElsewhere) facts.distance += walked;
    facts.position = body->Position();
    while (next_actor < actors.size() && actors[next_actor]->id() < id) ++next_actor;
    if (next_actor == actors.size() || actors[next_actor]->id() != id) continue;
    sim::Actor& actor = *actors[next_actor];
    if (actor.weapon()) facts.ammunition = actor.weapon()->rounds() + actor.weapon()->reserve();
    facts.carried.clear();
    for (const sim::CarriedThing& thing : actor.carried()) facts.carried.push_back(thing.name);
    if (actor.running().empty() && facts.alive && is_begun_) facts.idle += static_cast<double>(world.settings().step_s);
    facts.sees.clear();
    for (const auto& [other, contact] : actor.contacts())
      if (const world::Agent* seen = contact.visible ? world.FindAgent(other) : nullptr)
        facts.sees.push_back(seen->name());
    for (const auto& [other, thing] : actor.things())
      if (thing.visible) facts.sees.push_back(thing.name);
    for (const sim::Happening& happening : actor.happenings()) {
      if (happening.number <= memories_[i].happened) continue;
      memories_[i].happened = happening.number;
      if (happening.type == "collision") facts.events.push_back({Key::kCollides, happening.by, {}, {}, {}});
      if (happening.type == "hit") facts.events.push_back({Key::kHitBy, happening.by, {}, {}, {}});
    }
  }
}

void FactGatherer::GatherItems() {
  const sim::Places& places = simulation_.arena().places();
  for (const auto& [id, item] : places.items) {
    const auto name = places.object_names.find(id);
    if (name == places.object_names.end()) continue;
    const auto at = std::find_if(facts_.items.begin(), facts_.items.end(),
                                 [&](const ItemFacts& known) { return known.name == name->second; });
    ItemFacts& known = at != facts_.items.end() ? *at : facts_.items.emplace_back();
    known.name = name->second;
    if (const world::Object* object = simulation_.world().FindObject(id)) known.position = object->Position();
  }
  for (ItemFacts& item : facts_.items) {
    item.carried = false;
    for (const AgentFacts& agent : facts_.agents) {
      if (std::find(agent.carried.begin(), agent.carried.end(), item.name) == agent.carried.end()) continue;
      item.carried = true;
      item.position = agent.position;
    }
  }
}

bool IsProblem(const sim::RunEvent& event) {
  const bool is_diagnostic = event.kind == sim::EventKind::kDiagnostic || event.kind == sim::EventKind::kAgentFailed ||
                             event.kind == sim::EventKind::kMindFailed;
  return is_diagnostic && event.diagnostic.severity != Severity::kNote;
}

std::string ProblemText(const Diagnostic& diagnostic) {
  const std::string text = Format(diagnostic);
  return text.substr(0, text.find('\n'));
}

void FactGatherer::GatherEvents(const sim::EventList& events) {
  for (const sim::RunEvent& event : events) {
    if (event.kind == sim::EventKind::kEnded) facts_.ended.push_back(event.text);
    if (IsProblem(event)) {
      const bool is_error = event.diagnostic.severity == Severity::kError;
      facts_.problems.push_back({Key::kProblem, is_error ? "error" : "warning", {}, {}, ProblemText(event.diagnostic)});
    }
    const std::size_t index = IndexOf(event.agent);
    if (index == facts_.agents.size()) continue;
    AgentFacts& agent = facts_.agents[index];
    if (event.kind == sim::EventKind::kLog) agent.events.push_back({Key::kPrints, event.text, {}, {}, {}});
    if (event.kind == sim::EventKind::kNews && event.news == "shoots") {
      agent.rounds += 1;
      constexpr std::string_view kHits = "hits ";
      if (event.text.starts_with(kHits))
        agent.events.push_back({Key::kHits, event.text.substr(kHits.size()), {}, {}, {}});
    }
  }
}

void FactGatherer::GatherMessages() {
  const world::MessageBoard& board = simulation_.arena().board();
  for (std::size_t i = board.FirstAfter(messages_); i < board.messages().size(); ++i) {
    const world::Message& message = board.messages()[i];
    const auto at = std::find(ids_.begin(), ids_.end(), world::Number(message.from));
    if (at == ids_.end()) continue;
    EventFact event{Key::kMessage, message.about, {}, {}, {}};
    for (const world::Message::Field& field : message.fields)
      event.with.emplace_back(field.name, ValueText(field.value));
    const world::Agent* to = simulation_.world().FindAgent(message.to);
    event.with.emplace_back("to", to != nullptr ? to->name() : "all");
    facts_.agents[static_cast<std::size_t>(at - ids_.begin())].events.push_back(std::move(event));
  }
  messages_ = board.posted();
}

void FactGatherer::GatherMinds() {
  for (std::size_t i = 0; i < simulation_.soar_agents(); ++i) {
    const std::size_t agent = IndexOf(simulation_.AgentOfMind(i));
    if (agent == facts_.agents.size()) continue;
    facts_.agents[agent].has_mind = true;
    ReadEvents(simulation_.Mind(i).events, agent);
    if (wants_.insight && (facts_.agents[agent].alive || !is_begun_)) Inspect(facts_.agents[agent], agent);
  }
}

void FactGatherer::GatherInsight() {
  for (std::size_t i = 0; i < simulation_.soar_agents(); ++i) {
    const std::size_t agent = IndexOf(simulation_.AgentOfMind(i));
    if (agent < facts_.agents.size()) Inspect(facts_.agents[agent], agent);
  }
}

void FactGatherer::ReadEvents(const mind::EventLog& events, std::size_t agent) {
  AgentFacts& facts = facts_.agents[agent];
  Memory& memory = memories_[agent];
  facts.operators.clear();
  for (std::size_t level = 0; level < memory.selected.size(); ++level)
    if (!memory.selected[level].name.empty()) facts.operators.push_back(memory.selected[level]);
  const auto leave = [&](int level) {
    if (level > 0 && memory.selected.size() >= static_cast<std::size_t>(level))
      memory.selected.resize(static_cast<std::size_t>(level - 1));
  };
  events.ForEach(
      mind::Cases{[&](const mind::OperatorSelected& selected) {
                    if (selected.level < 1 || selected.level > 1000) return;
                    leave(selected.level);
                    memory.selected.resize(static_cast<std::size_t>(selected.level));
                    OperatorFact chosen{
                        selected.level, std::string(selected.name.empty() ? selected.id : selected.name), {}, {}, {}};
                    if (wants_.insight) {
                      if (const auto inspector = simulation_.Inspect(facts.name)) {
                        for (const explain::ElementFact& element : inspector->ElementsOf(selected.id))
                          chosen.with.emplace_back(element.attribute, element.value);
                      }
                    }
                    if (wants_.decisions) TellDecision(selected.decision, chosen);
                    memory.selected.back() = chosen;
                    facts.operators.push_back(std::move(chosen));
                  },
                  [&](const mind::StateMade& state) {
                    leave(state.level);
                    if (state.level <= 1) return;
                    facts.events.push_back({Key::kImpasse, ImpasseName(state), {}, {}, {}});
                    if (wants_.decisions) TellImpasse(state.decision, facts.events.back());
                  },
                  [&](const mind::StateGone& state) { leave(state.level); },
                  [&](const mind::CommandSaid& said) {
                    EventFact event{Key::kCommand, std::string(said.name), ParametersOf(said), {}, {}};
                    if (const auto under_way = memory.under_way.find(event.word);
                        under_way != memory.under_way.end() && under_way->second == event.with)
                      facts.repeats += 1;
                    memory.under_way[event.word] = event.with;
                    memory.last_said[event.word] = event.with;
                    facts.events.push_back(std::move(event));
                  },
                  [&](const mind::CommandEnded& ended) {
                    EventFact event{Key::kCommand,
                                    std::string(ended.name),
                                    {},
                                    std::string(wording::StatusName(ended.status)),
                                    std::string(ended.fault)};
                    if (const auto said = memory.last_said.find(event.word); said != memory.last_said.end())
                      event.with = said->second;
                    memory.under_way.erase(event.word);
                    facts.events.push_back(std::move(event));
                  },
                  [&](const mind::Recalled& recalled) {
                    memory.notes_recalls = true;
                    facts.events.push_back({Key::kRetrieval,
                                            recalled.is_episode ? "episodic" : "semantic",
                                            {},
                                            recalled.number == 0 ? "failure" : "success",
                                            {}});
                  },
                  [&](const mind::RuleFired& fired) {
                    if (!fired.retracts) facts.events.push_back({Key::kRule, std::string(fired.rule), {}, {}, {}});
                  },
                  [](const auto&) {}});
}

void FactGatherer::GatherRetrievals(explain::Inspector& inspector, const std::vector<explain::StateFact>& stack,
                                    AgentFacts& facts, Memory& memory) {
  // If a kernel does not report recalls, only the answer at the end of a tick is known: an element below ^smem.result
  // or ^epmem.result. A new answer has a new time tag.
  constexpr std::pair<std::string_view, std::string_view> kMemories[] = {{"smem", "semantic"}, {"epmem", "episodic"}};
  const auto objects = [&](const std::string& id, std::string_view attribute) {
    std::vector<std::string> found;
    for (const explain::ElementFact& element : inspector.ElementsOf(id))
      if (element.attribute == attribute && element.is_object) found.push_back(element.value);
    return found;
  };
  std::uint64_t newest = memory.answered_timetag;
  for (const explain::StateFact& state : stack) {
    for (const auto& [link, name] : kMemories) {
      for (const std::string& memory_link : objects(state.id, link)) {
        for (const std::string& result : objects(memory_link, "result")) {
          const std::vector<explain::ElementFact> answers = inspector.ElementsOf(result);
          const bool is_retrieved =
              std::ranges::find(answers, "retrieved", &explain::ElementFact::attribute) != answers.end();
          for (const explain::ElementFact& answer : answers) {
            if (answer.timetag <= memory.answered_timetag) continue;
            // A `success` counts only if an object was retrieved: storing is also answered with it.
            if (!(answer.attribute == "success" && is_retrieved) && answer.attribute != "failure") continue;
            newest = std::max(newest, answer.timetag);
            facts.events.push_back({Key::kRetrieval, std::string(name), {}, answer.attribute, {}});
          }
        }
      }
    }
  }
  memory.answered_timetag = newest;
}

void FactGatherer::Inspect(AgentFacts& facts, std::size_t agent) {
  const std::unique_ptr<explain::Inspector> inspector = simulation_.Inspect(facts.name);
  if (inspector == nullptr) return;
  const explain::MindFacts mind = inspector->Mind();
  facts.decisions = static_cast<double>(mind.decisions);
  facts.firings = static_cast<double>(mind.firings);
  facts.elements = static_cast<double>(mind.elements);
  const std::vector<explain::StateFact> stack = inspector->Stack();
  facts.depth = static_cast<double>(stack.size());
  Memory& memory = memories_[agent];
  if (wants_.numbers) {
    if (auto* const source = dynamic_cast<explain::LearningSource*>(inspector.get())) {
      const explain::LearningFacts learning = source->Learning();
      facts.reward = learning.total_reward;
      facts.updates = 0;
      for (const explain::NumberFact& number : learning.numbers) facts.updates += static_cast<double>(number.updates);
      facts.values = static_cast<double>(learning.numbers.size());
    }
  }
  if (wants_.retrievals && !memory.notes_recalls) GatherRetrievals(*inspector, stack, facts, memory);
  if (wants_.learned) {
    double reused = 0;
    for (const explain::RuleFact& rule : inspector->Rules())
      if (rule.type == "chunk") reused += static_cast<double>(rule.firings);
    facts.reused = std::max(facts.reused, reused);
  }
  if (!memory.knows_rules || memory.rules != mind.rules) {
    // Learned rules that were excised still count.
    double learned = 0;
    for (const explain::RuleFact& rule : inspector->Rules()) learned += rule.type == "chunk" ? 1 : 0;
    facts.learned = std::max(facts.learned, learned);
    memory.rules = mind.rules;
    memory.knows_rules = true;
  }
  facts.answered = 0;
  if (!mind.output_link.empty()) {
    for (const explain::ElementFact& command : inspector->ElementsOf(mind.output_link)) {
      if (!command.is_object) continue;
      for (const explain::ElementFact& below : inspector->ElementsOf(command.value)) {
        if (below.attribute != "status" ||
            (below.value != "complete" && below.value != "error" && below.value != "interrupted"))
          continue;
        facts.answered += 1;
        break;
      }
    }
  }
  facts.found.clear();
  for (std::size_t i = 0; i < wants_.elements.size() && !stack.empty(); ++i) {
    std::vector<std::string> at = {stack.front().id};
    std::string_view path = wants_.elements[i];
    if (constexpr std::string_view kBelow = "substate."; path.starts_with(kBelow)) {
      at.clear();
      for (std::size_t below = 1; below < stack.size(); ++below) at.push_back(stack[below].id);
      path.remove_prefix(kBelow.size());
    }
    while (!at.empty()) {
      const std::size_t dot = path.find('.');
      const std::string_view attribute = path.substr(0, dot);
      std::vector<std::string> next;
      for (const std::string& id : at) {
        for (const explain::ElementFact& element : inspector->ElementsOf(id)) {
          if (element.attribute != attribute || element.acceptable) continue;
          if (dot != std::string_view::npos) {
            if (element.is_object) next.push_back(element.value);
            continue;
          }
          char support = 'i';
          for (const explain::MakerFact& maker : inspector->MakersOf(element.timetag))
            if (maker.kind != explain::MakerFact::Kind::kRule || maker.o_supported) support = 'o';
          facts.found.push_back({i, element.value, support});
        }
      }
      if (dot == std::string_view::npos) break;
      path.remove_prefix(dot + 1);
      at = std::move(next);
    }
  }
}

}  // namespace soarbox::mission
