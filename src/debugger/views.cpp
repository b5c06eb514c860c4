// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/views.h"

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>

#include "debugger/facts_text.h"
#include "debugger/view_fields.h"
#include "diagnostics/problem.h"

namespace soarbox::debugger {
namespace {

constexpr ViewInfo kViews[] = {
    {"agents", "[TEXT]", "all agents, or those with this text", false},
    {"stack", "", "the goal stack and the phase", true},
    {"memory", "[ID | TIMETAG | /TEXT]", "an identifier with what is below it, an element, or a search", true},
    {"operators", "[STATE]", "candidates, preferences, and why one was selected", true},
    {"rules", "[TEXT]", "rules with firings and matches", true},
    {"rule", "RULE", "its source, and how far it matches", true},
    {"coverage", "", "which rules fired, and where the others stop", true},
    {"why", "[NAME]", "why the agent does what it does; or an operator, command or element: why, or why not", true},
    {"io", "", "input link, output link and commands", true},
    {"learning", "[TEXT | #RULE]", "values learned from reward, and learned rules; or one rule: how it was learned",
     true},
    {"longterm", "[TEXT | #EPISODE]", "what it knows, its episodes, what it recalled and why; or one episode", true},
    {"imagery", "", "what it imagines, state by state: nodes, what its rules ask, the answers, and why", true},
    {"state", "", "what the scripts of agents, or of one, show of their state: trees, states, scores, values", false},
    {"timeline", "", "operators, impasses, commands and events over ticks", false},
    {"messages", "[TEXT]", "what agents said to each other", false},
    {"trace", "[TEXT]", "what happened, line by line", false},
    {"plots", "[PATH]", "a number over ticks: health, speed, decisions, fired, or a percept's path", false},
    {"console", "COMMAND", "what a Soar command prints", true},
};

/// "there is no ...", with a similar name or the list of all names.
Diagnostic NoSuch(const std::string& what, const std::string& name, const std::vector<std::string>& known) {
  const std::vector<std::string_view> names(known.begin(), known.end());
  const std::string_view near = Suggest(name, names);
  std::string hint = near.empty() ? "there are:" : "did you mean '" + std::string(near) + "'?";
  constexpr std::size_t kMostNamed = 20;
  for (std::size_t i = 0; near.empty() && i < known.size() && i < kMostNamed; ++i) hint += " " + known[i];
  return NewProblem("there is no " + what + " '" + name + "'", known.empty() ? "" : hint);
}

/// All text that a filter searches.
std::string TextOf(const AgentRow& row) {
  return row.name + " " + row.kind + " " + row.team + " " + row.script + " " + StateText(row) + " " +
         ToText(row.last_op) + " " + row.command + " " + row.error + (row.alive ? "" : " dead") +
         (row.failed ? " failed" : "");
}

template <typename Model>
ViewText Both(const Model& model) {
  return {ToText(model), Print(JsonOf(model))};
}

/// The changes of the last tick, if they were recorded.
MemoryChanges LastChanges(const sim::Simulation& simulation, const std::string& agent) {
  for (std::size_t i = 0; i < simulation.soar_agents(); ++i) {
    const sim::MindReport report = simulation.Mind(i);
    if (report.agent == agent) return MemoryChanges(report.events);
  }
  return {};
}

std::uint64_t WholeNumber(const std::string& text) {
  std::uint64_t number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  return read.ec == std::errc() && read.ptr == text.data() + text.size() ? number : 0;
}

Result<ViewText> ShowMemory(explain::Inspector& mind, const MemoryChanges& changes, const std::string& of) {
  if (of.starts_with('/')) {
    const std::vector<explain::ElementFact> found = SearchMemory(mind, of.substr(1));
    ViewText view{{}, Print(JsonOf(found))};
    for (const explain::ElementFact& element : found)
      view.text += "(" + std::to_string(element.timetag) + ": " + Describe(element) + ")\n";
    if (found.empty()) view.text = "nothing has " + of.substr(1) + "\n";
    return view;
  }
  if (const std::uint64_t timetag = WholeNumber(of); timetag != 0) {
    const std::optional<ElementStory> story = LookAtElement(mind, timetag);
    if (!story) return NewProblem("there is no element with the time tag " + of + " now", "");
    return Both(*story);
  }
  constexpr std::size_t kDepth = 3;
  const std::vector<explain::StateFact> stack = mind.Stack();
  const std::string id = of.empty() && !stack.empty() ? stack.front().id : of;
  const MemoryObject object = LookAtObject(mind, id, changes, kDepth);
  if (!object.exists)
    return NewProblem("there is no identifier '" + id + "' now", "states are: S1 and what is below it");
  return Both(object);
}

Result<ViewText> ShowLongTerm(explain::Inspector& mind, const RecallLog* log, const std::string& of) {
  if (of.starts_with('#')) {
    const EpisodeView episode = LookAtEpisode(mind, static_cast<std::size_t>(WholeNumber(of.substr(1))));
    if (episode.number == 0) return NewProblem("there is no episode " + of.substr(1), "they are numbered from 1");
    return Both(episode);
  }
  const LongTermView view = LookAtLongTerm(mind, of);
  ViewText text{ToText(view), {}};
  Json json = JsonOf(view);
  json["recalls"] = Json::array();
  if (log != nullptr) {
    for (const Recall& recall : log->recalls()) {
      const std::string line = ToText(recall);
      if (line.find(of) == std::string::npos) continue;
      text.text += "tick " + std::to_string(recall.tick) + ": " + line + "\n";
      json["recalls"].push_back(JsonOf(recall));
    }
  }
  text.json = Print(json);
  return text;
}

Result<ViewText> ShowLearning(explain::Inspector& mind, const LearningLog* log, const std::string& of) {
  if (of.starts_with('#')) {
    const LearnedRuleView rule = LookAtLearnedRule(mind, of.substr(1), log);
    if (!rule.name.empty()) return Both(rule);
    std::vector<std::string> names;
    for (const LearnedRuleRow& row : LookAtLearning(mind).rules) names.push_back(row.name);
    return NoSuch("learned rule", of.substr(1), names);
  }
  const LearningView view = LookAtLearning(mind, of, log);
  ViewText text{ToText(view), {}};
  Json json = JsonOf(view);
  if (log != nullptr && !log->episodes().empty()) {
    text.text += ToText(log->episodes());
    json["episodes"] = JsonOf(log->episodes());
  }
  text.json = Print(json);
  return text;
}

Result<ViewText> ShowMind(const ViewSource& source, const ViewRequest& request, explain::Inspector& mind,
                          const std::string& agent) {
  const std::string& of = request.of;
  const MemoryChanges changes = LastChanges(*source.simulation, agent);
  if (request.view == "stack") return Both(LookAtStack(mind));
  if (request.view == "memory") return ShowMemory(mind, changes, of);
  if (request.view == "io") return Both(LookAtIo(mind, changes));
  if (request.view == "longterm") {
    const auto log = source.models->recalls.find(agent);
    return ShowLongTerm(mind, log == source.models->recalls.end() ? nullptr : &log->second, of);
  }
  if (request.view == "learning") {
    const auto log = source.models->learning.find(agent);
    return ShowLearning(mind, log == source.models->learning.end() ? nullptr : &log->second, of);
  }
  if (request.view == "imagery") return Both(LookAtImagery(mind));
  if (request.view == "rules") return Both(ListRules(mind, of));
  if (request.view == "operators") {
    const OperatorsView view = LookAtOperators(mind, of);
    if (!view.note.empty() && view.rows.empty() && !of.empty()) return NewProblem(view.note, "");
    return Both(view);
  }
  if (request.view == "rule") {
    if (const std::optional<RuleView> view = LookAtRule(mind, of)) return Both(*view);
    std::vector<std::string> names;
    for (const explain::RuleFact& rule : mind.Rules()) names.push_back(rule.name);
    return NoSuch("rule", of, names);
  }
  if (request.view == "coverage") {
    const auto known = source.models->coverage.find(agent);
    Coverage coverage = known == source.models->coverage.end() ? Coverage() : known->second;
    coverage.Look(mind);
    return Both(coverage.rows());
  }
  if (request.view == "why") {
    if (of.empty()) {
      WhyNode answer = WhyAgent(*source.simulation, agent);
      if (const auto log = source.models->recalls.find(agent); log != source.models->recalls.end()) {
        TellRecalls(log->second, answer);
      }
      return Both(answer);
    }
    if (const std::uint64_t timetag = WholeNumber(of); timetag != 0) return Both(WhyElement(mind, timetag));
    return Both(WhyNameOrError(*source.simulation, agent, of));
  }
  Console console(agent);
  console.Run(*source.simulation, of);
  return Both(console.lines());
}

/// Shows the recorded data of a mind that a view needs.
Result<ViewText> ShowRecorded(const ViewSource& source, const ViewRequest& request, std::string agent) {
  std::vector<std::string> minds;
  if (source.recorded != nullptr) {
    for (const world::AgentSnapshot& one : source.last->scene.agents)
      if (source.recorded->Find(one.name) != nullptr) minds.push_back(one.name);
  }
  if (agent.empty() && !minds.empty()) agent = minds.front();
  const std::unique_ptr<explain::Inspector> mind =
      source.recorded == nullptr ? nullptr : source.recorded->Inspect(agent);
  if (mind == nullptr) {
    return minds.empty() ? NewProblem("nothing is recorded of any mind",
                                      "record with --record-level decisions or all, or simulate the run again")
                         : NoSuch("recorded mind named", agent, minds);
  }
  if (request.view == "stack") return Both(LookAtStack(*mind));
  if (request.view == "memory") return ShowMemory(*mind, {}, request.of);
  if (request.view == "io") return Both(LookAtIo(*mind));
  if (request.view == "rules") return Both(ListRules(*mind, request.of));
  if (request.view == "operators") return Both(LookAtOperators(*mind, request.of));
  if (request.view == "why" && request.of.empty()) {
    WhyNode answer = WhyRecorded(*source.recorded->Find(agent), agent);
    if (const auto log = source.models->recalls.find(agent); log != source.models->recalls.end())
      TellRecalls(log->second, answer);
    return Both(answer);
  }
  if (request.view == "why") {
    if (const std::optional<WhyNode> command = WhyRecordedCommand(*source.recorded->Find(agent), request.of))
      return Both(*command);
    if (const std::optional<WhyNode> op = WhyOperator(*mind, request.of)) return Both(*op);
    return NewProblem("nothing is recorded of '" + request.of + "' at this moment",
                      "`soarbox why FILE " + request.of + "` simulates the run again");
  }
  return NewProblem("the view " + request.view + " shows nothing that is recorded", "simulate the run again for it");
}

/// Shows what scripts show of their agents (Agent.Show): for one agent, or for all that have such data.
Result<ViewText> ShowStates(const record::TickRecord& last, const std::string& agent) {
  ViewText view;
  Json json = Json::array();
  for (const world::AgentSnapshot& one : last.scene.agents) {
    if (one.shown.empty() || (!agent.empty() && one.name != agent)) continue;
    ShownView shown = LookAtShown(last.scene, one.name);
    shown.tick = last.tick;
    view.text += one.name + "\n" + ToText(shown);
    json.push_back(ToJson(shown));
  }
  if (view.text.empty()) view.text = "no script shows anything: agent:Show(\"state\", \"patrol\")\n";
  view.json = Print(json);
  return view;
}

Result<ViewText> ShowRun(const ViewSource& source, const ViewRequest& request, const std::string& agent) {
  const RunModels& models = *source.models;
  const auto within = [&](std::uint64_t tick) { return tick >= request.first_tick && tick <= request.last_tick; };
  if (request.view == "agents") {
    std::vector<AgentRow> rows = source.simulation != nullptr
                                     ? ListAgents(*source.simulation, models.troubles, &models.timeline)
                                     : ListAgents(*source.last, models.timeline, models.troubles);
    std::erase_if(rows, [&](const AgentRow& row) { return !Passes(request.of, TextOf(row)); });
    return Both(rows);
  }
  if (request.view == "state") return ShowStates(*source.last, request.agent);
  if (request.view == "messages") {
    std::vector<MessageRow> rows = models.messages.Find(request.agent, request.of);
    std::erase_if(rows, [&](const MessageRow& row) { return !within(row.tick); });
    return Both(rows);
  }
  if (request.view == "trace") {
    std::vector<const TraceLine*> lines = models.trace.Find({TraceKind::kElement, request.agent, request.of});
    std::erase_if(lines, [&](const TraceLine* line) { return !within(line->tick); });
    return Both(lines);
  }
  if (request.view == "plots") {
    std::vector<PlotSeries> series = models.plots.series();
    for (PlotSeries& one : series)
      std::erase_if(one.points, [&](const PlotPoint& point) { return !within(point.tick); });
    return Both(series);
  }
  return Both(TracksWithin(models.timeline, request.agent.empty() ? agent : request.agent, request.first_tick,
                           request.last_tick));
}

}  // namespace

std::span<const ViewInfo> Views() {
  return kViews;
}

Result<ViewText> ShowView(const ViewSource& source, const ViewRequest& request) {
  const auto view = std::ranges::find(kViews, request.view, &ViewInfo::name);
  if (view == std::end(kViews)) {
    std::vector<std::string> names;
    for (const ViewInfo& info : kViews) names.emplace_back(info.name);
    return NoSuch("view", request.view, names);
  }
  if (request.of.empty() && !view->of.empty() && !view->of.starts_with('['))
    return NewProblem("the view " + request.view + " needs a name",
                      "--view \"" + request.view + " " + std::string(view->of) + "\"");
  std::vector<std::string> names, minds;
  for (const world::AgentSnapshot& agent : source.last->scene.agents) {
    names.push_back(agent.name);
    if (source.simulation != nullptr && source.simulation->HasMind(agent.name)) minds.push_back(agent.name);
  }
  if (!request.agent.empty() && std::ranges::find(names, request.agent) == names.end())
    return NoSuch("agent", request.agent, names);
  const std::string agent = request.agent.empty() && !minds.empty() ? minds.front() : request.agent;
  if (!view->needs_mind) return ShowRun(source, request, request.view == "timeline" ? request.agent : agent);
  if (source.simulation == nullptr) return ShowRecorded(source, request, request.agent);
  const std::unique_ptr<explain::Inspector> mind = source.simulation->Inspect(agent);
  if (mind == nullptr) {
    if (std::ranges::find(minds, agent) != minds.end())
      return NewProblem("the agent " + agent + " does not exist at this moment",
                        "it was destroyed before; --at names an earlier moment");
    return minds.empty() ? NewProblem("no agent of this run has a Soar mind", "")
                         : NoSuch("agent with a Soar mind named", agent, minds);
  }
  return ShowMind(source, request, *mind, agent);
}

}  // namespace soarbox::debugger
